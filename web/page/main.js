// The lab: rooms behind tabs, each begun when it is first entered; the offline cache.

import * as chain from "./chain.js";
import * as claims from "./claims.js";
import * as classroom from "./classroom.js";
import { everything } from "./compiled.js";
import { $ } from "./dom.js";
import * as state from "./state.js";
import * as table from "./table.js";

const ROOMS = new Map([["chain", chain], ["table", table], ["claims", claims], ["classroom", classroom]]);
const TITLES = new Map([["chain", "Chain"], ["table", "Table"], ["claims", "Claims"], ["classroom", "Classroom"]]);
const begun = new Set();
const tabs = [...ROOMS.keys()].map((name) => $(`tab-${name}`));

function enter(name) {
  document.title = `${TITLES.get(name)} – Carom lab`;
  for (const tab of tabs) {
    const here = tab.id === `tab-${name}`;
    tab.setAttribute("aria-selected", String(here));
    tab.tabIndex = here ? 0 : -1;
    $(tab.getAttribute("aria-controls")).hidden = !here;
  }
  if (!begun.has(name)) {
    begun.add(name);
    ROOMS.get(name).start();
  }
}

const wanted = () => (ROOMS.has(state.get("room", "chain")) ? state.get("room", "chain") : "chain");

for (const tab of tabs) {
  const go = () => {
    const name = tab.id.slice(4);
    state.step({ room: name, show: "" }, { room: "chain" });
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
// Links into the classroom leave the other rooms as they are.
for (const link of document.querySelectorAll("[data-show]")) {
  link.addEventListener("click", (event) => {
    event.preventDefault();
    state.step({ room: "classroom", show: link.dataset.show }, { room: "chain" });
    enter("classroom");
    classroom.reveal();
  });
}
// In a page of somebody else's the room stands alone.
document.documentElement.classList.toggle("embedded", new URLSearchParams(location.search).has("embed"));
state.onRestore(() => enter(wanted()));
enter(wanted());

if ("serviceWorker" in navigator) {
  addEventListener("load", async () => {
    try {
      // What the page needs now comes first; the cache asks for what has come already without fetching it again.
      await everything();
      await navigator.serviceWorker.register("sw.js");
      await navigator.serviceWorker.ready;
      $("offline").textContent = "The lab is kept for use offline.";
      document.documentElement.dataset.offline = "ready";
    } catch {
      $("offline").textContent = "This browser does not keep the lab for use offline.";
    }
  });
}
