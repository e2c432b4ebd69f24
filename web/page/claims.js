// The room of claims: an editor with live verdicts, and the catalogue.

import { badge, claimView } from "./claim-view.js";
import { Client, clientWith } from "./client.js";
import { $, announce, later, make, outdated, sentence, settle } from "./dom.js";
import { markdown } from "./markdown.js";
import * as state from "./state.js";
import { judged, open } from "./why.js";

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
  ["A paper's LaTeX (one proved, one refuted)", String.raw`%carom given m_1, m_2 > 0;  v_1, v_2 real;  e in [0, 1]
\begin{align}
  v_1' &:= \frac{m_1 - e m_2}{m_1 + m_2} v_1 + \frac{m_2 (1 + e)}{m_1 + m_2} v_2 \\
  v_2' &:= \frac{m_1 (1 + e)}{m_1 + m_2} v_1 + \frac{m_2 - e m_1}{m_1 + m_2} v_2
\end{align}
\begin{equation}\label{eq:momentum}
  m_1 v_1' + m_2 v_2' = m_1 v_1 + m_2 v_2
\end{equation}
\begin{equation}\label{eq:energy}
  \frac{1}{2} m_1 v_1'^2 + \frac{1}{2} m_2 v_2'^2 = \frac{1}{2} m_1 v_1^2 + \frac{1}{2} m_2 v_2^2
\end{equation}
`],
];
const engine = clientWith($("claims-busy"));
/** What shows that a text is in the claim language, or in LaTeX. */
const BEGINS = /^\s*claim\b|\\begin\{|\\\[|\$\$/m;
const text = $("claim-text");
let listed = [];
/** The verdicts of the catalogue, as they come. */
const verdicts = new Map();
const badges = new Map();

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
    make("p", {}, make("strong", {}, "Error: "), fault.message, fault.help ? ` (${fault.help}) ` : " ", make("button", {
      type: "button", class: "small",
      onclick: () => { text.focus(); text.setSelectionRange(fault.start, Math.max(fault.end, fault.start)); },
    }, `line ${fault.line}, column ${fault.column}`)),
    fault.excerpt ? make("pre", { class: "caret", tabIndex: 0 }, fault.excerpt) : null)),
    ...(more ? [make("p", {}, `and ${more} more`)] : []));
}

let serial = 0;

async function judge() {
  const mine = ++serial;
  const source = text.value;
  state.keep({ claim: source }, { claim: EXAMPLES[0][1] });
  const head = BEGINS.test(source) ? "" : headOf(source);
  if (head === null) {
    engine.stop();
    showFaults({ list: [], more: 0 });
    fresh(true);
    $("verdicts").replaceChildren(make("p", { class: "hint" }, "A claim begins with its name and title and ends with what it says: "), template(TEMPLATE));
    return;
  }
  // Word processors write curly quotation marks.
  const found = await engine.ask("audit", { text: head + source.replace(/[“”„]/g, '"') });
  if (!found || mine !== serial) return;
  fresh(true);
  if (found.error) {
    showFaults({ list: [], more: 0 });
    $("faults").replaceChildren(make("p", { class: "notice error-box" }, sentence(found.error)));
    $("verdicts").replaceChildren();
    return;
  }
  const names = head ? undeclared(found.faults) : [];
  showFaults(head ? withoutHead(found.faults, head) : found.faults);
  if (names.length) {
    $("verdicts").replaceChildren(make("p", { class: "hint" }, "A claim declares its names: "),
      template(`claim mine "What it says, in words"\ngiven ${names.join(", ")} real\n${head.split("\n")[1]}${source.trim()}\n`, false));
    return;
  }
  $("verdicts").replaceChildren(...(found.claims.length ? found.claims.map((claim) => claimView(claim, null))
    : [make("p", { class: "hint" }, found.faults.list.length ? "No verdict before the error is corrected." : "No claims.")]));
  settle($("verdicts"));
  announce(found.claims.map((c) => `${c.id} ${c.verdict}`).join(", "));
}

const soon = later(judge, 250);

/** Whether the verdicts are about the text as it stands. */
function fresh(on) {
  $("verdicts-stale").hidden = on;
  outdated($("verdicts"), !on);
}

/** What makes a claim of a text without a name: as in Python, `prove` stands in it, or it is one statement; else null. */
function headOf(source) {
  if (/^\s*prove\b/m.test(source)) return 'claim law ""\n';
  return /^[^\n]*[=<>≤≥≠][^\n]*$/.test(source.trim()) ? 'claim law ""\nprove ' : null;
}

/** The names that faults are about where each fault is a name without a declaration. */
function undeclared({ list, more }) {
  const names = list.map(({ message }) => /^nothing declares the name (\w+)$/.exec(message)?.[1]);
  return more || names.includes(undefined) ? [] : [...new Set(names)];
}

