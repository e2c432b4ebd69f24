// The bodies on their line, moved by the exact replay.
//
// The engine gives the corners of every worldline as doubles; between two corners a body moves in a straight line.
// Arrows and bars have lengths from doubles, too. The numbers in words are the engine's, exact or certified.

import { $, announce, make } from "./dom.js";
import * as graph from "./graph.js";
import { colour, shape } from "./graph.js";
import { written } from "./numbers.js";

/** Seconds of a replay at speed 1, and between two rounds. */
const SECONDS = 7;
const PAUSE = 0.8;
/** The height of the lane for arrows above the bodies. */
const LANE = 16;
const still = matchMedia("(prefers-reduced-motion: reduce)");

/** What holds the table of the numbers of each body. */
const table = $("now").closest("details");

let data = null;
/** What graph.history makes of it. */
let states = [];
let all = false;
let now = 0;
let playing = false;
let last = 0;
let resting = 0;
let discs = [];
let arrows = [];
let centre = null;
let across = (x) => x;
let state = { past: -1 };
let sounds = null;
/** Hears of a body that was dragged, and how far. */
let moved = () => {};

/** When the struck pairs have all met once: the end of the pass. */
function passEnd() {
  const first = new Map();
  for (const c of data.events) if (c.of_the_pass) first.set(c.last, c.drawn_time);
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

const sum = (list) => list.reduce((all, x) => all + x, 0);

/** The largest velocity, and momentum to one side, that is to be drawn. */
function extremes() {
  let [speed, left, right] = [0, 0, 0];
  for (const { velocities, momenta } of states.slice(0, 401)) {
    speed = Math.max(speed, ...velocities.map(Math.abs));
    right = Math.max(right, sum(momenta.filter((p) => p > 0)));
    left = Math.max(left, -sum(momenta.filter((p) => p < 0)));
  }
  return { speed: speed || 1, left, right, whole: sum(states[0].energies) || 1 };
}

function build() {
  const stage = $("stage");
  const width = Math.max(stage.clientWidth, 280);
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
  const walls = data.drawn.walls;
  from = walls[0] === null ? from - room : walls[0] - room / 4;
  to = walls[1] === null ? to + room * 2 : walls[1] + room / 4;
  const unit = width / (to - from);
  across = (x) => (x - from) * unit;
  const largest = Math.max(...half) * unit;
  const lane = $("arrows").checked ? LANE : 4;
  const rail = lane + Math.max(largest, 6) + 2;
  const height = rail + Math.max(largest, 6) + 20;
  stage.setAttribute("viewBox", `0 0 ${width} ${height}`);
  stage.style.height = `${height}px`;
  stage.replaceChildren(shape("line", { x1: 0, x2: width, y1: rail, y2: rail, class: "rail" }));
  for (const [side, x] of walls.entries()) {
    if (x !== null) stage.append(shape("rect", { x: across(x) - (side ? 0 : 5), y: 0, width: 5, height: height - 16, class: "wall" }));
  }
  arrows = [];
  // Numbers as long as there is room for them.
  const numbered = width / worldlines.length >= 16;
  discs = worldlines.map((_, i) => {
    const radius = Math.max(half[i] * unit, 3);
    const group = shape("g", {});
    const circle = shape("circle", { cy: rail, r: radius, fill: colour(i), class: "body" });
    circle.addEventListener("pointerdown", (event) => drag(event, i, unit));
    group.append(circle);
    if (numbered) group.append(shape("text", { y: height - 4, class: "body-number" }, String(i + 1)));
    const arrow = shape("path", { class: "arrow", stroke: colour(i), fill: colour(i) });
    arrow.toggleAttribute("hidden", !$("arrows").checked);
    group.append(arrow);
    arrows.push(arrow);
    stage.append(group);
    return group;
  });
  centre = $("centre").checked && data.drawn.centre ? shape("path", { class: "centre", d: `M0 ${rail - 9}l6 9l-6 9l-6 -9z` }) : null;
  if (centre) stage.append(centre);
  state = { past: -1, most: extremes(), longest: Math.min(70, width / 6) };
  graph.build(data, states, stop());
  draw();
}

/** Drags a body to another place before the start, no farther than to its neighbours and the walls. */
function drag(down, body, unit) {
  if (now > 0 || playing || down.button !== 0) return;
  down.preventDefault();
  const { gaps, room } = data.drawn;
  const free = (gap, wall) => gap ?? wall ?? Infinity;
  const [least, most] = [-free(gaps[body - 1], room[0]), free(gaps[body], room[1])];
  const from = place(data.drawn.worldlines[body], 0);
  const target = down.currentTarget;
  // The picture is as wide as its box, whatever the zoom.
  const scale = unit * ($("stage").getBoundingClientRect().width / Math.max($("stage").clientWidth, 280));
  let by = 0;
  target.setPointerCapture(down.pointerId);
  target.classList.add("dragged");
  const follow = (event) => {
    by = Math.min(Math.max((event.clientX - down.clientX) / scale, least), most);
    discs[body].setAttribute("transform", `translate(${across(from + by).toFixed(2)} 0)`);
  };
  const end = (event) => {
    for (const [name, work] of Object.entries(hears)) target.removeEventListener(name, work);
    target.classList.remove("dragged");
    if (event.type === "pointerup" && Math.abs(by) >= 0.005) moved(body, by);
    else draw();
  };
  const hears = { pointermove: follow, pointerup: end, pointercancel: end };
  for (const [name, work] of Object.entries(hears)) target.addEventListener(name, work);
}

/** Who hears of a body that was dragged. */
export const onDrag = (work) => { moved = work; };

/** The arrow of a velocity: its length from the engine's double. */
function arrowPath(v) {
  const length = (v / state.most.speed) * state.longest;
  if (Math.abs(length) < 0.5) return "";
  const y = LANE / 2, sign = Math.sign(length);
  const tip = Math.max(Math.abs(length), 5) * sign;
  return `M0 ${y - 1}H${tip - 4 * sign}V${y - 4}L${tip} ${y}L${tip - 4 * sign} ${y + 4}V${y + 1}H0z`;
}

/** Bars of kinetic energy and momentum, one piece for each body. */
function bars({ energies, momenta }) {
  const box = $("bars");
  // A little less than the box, for the mark at the end.
  const width = Math.max(box.clientWidth, 280) - 6;
  const piece = (x, y, w, i, more = {}) => shape("rect", {
    x: x.toFixed(2), y, width: Math.max(w, 0).toFixed(2), height: 16, fill: colour(i), class: "piece", ...more });
  const { whole, left, right } = state.most;
  const parts = [shape("text", { x: 0, y: 12, class: "bar-name" }, "kinetic energy, and heat of the collisions so far")];
  let x = 0;
  energies.forEach((energy, i) => {
    const w = (energy / whole) * width;
    parts.push(piece(x, 17, w, i));
    x += w;
  });
  if (width - x > 0.5) parts.push(piece(x, 17, width - x, 0, { fill: "", class: "piece heat" }));
  const scale = width / (left + right || 1);
  const zero = left * scale;
  parts.push(shape("text", { x: 0, y: 52, class: "bar-name" }, left > 0 ? "momentum, to the left and to the right of the line at 0" : "momentum"));
  let [low, high] = [zero, zero];
  momenta.forEach((p, i) => {
    const w = Math.abs(p) * scale;
    if (p < 0) low -= w;
    parts.push(piece(p < 0 ? low : high, 57, w, i));
    if (p > 0) high += w;
  });
  const total = zero + sum(momenta) * scale;
  if (left > 0) parts.push(shape("line", { x1: zero, x2: zero, y1: 54, y2: 76, class: "zero" }));
  parts.push(shape("path", { d: `M${total} 74l4 6h-8z`, class: "total" }),
    shape("text", { x: Math.min(Math.max(total, 40), width - 40), y: 92, class: "bar-name middle" }, "sum of all"));
  box.setAttribute("viewBox", `0 0 ${width + 6} 96`);
  box.replaceChildren(...parts);
}

function tick() {
  if (!$("sound").checked) return;
  sounds ??= new AudioContext();
  const tone = sounds.createOscillator(), volume = sounds.createGain();
  tone.frequency.value = 660;
  volume.gain.setValueAtTime(0.15, sounds.currentTime);
  volume.gain.exponentialRampToValueAtTime(0.001, sounds.currentTime + 0.06);
  tone.connect(volume).connect(sounds.destination);
  tone.start();
  tone.stop(sounds.currentTime + 0.07);
}

function draw() {
  if (!data) return;
  data.drawn.worldlines.forEach((corners, i) => {
    discs[i].setAttribute("transform", `translate(${across(place(corners, now)).toFixed(2)} 0)`);
  });
  if (centre) {
    const [x, v] = data.drawn.centre;
    centre.setAttribute("transform", `translate(${across(x + v * now).toFixed(2)} 0)`);
  }
  graph.move(now);
  $("time").value = String(Math.round((1000 * now) / stop()));
  $("clock").textContent = `t = ${now.toFixed(2)}`;
  const past = data.events.filter((c) => c.drawn_time <= now * (1 + 1e-12)).length;
  if (state.past === past) return;
  if (past === state.past + 1 && past > 0 && playing) tick();
  state.past = past;
  $("time").setAttribute("aria-valuetext", progress(past));
  $("event").replaceChildren(...words(past));
  if (playing || document.activeElement?.closest("#player")) announce($("event").textContent);
  const shown = states[past];
  arrows.forEach((arrow, i) => arrow.setAttribute("d", arrowPath(shown.velocities[i])));
  if ($("ledger").checked) bars(shown);
  if (table.open) graph.numbers(shown);
}

/** How far the replay is; infinitely many collisions at once, after which bodies move on together, are one step. */
const progress = (past) => data.events.some((c) => c.joined)
  ? `${past} of ${data.events.length} steps (${data.total}).` : `${past} of ${data.total}.`;

/** Who collides, as a sentence begins. */
function meeting(pair) {
  if (!pair.includes("wall")) return `Bodies ${pair}`;
  const named = pair.split("–").map((one) => (one.includes("wall") ? `the ${one}` : `body ${one}`)).join(" and ");
  return named[0].toUpperCase() + named.slice(1);
}

/** The last collision in words, with its exact numbers. */
function words(past) {
  const count = make("strong", {}, `${progress(past)} `);
  if (past === 0) return [count, data.events.length ? "Nothing has collided yet." : `This replay has no collision: ${data.end}.`];
  const c = data.events[past - 1];
  if (c.joined) {
    return [count, `Bodies ${c.pair} at t ${c.time.approximate ? "" : "= "}`, written(c.time), ": infinitely many collisions. They move on together with velocity ",
      written(c.after[0]), ". Heat: ", written(c.lost), "."];
  }
  return [count, `${meeting(c.pair)} at t ${c.time.approximate ? "" : "= "}`, written(c.time), ": velocities ", written(c.before[0]), ", ", written(c.before[1]),
    " become ", written(c.after[0]), ", ", written(c.after[1]), ". Heat: ", written(c.lost),
    c.of_the_pass || c.pair.includes("wall") ? "." : make("em", {}, ". They meet again.")];
}

function frame(stamp) {
  if (!playing || !data) return;
  if (still.matches) {
    // No motion: from collision to collision, one a second.
    if (stamp - last >= 1000 / Number($("speed").value)) {
      last = stamp;
      if (now >= stop() && $("loop").checked) {
        now = 0;
        draw();
      } else step(1, true);
    }
  } else {
    const seconds = (stamp - last) / 1000;
    last = stamp;
    if (now >= stop()) {
      resting += seconds;
      if (!$("loop").checked) setPlaying(false);
      else if (resting > PAUSE) now = 0;
    } else {
      resting = 0;
      now = Math.min(stop(), now + (seconds / SECONDS) * Number($("speed").value) * stop());
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
  if (next === undefined && !$("loop").checked) setPlaying(false);
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
  states = replay ? graph.history(replay) : [];
  for (const part of ["stage", "player", "event", "views", "options", "motion"]) $(part).toggleAttribute("hidden", !replay);
  $("bars").toggleAttribute("hidden", !replay || !$("ledger").checked);
  // Until the first replay is there, a press of a button would do nothing.
  $("player").disabled = !replay;
  if (!replay) {
    setPlaying(false);
    return;
  }
  now = playing && before ? (now / (before.drawn.end || 1)) * data.drawn.end : 0;
  now = Math.min(now, stop());
  $("stage").setAttribute("aria-label", `${data.masses.length} bodies on a line, ${data.total}`);
  build();
}

/** Plays from the beginning. */
export function play() {
  now = 0;
  setPlaying(true);
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
for (const id of ["arrows", "centre", "ledger", "curve"]) {
  $(id).addEventListener("change", () => {
    $("bars").toggleAttribute("hidden", !data || !$("ledger").checked);
    if (data) build();
  });
}
table.addEventListener("toggle", () => { if (data) build(); });
let seen = "";
const resized = new ResizeObserver(() => {
  // A change of height alone is build's own.
  const widths = `${$("stage").clientWidth} ${$("bars").clientWidth}`;
  if (data && $("stage").clientWidth && widths !== seen) build();
  seen = widths;
});
resized.observe($("stage"));
resized.observe($("bars"));
