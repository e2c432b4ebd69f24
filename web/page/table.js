// The room of tables.

import { Client, clientWith } from "./client.js";
import { $, later, make, outdated, save, sentence, showFault } from "./dom.js";
import * as state from "./state.js";

const BEGINNING = { want: "eta", ratio: "1,2,10,100", e: "0.5,0.9,1", n: "0:4:1", digits: "6", count: "significant", round: "nearest" };
const ENDINGS = { csv: ["csv", "text/csv"], spreadsheet: ["csv", "text/csv"], "spreadsheet-comma": ["csv", "text/csv"], latex: ["tex", "application/x-tex"], markdown: ["md", "text/markdown"], json: ["json", "application/json"] };

const engine = clientWith($("table-busy"));
const saver = new Client();
const form = $("table-form");

const fields = () => Object.fromEntries(Object.keys(BEGINNING).map((key) => [key, $(`t-${key}`).value]));

function restore() {
  for (const [key, value] of Object.entries(BEGINNING)) {
    $(`t-${key}`).value = state.get(`t.${key}`, value);
    if (!$(`t-${key}`).value && $(`t-${key}`).tagName === "SELECT") $(`t-${key}`).value = value;
  }
}

async function ask() {
  const request = fields();
  state.keep(Object.fromEntries(Object.entries(request).map(([k, v]) => [`t.${k}`, v])),
    Object.fromEntries(Object.entries(BEGINNING).map(([k, v]) => [`t.${k}`, v])));
  form.querySelector('[data-field="e"]').hidden = request.want === "threshold";
  form.querySelector('[data-field="n"]').hidden = request.want === "best-n";
  const found = await engine.ask("table", { ...request, format: "csv" });
  if (!found) return;
  showFault(form, $("table-error"), found.error);
  for (const button of document.querySelectorAll("[data-form]")) button.disabled = Boolean(found.error);
  outdated($("table"), Boolean(found.error));
  if (found.error) return;
  $("table-facts").replaceChildren(...found.facts.flatMap(([name, text]) => [make("dt", {}, name), make("dd", {}, text)]));
  $("table").replaceChildren(
    make("thead", {}, make("tr", {}, found.columns.map((name) => make("th", { scope: "col" }, name)))),
    make("tbody", {}, found.cells.map((row) => make("tr", {}, row.map((text) => make("td", {}, text))))));
  const more = found.rows - found.cells.length;
  $("table-note").textContent = `${found.rows} row${found.rows === 1 ? "" : "s"}${more > 0 ? `; ${more} more are in the files` : ""}.`;
}

async function download(form) {
  const [ending, type] = ENDINGS[form];
  const found = await saver.ask("table", { ...fields(), format: form });
  if (!found) return;
  if (found.error) $("table-note").textContent = sentence(found.error);
  else save(found.text, `carom-${fields().want}.${ending}`, type);
}

export function start() {
  const soon = later(ask, 150);
  form.addEventListener("input", soon);
  form.addEventListener("submit", (event) => event.preventDefault());
  for (const button of document.querySelectorAll("[data-form]")) {
    button.addEventListener("click", () => download(button.dataset.form));
  }
  state.onRestore(() => { restore(); ask(); });
  restore();
  return ask();
}