/** Faults at the places of the text as it was typed, without the head before it. */
function withoutHead({ list, more }, head) {
  const [, prove] = head.split("\n");
  return { more, list: list.map((fault) => ({
    ...fault, start: Math.max(0, fault.start - head.length), end: Math.max(0, fault.end - head.length),
    line: Math.max(1, fault.line - 1), column: fault.line === 2 ? fault.column - prove.length : fault.column, excerpt: "",
  })) };
}

const TEMPLATE = `claim mine "What it says, in words"
given m1, m2 > 0;  e in [0, 1]
prove m1*(1 + e)/(m1 + m2) >= 0
`;

/** A claim to begin with. What is typed becomes a comment before it, unless the claim contains it. */
function template(claim, comment = true) {
  return make("div", { class: "buttons" }, make("pre", { class: "language" }, claim), make("button", {
    type: "button", onclick: () => begin(claim, comment),
  }, "Begin with this"));
}

/** Puts a claim in the place of what is typed. The browser's undo takes it back. */
function begin(claim, comment) {
  const typed = comment && text.value.trim() ? `${text.value.trim().replace(/^/gm, "# ")}\n\n` : "";
  text.focus();
  text.select();
  // The only way to change a field that its undo knows.
  if (!document.execCommand("insertText", false, typed + claim)) text.value = typed + claim;
  edited();
}

/** The text has changed: what is shown is about another one. */
function edited() {
  mirror([]);
  if ($("verdicts").children.length) fresh(false);
  soon();
}

function restore() {
  text.value = state.get("claim", EXAMPLES[0][1]);
  mirror([]);
}

const sign = (id) => (verdicts.has(id) ? badge(verdicts.get(id)) : make("span", { class: "badge waiting" }, "…"));

function showCatalogue() {
  const wanted = $("filter").value.trim().toLowerCase();
  const fits = (c) => !wanted || `${c.id} ${c.title} ${c.section ?? ""} ${verdicts.get(c.id) ?? ""}`.toLowerCase().includes(wanted);
  const sections = new Map();
  for (const c of listed.filter(fits)) {
    const name = c.section ?? "Lemmas";
    sections.set(name, [...(sections.get(name) ?? []), c]);
  }
  badges.clear();
  $("catalogue").replaceChildren(...[...sections].map(([name, claims]) => make("section", {},
    make("h3", {}, name),
    make("ul", {}, claims.map((c) => {
      const mark = make("span", {}, sign(c.id));
      badges.set(c.id, mark);
      return make("li", {}, make("button", { type: "button", class: "link", onclick: () => open(c.title, [c.id]) }, c.id), " ", c.title, " ", mark);
    })))));
  if (!sections.size) $("catalogue").replaceChildren(make("p", { class: "hint" }, "No claim fits."));
}

/** Judges the catalogue, claim by claim, beside everything else. */
async function judgeAll() {
  const client = new Client();
  const counts = new Map();
  for (const { id } of listed) {
    const answer = await judged(id, client);
    const verdict = answer?.claim?.verdict ?? "undecided";
    verdicts.set(id, verdict);
    counts.set(verdict, (counts.get(verdict) ?? 0) + 1);
    badges.get(id)?.replaceChildren(sign(id));
    const done = verdicts.size === listed.length;
    const text = ["proved", "refuted", "undecided"].filter((v) => counts.has(v)).map((v) => `${counts.get(v)} ${v}`).join(", ");
    if (done || verdicts.size % 10 === 0) $("tally").textContent = done ? `${listed.length} claims: ${text}.` : `${verdicts.size} of ${listed.length} judged: ${text}.`;
  }
}

export async function start() {
  $("example").append(...EXAMPLES.map(([name], i) => make("option", { value: String(i) }, name)));
  $("example").addEventListener("change", () => {
    const example = EXAMPLES[Number($("example").value)];
    if (!example) return;
    text.value = example[1];
    $("example").value = "";
    state.step({ claim: example[1] }, { claim: EXAMPLES[0][1] });
    mirror([]);
    fresh(false);
    judge();
  });
  text.addEventListener("input", edited);
  text.addEventListener("scroll", () => { $("mirror").scrollTop = text.scrollTop; $("mirror").scrollLeft = text.scrollLeft; });
  $("filter").addEventListener("input", showCatalogue);
  state.onRestore(() => {
    if (text.value === state.get("claim", EXAMPLES[0][1])) return;
    restore();
    fresh(false);
    judge();
  });
  addEventListener("resize", later(() => settle($("panel-claims")), 200));
  restore();
  judge();
  const found = await new Client().ask("catalogue", {});
  if (found?.claims) {
    listed = found.claims;
    $("language").replaceChildren(...markdown(found.language));
    showCatalogue();
    judgeAll();
  }
}
