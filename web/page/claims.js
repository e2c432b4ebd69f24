// The room of claims: an editor with live verdicts, and the catalogue.

import { claimView } from "./claim-view.js";
import { Client, clientWith } from "./client.js";
import { $, announce, later, make, sentence } from "./dom.js";
import * as state from "./state.js";
import { open } from "./why.js";

const EXAMPLES = [
  ["Equal masses exchange everything? (refuted)", `claim mine "Equal masses exchange everything?"
given m, v > 0;  e in [0, 1]
prove (1 + e)^2*m*m/(m + m)^2 = 1
`],
  ["The same with its hypothesis (proved)", `claim mine "Equal masses exchange everything if e = 1"
given m, v > 0;  e in [0, 1]
assume e = 1
prove (1 + e)^2*m*m/(m + m)^2 = 1
`],
  ["A name that nothing declares (error)", `claim slip "Momentum is kept"
given m1, m2 > 0;  v1, v2 real;  e in [0, 1]
let w1 = (m1 - e*m2)/(m1 + m2)*v1 + m2*(1 + e)/(m1 + m2)*v2
let w2 = m1*(1 + e)/(m1 + m2)*v1 + (m2 - e*m1)/(m1 + m2)*v2
prove m1*v1 + m2*v2 = m1*w1 + m2*w3
`],
  ["For every n: velocities along the chain (proved)", `claim ratio "The velocities of struck bodies form a geometric sequence"
given x, v1 > 0;  e in [0, 1];  i natural
let u(k) = (x*(1 + e)/(x + 1))^k*v1
prove u(i + 1)*u(i + 1) = u(i)*u(i + 2)
`],
];
/** Longer texts are not put into a link. */
const LINKED = 6000;

const engine = clientWith($("claims-busy"));
const text = $("claim-text");
let listed = [];

/** The text behind the editor, with the places of faults marked. */
function mirror(faults) {
  const source = text.value;
  const parts = [];
  let at = 0;
  for (const { start, end } of [...faults].sort((a, b) => a.start - b.start)) {
    if (start < at) continue;
    const until = Math.max(end, start + 1);
    parts.push(source.slice(at, start), make("mark", {}, source.slice(start, until) || " "));
    at = until;
  }
  // A last line without text has a height as well.
  $("mirror").replaceChildren(...parts, source.slice(at), "\n");
}

function showFaults({ list, more }) {
  mirror(list);
  if (list.length) text.setAttribute("aria-invalid", "true");
  else text.removeAttribute("aria-invalid");
  $("faults").replaceChildren(...list.map((fault) => make("div", { class: "fault" },
    make("p", {}, make("strong", {}, "Error: "), fault.message, " ", make("button", {
      type: "button", class: "small",
      onclick: () => { text.focus(); text.setSelectionRange(fault.start, Math.max(fault.end, fault.start)); },
    }, `line ${fault.line}, column ${fault.column}`)),
    make("pre", { class: "caret", tabIndex: 0 }, fault.rendered))),
    ...(more ? [make("p", {}, `and ${more} more`)] : []));
}

async function judge() {
  const source = text.value;
  state.keep({ claim: source.length <= LINKED ? source : "" }, { claim: EXAMPLES[0][1] });
  const found = await engine.ask("audit", { text: source });
  if (!found) return;
  if (found.error) {
    showFaults({ list: [], more: 0 });
    $("faults").replaceChildren(make("p", { class: "notice error-box" }, sentence(found.error)));
    $("verdicts").replaceChildren();
    return;
  }
  showFaults(found.faults);
  $("verdicts").replaceChildren(...(found.claims.length ? found.claims.map((claim) => claimView(claim, null))
    : [make("p", { class: "hint" }, found.faults.list.length ? "No verdict before the error is mended." : "No claims.")]));
  announce(found.claims.map((c) => `${c.id} ${c.verdict}`).join(", "));
}

const soon = later(judge, 250);

function restore() {
  text.value = state.get("claim", EXAMPLES[0][1]);
  mirror([]);
}

function showCatalogue() {
  const wanted = $("filter").value.trim().toLowerCase();
  const fits = (c) => !wanted || `${c.id} ${c.title} ${c.section ?? ""}`.toLowerCase().includes(wanted);
  const sections = new Map();
  for (const c of listed.filter(fits)) {
    const name = c.section ?? "Lemmas";
    sections.set(name, [...(sections.get(name) ?? []), c]);
  }
  $("catalogue").replaceChildren(...[...sections].map(([name, claims]) => make("section", {},
    make("h3", {}, name),
    make("ul", {}, claims.map((c) => make("li", {},
      make("button", { type: "button", class: "link", onclick: () => open(c.title, [c.id]) }, c.id), " ", c.title))))));
  if (!sections.size) $("catalogue").replaceChildren(make("p", { class: "hint" }, "No claim fits."));
}

export async function start() {
  $("example").append(...EXAMPLES.map(([name], i) => make("option", { value: String(i) }, name)));
  $("example").addEventListener("change", () => {
    const example = EXAMPLES[Number($("example").value)];
    if (!example) return;
    text.value = example[1];
    $("example").value = "";
    mirror([]);
    judge();
  });
  text.addEventListener("input", () => { mirror([]); soon(); });
  text.addEventListener("scroll", () => { $("mirror").scrollTop = text.scrollTop; $("mirror").scrollLeft = text.scrollLeft; });
  $("filter").addEventListener("input", showCatalogue);
  state.onRestore(() => { restore(); judge(); });
  restore();
  judge();
  const found = await new Client().ask("catalogue", {});
  if (found?.claims) {
    listed = found.claims;
    $("language").textContent = found.language;
    showCatalogue();
  }
}
