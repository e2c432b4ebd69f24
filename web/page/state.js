// What the page shows, in the fragment of its address: a link restores it.

import { later } from "./dom.js";

const read = () => new URLSearchParams(location.hash.slice(1));
const state = read();
const listeners = [];

/** The value of a key, or another where there is none. */
export const get = (key, otherwise) => (state.has(key) ? state.get(key) : otherwise);

function writeNow() {
  const text = state.toString();
  if (text !== read().toString()) history.replaceState(null, "", text ? `#${text}` : location.pathname);
}

// Browsers refuse addresses that change too often.
const write = later(writeNow, 200);
addEventListener("pagehide", writeNow);

/** Keeps values; those that are as at the beginning are left out of the link. */
export function keep(values, beginning = {}) {
  for (const [key, value] of Object.entries(values)) {
    if (value === (beginning[key] ?? "")) state.delete(key);
    else state.set(key, value);
  }
  write();
}

/** The address with all that is kept. */
export const link = () => `${location.origin}${location.pathname}${state.size ? `#${state}` : ""}`;

/** Calls a function when somebody follows a link to another state of this page. */
export const onRestore = (work) => listeners.push(work);

addEventListener("hashchange", () => {
  for (const key of [...state.keys()]) state.delete(key);
  for (const [key, value] of read()) state.set(key, value);
  for (const work of listeners) work();
});
