// A claim with its verdict, as the audit gives it. All text is text; formulas come as MathML from the engine.

import { make, mathml } from "./dom.js";

const SIGNS = { proved: "✓", refuted: "✗", undecided: "?" };

export const badge = (verdict) =>
  make("span", { class: `badge ${verdict}` }, `${SIGNS[verdict] ?? ""} ${verdict}`);

const formula = (text, source) => {
  const box = make("div", { class: "formula scroll", role: "group", "aria-label": text });
  box.append(mathml(source) ?? text);
  return box;
};

const list = (title, texts) => (texts.length
  ? make("p", { class: "hint" }, `${title}: `, texts.flatMap((text, i) => [i ? "; " : "", make("code", {}, text)]))
  : null);

const values = (point) => point.flatMap(([name, value], i) => [i ? ", " : "", make("code", {}, `${name} = ${value}`)]);

function witness(found) {
  const table = make("table", { class: "witness" },
    make("thead", {}, make("tr", {}, ["What fails there", "left side", "right side"].map((t) => make("th", { scope: "col" }, t)))),
    make("tbody", {}, found.broken.map(([statement, left, right]) =>
      make("tr", {}, make("td", {}, make("code", {}, statement)), make("td", {}, make("code", {}, left)), make("td", {}, make("code", {}, right))))));
  return make("div", { class: "counterexample" },
    make("p", {}, make("strong", {}, "Counterexample: "), ...values(found.point)), make("div", { class: "scroll", role: "group", "aria-label": "The counterexample's numbers" }, table));
}

/** The view; `open` is called with the name of a cited claim. */
export function claimView(claim, open, level = "h3") {
  const title = make(level, {}, claim.number ? `(${claim.number}) ` : "", claim.title, " ", badge(claim.verdict));
  const facts = [claim.id, claim.source, claim.reading === "extracted" ? "as extracted" : null,
    claim.method ? `by ${claim.method}` : null].filter(Boolean).join(" · ");
  const box = make("article", { class: "claim" }, title, make("p", { class: "hint" }, facts));
  if (!claim.as_expected) {
    box.append(make("p", { class: "unexpected" }, `Expected: ${claim.expected}.`));
  }
  if (claim.hypotheses.length) {
    box.append(make("p", { class: "label" }, "For"), make("div", { class: "hypotheses" },
      claim.hypotheses.map((h) => formula(h.text, h.mathml))), make("p", { class: "label" }, "it says"));
  }
  box.append(formula(claim.statement, claim.mathml));
  if (claim.witness) box.append(witness(claim.witness));
  if (claim.reason) box.append(make("p", {}, claim.reason));
  if (claim.verdict === "undecided") {
    box.append(make("p", { class: "hint" }, "Undecided says that neither a proof nor a counterexample was found, no more. "
      + "Try narrower domains, state a step as a claim of its own and cite it with using, or name a method with by."));
  }
  for (const note of claim.notes) box.append(make("p", { class: "note" }, note));
  if (claim.argument.length && !claim.witness) {
    const steps = claim.argument.map(([depth, rule, text]) => {
      const item = make("li", {}, make("span", { class: "rule" }, rule), " ", make("code", {}, text));
      item.style.paddingLeft = `${Math.min(depth, 12)}em`;
      return item;
    });
    box.append(make("details", { open: claim.argument.length <= 12 },
      make("summary", {}, `Argument, ${claim.argument.length} step${claim.argument.length === 1 ? "" : "s"}`),
      make("ol", { class: "argument" }, steps)));
  }
  for (const part of [list("Hypotheses used", claim.used), list("Stated but not needed", claim.unused)]) {
    if (part) box.append(part);
  }
  if (claim.sample?.length) box.append(make("p", { class: "hint" }, "The hypotheses hold, for instance, at ", ...values(claim.sample), "."));
  if (claim.using.length && open) {
    box.append(make("p", { class: "hint" }, "Rests on ", claim.using.flatMap((id, i) => [i ? ", " : "",
      make("button", { type: "button", class: "link", onclick: () => open(id) }, id)])));
  }
  return box;
}
