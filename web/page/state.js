// What the page shows, in the fragment of its address: a link restores it, and Back returns to it.

import { later } from "./dom.js";

/** Longer texts are not put into a link. */
const LINKED = 6000;

const read = () => new URLSearchParams(location.hash.slice(1));
const state = read();
const listeners = [];

/** The value of a key, or another where there is none. */
export const get = (key, otherwise) => (state.has(key) ? state.get(key) : otherwise);

const address = () => (state.size ? `#${state}` : location.pathname + location.search);

function writeNow() {
  if (state.toString() !== read().toString()) history.replaceState(null, "", address());
}

// Browsers refuse addresses that change too often.
const write = later(writeNow, 200);
addEventListener("pagehide", writeNow);

function change(values, beginning) {
  for (const [key, value] of Object.entries(values)) {
    if (value === (beginning[key] ?? "") || value.length > LINKED) state.delete(key);
    else state.set(key, value);
  }
}

/** Keeps values; those that are as at the beginning are left out of the link. */
export function keep(values, beginning = {}) {
  change(values, beginning);
  write();
}

/** Keeps values as a step of its own: Back returns to what was before. */
export function step(values, beginning = {}) {
  writeNow();
  change(values, beginning);
  if (state.toString() !== read().toString()) history.pushState(null, "", address());
}

/** The address with all that is kept. */
export const link = () => `${location.origin}${location.pathname}${state.size ? `#${state}` : ""}`;

/** Calls a function when somebody goes back or follows a link to another state of this page. */
export const onRestore = (work) => listeners.push(work);

function restore() {
  for (const key of [...state.keys()]) state.delete(key);
  for (const [key, value] of read()) state.set(key, value);
  for (const work of listeners) work();
}

// Back and Forward fire popstate, also between addresses of which one has no fragment; so does a link within the page.
addEventListener("popstate", () => {
  if (state.toString() !== read().toString()) restore();
});
