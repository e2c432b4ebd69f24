// The lab: rooms behind tabs, each begun when it is first entered; the offline cache.

import * as chain from "./chain.js";
import * as claims from "./claims.js";
import { $ } from "./dom.js";
import * as state from "./state.js";
import * as table from "./table.js";

const ROOMS = { chain, table, claims };
const begun = new Set();
const tabs = Object.keys(ROOMS).map((name) => $(`tab-${name}`));

function enter(name) {
  for (const tab of tabs) {
    const here = tab.id === `tab-${name}`;
    tab.setAttribute("aria-selected", String(here));
    tab.tabIndex = here ? 0 : -1;
    $(tab.getAttribute("aria-controls")).hidden = !here;
  }
  if (!begun.has(name)) {
    begun.add(name);
    ROOMS[name].start();
  }
}

const wanted = () => (state.get("room", "chain") in ROOMS ? state.get("room", "chain") : "chain");

for (const tab of tabs) {
  const go = () => {
    const name = tab.id.slice(4);
    state.keep({ room: name }, { room: "chain" });
    enter(name);
  };
  tab.addEventListener("click", go);
  tab.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const next = tabs[(tabs.indexOf(tab) + step + tabs.length) % tabs.length];
    next.focus();
    next.click();
  });
}
state.onRestore(() => enter(wanted()));
enter(wanted());

if ("serviceWorker" in navigator) {
  addEventListener("load", async () => {
    try {
      await navigator.serviceWorker.register("sw.js");
      await navigator.serviceWorker.ready;
      $("offline").textContent = "The lab is kept for use offline.";
      document.documentElement.dataset.offline = "ready";
    } catch {
      $("offline").textContent = "This browser does not keep the lab for use offline.";
    }
  });
}
