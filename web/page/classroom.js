// The room of the classroom: worksheets, the check of a pupil's table, restitution from bounces, and the words.

import { Client, clientWith } from "./client.js";
import { $, announce, later, make, outdated, save, sentence, showFault } from "./dom.js";
import { shape } from "./graph.js";
import { markdown } from "./markdown.js";
import { decimal } from "./numbers.js";
import * as state from "./state.js";

/** The tools of the room: the prefix of their fields, what these hold at the beginning, and the engine's function. */
const TOOLS = {
  sheet: {
    prefix: "w", call: "worksheet", show: showSheets, results: ["sheets"],
    beginning: { kind: "chain", masses: "2; 1; 0.5", e: "0.8", velocity: "3", floor: "0.9", height: "", mass_unit: "kg",
      velocity_unit: "m/s", height_unit: "m", title: "", about: "", sheet: "both", versions: "0", seed: "1",
      digits: "4", paper: "a4", exact: "", standard: "" },
  },
  check: {
    prefix: "p", call: "check_table", show: showChecked, results: ["checked", "checked-summary"],
    beginning: { table: "m1;m2;e;n;eta\n64;1;0,9;2;0,1927\n64;1;0,9;3;0,1937\n10;1;1;1;0,5\n10;1;1;2;\n", ratio: "", e: "", n: "", round: "nearest" },
  },
  bounce: {
    prefix: "b", call: "restitution", show: showBounced, results: ["bounced"],
    beginning: { kind: "heights", within: "0.01", readings: "1.20\n0.77\n0.49\n0.31\n", digits: "4" },
  },
};
/** What stands on the lines of each kind. */
const READINGS = { heights: "the height of the fall, then of each bounce", times: "the time of each flight between two bounces", pairs: "the height of a fall; that of its bounce" };
const ENDINGS = { pdf: ["pdf", "application/pdf"], html: ["html", "text/html"], latex: ["tex", "application/x-tex"], markdown: ["md", "text/markdown"] };
/** The parts of the documentation that are shown here. */
const GUIDES = [["guide", "guide-text", "classroom.md"], ["guide-numbers", "guide-numbers-text", "numbers.md"]];

const saver = new Client();

function fields({ prefix, beginning }) {
  return Object.fromEntries(Object.keys(beginning).map((key) => {
    const input = $(`${prefix}-${key}`);
    return [key, input.type === "checkbox" ? (input.checked ? "yes" : "") : input.value];
  }));
}

function restore({ prefix, beginning }) {
  for (const [key, value] of Object.entries(beginning)) {
    const input = $(`${prefix}-${key}`), kept = state.get(`${prefix}.${key}`, value);
    if (input.type === "checkbox") input.checked = kept === "yes";
    else input.value = kept;
    if (!input.value && input.tagName === "SELECT") input.value = value;
  }
}

/** Only the fields of the scene that is chosen. */
function layout() {
  const kind = $("w-kind").value;
  for (const field of document.querySelectorAll("#sheet-form [data-kinds]")) field.hidden = !field.dataset.kinds.split(" ").includes(kind);
  document.querySelector('label[for="w-masses"]').textContent = kind === "drop" ? "Masses, lowest to highest" : "Masses, first to last";
  document.querySelector('label[for="w-e"]').textContent = kind === "drop" ? "Restitution between balls" : "Restitution e";
  document.querySelector('label[for="b-readings"]').textContent = `Readings, one a line: ${READINGS[$("b-kind").value]}`;
}

async function ask(name) {
  const tool = TOOLS[name];
  const request = fields(tool);
  const named = (values) => Object.fromEntries(Object.entries(values).map(([key, value]) => [`${tool.prefix}.${key}`, value]));
  state.keep(named(request), named(tool.beginning));
  const found = await tool.engine.ask(tool.call, request);
  if (!found) return;
  if (found.error) found.error.help ??= separation(request[found.error.field] ?? "", found.error.field);
  showFault($(`${name}-form`), $(`${name}-error`), found.error);
  for (const id of tool.results) outdated($(id), Boolean(found.error));
  for (const button of document.querySelectorAll(name === "sheet" ? "[data-sheet-form], #sheets-print" : "none")) button.disabled = Boolean(found.error);
  if (found.error) announce(sentence(found.error));
  else tool.show(found);
}

/** What is to be written where several numbers stand without what separates them in a field. */
function separation(text, field) {
  const numbers = text.split("\n").map((line) => line.trim().split(/[;,]?\s+|;/)).find((line) => line.length > 1);
  if (!numbers?.every((number) => /^[\d.,/]+$/.test(number))) return null;
  return field === "readings" ? "write one reading a line" : `separate numbers by semicolons: ${numbers.join("; ")}`;
}

/** A number of a sheet: a true minus sign, a power of ten raised. */
const number = (text) => (text.includes("±") ? text.replaceAll("-", "−") : decimal(text, false));

function tableOf({ title, columns, groups }) {
  const cell = (text) => (text === null ? make("td", {})
    : text === "" ? make("td", { class: "blank" }, make("span", { class: "visually-hidden" }, "to be filled in"))
      : make("td", {}, number(text)));
  return make("div", { class: "scroll" }, make("table", {},
    title ? make("caption", {}, title) : null,
    make("thead", {}, make("tr", {}, make("td", {}), columns.map((name) => make("th", { scope: "col" }, name)))),
    groups.map((rows) => make("tbody", {}, rows.map((row) => make("tr", {}, make("th", { scope: "row" }, row.name), row.cells.map(cell)))))));
}

