// The bodies on their line, moved by the exact replay.
//
// The engine gives the corners of every worldline as doubles; between two corners a body moves in a straight line.
// The numbers in words below the picture are the engine's, exact or certified.

import { $, make } from "./dom.js";
import { written } from "./numbers.js";

const SVG = "http://www.w3.org/2000/svg";
const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#777777"];
const WIDTH = 900;
const SECONDS = 7;
const still = matchMedia("(prefers-reduced-motion: reduce)");

let data = null;
let all = false;
let now = 0;
let playing = false;
let last = 0;
let discs = [];
let across = (x) => x;

const shape = (name, attributes, text) => {
  const node = document.createElementNS(SVG, name);
  for (const key in attributes) node.setAttribute(key, attributes[key]);
  if (text) node.textContent = text;
  return node;
};

/** When the struck pairs have all met once: the end of the pass. */
function passEnd() {
  const first = new Map();
  for (const c of data.events) if (!first.has(c.left)) first.set(c.left, c.drawn_time);
  return Math.max(0, ...first.values());
}

const stop = () => (all ? data.drawn.end : Math.min(data.drawn.end, passEnd() * 1.15 || 1));

function place(corners, t) {
  let low = 0, high = corners.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (corners[middle][0] <= t) low = middle; else high = middle;
  }
  const [t0, x0] = corners[low], [t1, x1] = corners[high];
  return t1 > t0 ? x0 + (x1 - x0) * Math.min(1, (t - t0) / (t1 - t0)) : x1;
}

function build() {
  const stage = $("stage");
  const { worldlines, half } = data.drawn;
  // The window: where the bodies are until the end, as far as they have not flown off.
  const end = stop();
  let [from, to] = [Infinity, -Infinity];
  const until = all ? Math.max(0, ...data.events.map((c) => c.drawn_time)) : passEnd();
  worldlines.forEach((corners, i) => {
    for (const t of [0, ...corners.map((c) => c[0]).filter((t) => t <= until), Math.min(until, end)]) {
      const x = place(corners, t);
      from = Math.min(from, x - half[i]);
      to = Math.max(to, x + half[i]);
    }
  });
  const room = Math.max((to - from) * 0.05, 0.3);
  from -= room;
  to += room * 2;
  const unit = WIDTH / (to - from);
  across = (x) => (x - from) * unit;
  const largest = Math.max(...half) * unit;
  const height = Math.max(70, 2 * largest + 44);
  const ground = height - 22;
  stage.setAttribute("viewBox", `0 0 ${WIDTH} ${height}`);
  stage.replaceChildren(shape("line", { x1: 0, x2: WIDTH, y1: ground - largest, y2: ground - largest, class: "rail" }));
  discs = worldlines.map((_, i) => {
    const radius = Math.max(half[i] * unit, 3);
    const group = shape("g", {});
    group.append(shape("circle", { cy: ground - largest, r: radius, fill: COLOURS[i % COLOURS.length], class: "body" }));
    if (worldlines.length <= 14) group.append(shape("text", { y: height - 4, class: "body-number" }, String(i + 1)));
    stage.append(group);
    return group;
  });
  draw();
}

function draw() {
  if (!data) return;
  data.drawn.worldlines.forEach((corners, i) => {
    discs[i].setAttribute("transform", `translate(${across(place(corners, now)).toFixed(2)} 0)`);
  });
  $("time").value = String(Math.round((1000 * now) / stop()));
  const past = data.events.filter((c) => c.drawn_time <= now * (1 + 1e-12)).length;
  $("time").setAttribute("aria-valuetext", `${past} of ${data.count} collisions`);
  if ($("event").dataset.past !== `${past}`) {
    $("event").dataset.past = `${past}`;
    $("event").replaceChildren(...words(past));
  }
}

/** The last collision in words, with its exact numbers. */
function words(past) {
  const count = make("strong", {}, `${past} of ${data.count} collision${data.count === 1 ? "" : "s"}. `);
  if (past === 0) return [count, "Body 1 is on its way."];
  const c = data.events[past - 1];
  return [count, `Bodies ${c.pair} at t = `, written(c.time), ": velocities ", written(c.before[0]), ", ", written(c.before[1]),
    " become ", written(c.after[0]), ", ", written(c.after[1]), c.of_the_pass ? "." : make("em", {}, " — they meet again.")];
}

function frame(stamp) {
  if (!playing || !data) return;
  if (still.matches) {
    // No motion: from collision to collision, one a second.
    if (stamp - last >= 1000) {
      last = stamp;
      step(1, true);
    }
  } else {
    now += ((stamp - last) / 1000 / SECONDS) * stop();
    last = stamp;
    if (now >= stop()) {
      now = stop();
      setPlaying(false);
    }
    draw();
  }
  requestAnimationFrame(frame);
}

function setPlaying(on) {
  playing = on && data !== null;
  $("play").textContent = playing ? "Pause" : "Play";
  if (playing) {
    if (now >= stop()) now = 0;
    last = performance.now();
    requestAnimationFrame(frame);
  }
}

function step(direction, keep = false) {
  if (!data) return;
  if (!keep) setPlaying(false);
  const times = [0, ...data.events.map((c) => c.drawn_time).filter((t) => t <= stop())];
  const near = 1e-9 * stop();
  const next = direction > 0 ? times.find((t) => t > now + near) : times.findLast((t) => t < now - near);
  if (next === undefined) setPlaying(false);
  now = next ?? (direction > 0 ? stop() : 0);
  draw();
}

function setAll(on) {
  all = on;
  $("view-all").setAttribute("aria-pressed", String(all));
  $("view-pass").setAttribute("aria-pressed", String(!all));
  if (!data) return;
  now = Math.min(now, stop());
  build();
}

/** Shows a replay, or nothing. */
export function show(replay) {
  const before = data;
  data = replay;
  $("event").dataset.past = "";
  for (const part of ["stage", "player", "event", "views"]) $(part).toggleAttribute("hidden", !replay);
  if (!replay) {
    setPlaying(false);
    return;
  }
  now = playing && before ? (now / (before.drawn.end || 1)) * data.drawn.end : 0;
  now = Math.min(now, stop());
  $("stage").setAttribute("aria-label", `${data.masses.length} bodies on a line, ${data.count} collisions`);
  build();
}

/** Shows all collisions instead of the pass. */
export const showAll = () => { setAll(true); setPlaying(true); };

$("play").addEventListener("click", () => setPlaying(!playing));
$("back").addEventListener("click", () => step(-1));
$("forward").addEventListener("click", () => step(1));
$("view-pass").addEventListener("click", () => setAll(false));
$("view-all").addEventListener("click", () => setAll(true));
$("time").addEventListener("input", () => {
  setPlaying(false);
  now = (Number($("time").value) / 1000) * stop();
  draw();
});
