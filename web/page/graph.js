// Place, velocity, momentum and kinetic energy of each body against time, and their numbers at the player's time.
//
// Curves and numbers come from the doubles of the replay; the numbers are rounded to four digits and say so.

import { $, make } from "./dom.js";

const SVG = "http://www.w3.org/2000/svg";
const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#777777"];
export const colour = (body) => COLOURS[body % COLOURS.length];
const HEIGHT = 170;
/** Room for the numbers of the bodies at the end of their curves, and for the text above and below. */
const [RIGHT, ABOVE, BELOW] = [22, 18, 20];

export const shape = (name, attributes, text) => {
  const node = document.createElementNS(SVG, name);
  for (const key in attributes) node.setAttribute(key, attributes[key]);
  if (text) node.textContent = text;
  return node;
};

/** Velocities, momenta and kinetic energies at the beginning and after each collision. */
export function history({ drawn: { start, masses }, events }) {
  const state = (velocities) => ({
    velocities,
    momenta: velocities.map((v, i) => masses[i] * v),
    energies: velocities.map((v, i) => (masses[i] * v * v) / 2),
  });
  const states = [state(start)];
  for (const c of events) {
    const velocities = [...states[states.length - 1].velocities];
    for (let body = c.first; body <= c.last; body++) {
      if (body - 1 in velocities) velocities[body - 1] = c.drawn_after[body === c.first ? 0 : 1];
    }
    states.push(state(velocities));
  }
  return states;
}

/** A double for the eye. */
const four = (x) => String(Number(x.toPrecision(4)) || 0).replace("-", "−");

/** The corners of the curve of a body: straight lines for places, steps for everything else. */
function curve(body, data, states, end, kind) {
  if (kind === "places") return data.drawn.worldlines[body];
  const points = [[0, states[0][kind][body]]];
  data.events.forEach((c, k) => {
    if (c.drawn_time > end || body + 1 < c.first || body + 1 > c.last) return;
    points.push([c.drawn_time, states[k][kind][body]], [c.drawn_time, states[k + 1][kind][body]]);
  });
  return [...points, [end, points[points.length - 1][1]]];
}

/** Up to the end and not beyond it. */
function cut(points, end) {
  const inside = points.filter(([t]) => t <= end);
  const [t0, y0] = inside[inside.length - 1], next = points[inside.length];
  return next ? [...inside, [end, y0 + ((next[1] - y0) * (end - t0)) / (next[0] - t0)]] : [...inside, [end, y0]];
}

let cursor = null;
let across = (t) => t;

/** Draws the curves of all bodies until a time. */
export function build(data, states, end) {
  const svg = $("graph");
  const choice = $("curve").selectedOptions[0];
  const curves = data.drawn.worldlines.map((_, body) => cut(curve(body, data, states, end, choice.value), end));
  const values = curves.flat().map(([, y]) => y);
  const [low, high] = [Math.min(0, ...values), Math.max(...values)];
  const width = Math.max(svg.clientWidth, 280);
  const span = high - low || 1;
  across = (t) => (t / end) * (width - RIGHT);
  const up = (y) => ABOVE + ((high - y) / span) * (HEIGHT - ABOVE - BELOW);
  const parts = [shape("line", { x1: 0, x2: width - RIGHT, y1: up(0), y2: up(0), class: "rail" })];
  const taken = [];
  curves.forEach((points, body) => {
    parts.push(shape("polyline", { points: points.map(([t, y]) => `${across(t).toFixed(1)},${up(y).toFixed(1)}`).join(" "), stroke: colour(body), class: "curve" }));
    // A number where there is room for it: curves that end together share the first one's place.
    const y = up(points[points.length - 1][1]);
    if (taken.some((other) => Math.abs(other - y) < 11)) return;
    taken.push(y);
    parts.push(shape("text", { x: width - RIGHT + 4, y: y + 4, class: "bar-name" }, String(body + 1)));
  });
  cursor = shape("line", { y1: ABOVE - 4, y2: HEIGHT - BELOW + 4, class: "zero" });
  parts.push(cursor, shape("text", { x: 0, y: 12, class: "bar-name" }, `${choice.textContent}, from ${four(low)} to ${four(high)}`),
    shape("text", { x: 0, y: HEIGHT - 4, class: "bar-name" }, `time, from 0 to ${four(end)}`));
  svg.setAttribute("viewBox", `0 0 ${width} ${HEIGHT}`);
  svg.setAttribute("aria-label", `Graph against time of each body: ${choice.textContent}`);
  svg.replaceChildren(...parts);
}

/** The time of the player. */
export function move(now) {
  const x = across(now).toFixed(1);
  cursor?.setAttribute("x1", x);
  cursor?.setAttribute("x2", x);
}

/** The numbers of each body after so many collisions. */
export function numbers({ velocities, momenta, energies }) {
  const swatch = (body) => {
    const mark = make("span", { class: "swatch", "aria-hidden": "true" });
    mark.style.background = colour(body);
    return mark;
  };
  const heads = ["Body", "Velocity", "Momentum", "Kinetic energy"];
  $("now").replaceChildren(
    make("thead", {}, make("tr", {}, heads.map((text) => make("th", { scope: "col" }, text)))),
    make("tbody", {}, velocities.map((v, i) => make("tr", {}, make("th", { scope: "row" }, swatch(i), String(i + 1)),
      [v, momenta[i], energies[i]].map((x) => make("td", {}, four(x)))))));
}