/** The bodies before the first collision, from the strokes of the engine. */
function sketchOf({ size: [width, height], text, strokes }) {
  const picture = shape("svg", { class: "sketch", role: "img", "aria-label": text, viewBox: `-1 -1 ${width + 2} ${height + 2}` });
  picture.append(...strokes.map(({ points, at, text: label, size }) => (points
    ? shape("polyline", { points: points.map((point) => point.join(",")).join(" ") })
    : shape("text", { x: at[0], y: at[1] + 0.36 * size, "font-size": size }, label))));
  return picture;
}

const PARTS = {
  names: () => make("p", { class: "names" }, ["Name", "Class", "Date"].map((word) => make("span", {}, `${word} `))),
  heading: ({ text }) => make("h4", {}, text),
  text: ({ text }) => make("p", {}, text),
  sketch: sketchOf,
  choice: ({ ask: question, options }) => make("div", { class: "choice" }, make("p", {}, question),
    make("ul", {}, options.map(([text, right]) => make("li", {}, make("span", { "aria-hidden": "true" }, right ? "☒ " : "☐ "), text,
      right ? make("span", { class: "visually-hidden" }, " (right)") : null)))),
  open: ({ ask: question, answer, lines }) => make("div", { class: "open" }, make("p", {}, question),
    answer ? make("p", { class: "answer" }, answer) : Array.from({ length: lines }, () => make("div", { class: "line" }))),
  table: tableOf,
};

function showSheets({ sheets }) {
  $("sheets").replaceChildren(...sheets.map(({ title, foot, parts }) => make("article", { class: "sheet" },
    make("h3", {}, title), parts.map((part) => PARTS[part.kind](part)), make("p", { class: "foot" }, foot))));
}

/** The columns as a telephone shows them: what is said of a cell beside its line. */
const ORDER = ["line", "judgement", "written", "certified", "quantity", "ratio", "e", "n"];

function showChecked({ columns, cells, summary, right }) {
  const places = ORDER.map((name) => columns.indexOf(name));
  $("checked-summary").textContent = `${summary}.`;
  $("checked-summary").className = right ? "said good" : "said bad";
  $("checked").replaceChildren(
    make("thead", {}, make("tr", {}, ORDER.map((name) => make("th", { scope: "col" }, name)))),
    make("tbody", {}, cells.map(({ entries, mark }) => make("tr", { class: mark }, places.map((place) => make("td", {}, entries[place]))))));
}

function showBounced({ said, consistent }) {
  // The engine names the flag of the command line.
  const [first, ...rest] = said.map((line) => line.replace("give one with --within", "fill in \"Each reading is within ±\""));
  $("bounced").replaceChildren(make("p", { class: `said ${consistent ? "good" : "bad"}` }, first), ...rest.map((line) => make("p", {}, line)));
}

async function download(form) {
  const [ending, type] = ENDINGS[form];
  const found = await saver.ask("worksheet", { ...fields(TOOLS.sheet), format: form });
  if (!found) return;
  if (found.error) {
    $("sheets-note").textContent = sentence(found.error);
    return;
  }
  save(found.text ?? Uint8Array.from(atob(found.base64), (c) => c.charCodeAt(0)), `worksheet.${ending}`, type);
}

/** Prints the sheets alone, each on a page of its own. */
function print() {
  document.body.classList.add("only-sheets");
  addEventListener("afterprint", () => document.body.classList.remove("only-sheets"), { once: true });
  globalThis.print();
}

async function readGuide(box, file) {
  if (box.childElementCount) return;
  const response = await fetch(file);
  box.replaceChildren(...(response.ok ? markdown(await response.text()) : [make("p", {}, `${file} is not here`)]));
}

/** What a link points at: the glossary, or the guide. */
export function reveal() {
  const place = state.get("show", "");
  if (!["glossary", "guide"].includes(place)) return;
  if (place === "guide") $("guide").open = true;
  $(place).scrollIntoView();
}

export function start() {
  for (const [name, tool] of Object.entries(TOOLS)) {
    tool.engine = clientWith($(`${name}-busy`));
    const soon = later(() => ask(name), 200);
    $(`${name}-form`).addEventListener("input", (event) => {
      layout();
      if (event.target.type !== "file") soon();
    });
    $(`${name}-form`).addEventListener("submit", (event) => event.preventDefault());
  }
  for (const [file, text, name] of [["p-file", "p-table", "check"], ["b-file", "b-readings", "bounce"]]) {
    $(file).addEventListener("change", async () => {
      const [chosen] = $(file).files;
      if (!chosen) return;
      $(text).value = await chosen.text();
      ask(name);
    });
  }
  for (const button of document.querySelectorAll("[data-sheet-form]")) {
    button.addEventListener("click", () => download(button.dataset.sheetForm));
  }
  $("sheets-print").addEventListener("click", print);
  for (const [details, box, file] of GUIDES) $(details).addEventListener("toggle", () => readGuide($(box), file));
  const all = () => {
    for (const tool of Object.values(TOOLS)) restore(tool);
    layout();
    return Promise.all(Object.keys(TOOLS).map(ask));
  };
  state.onRestore(async () => { await all(); reveal(); });
  return all().then(reveal);
}
