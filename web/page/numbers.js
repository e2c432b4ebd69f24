// Certified numbers as the engine gives them: decimals, fractions, radicals, enclosures. Nothing is computed here.

import { fraction, make, mathml } from "./dom.js";

/** The longest fraction that is typeset, the longest text that is shown at once. */
const TYPESET = 36;
const SHOWN = 120;

/** A long text with its length and a button for the rest. */
export function long(text) {
  if (text.length <= SHOWN) return make("span", { class: "exact" }, text);
  const all = make("span", { class: "exact" }, `${text.slice(0, SHOWN - 20)}… `);
  all.append(make("button", {
    type: "button", class: "small",
    onclick: () => { all.textContent = text; },
  }, `show all ${text.length} characters`));
  return all;
}

/** The exact form, or nothing where none is known. */
export function exactForm(number) {
  if (number.exact !== null && number.exact !== undefined) {
    if (number.exact === number.decimal) return null;
    return number.exact.length <= TYPESET ? fraction(number.exact) : long(number.exact);
  }
  return number.radical ? long(number.radical) : null;
}

/** A power of ten for the eye; copied, it is `e-45`, which every program reads. */
const power = (exponent) => make("span", {},
  make("span", { class: "power" }, "×10", make("sup", {}, exponent.replace("-", "−"))),
  make("span", { class: "visually-hidden" }, `e${exponent}`));

/** A decimal in words for a screen reader, as one number. */
const spoken = (mantissa, exponent) => `${mantissa.replace("-", "−")}${exponent ? ` times ten to the power ${exponent.replace("-", "−")}` : ""}`;

/** A decimal: groups of five digits after the point for the eye, one number for everybody else. */
export function decimal(text, group = true) {
  const [mantissa, exponent] = text.split("e");
  const match = group ? /^(-?\d+)\.(\d{6,})$/.exec(mantissa) : null;
  if (!match && !exponent) return document.createTextNode(mantissa.replace("-", "−"));
  const digits = match ? [`${match[1].replace("-", "−")}.`, ...match[2].match(/.{1,5}/g).map((five) => make("span", { class: "group" }, five))]
    : [mantissa.replace("-", "−")];
  return make("span", { role: "math", "aria-label": spoken(mantissa, exponent) },
    make("span", { "aria-hidden": "true" }, digits, exponent ? power(exponent) : null));
}

/** The first digits of a number; what is cut off is marked. */
export function short(value, digits = 6) {
  const exact = value.exact ?? null;
  const text = (exact !== null && whole(value)) || value.decimal;
  const [mantissa, exponent] = text.split("e");
  const match = /^(-?[0.]*)(\d[\d.]*)$/.exec(mantissa);
  if (!match) return text;
  let [seen, cut] = [0, match[2].length];
  for (let i = 0; i < match[2].length; i++) {
    if (match[2][i] === ".") continue;
    if (seen === digits) { cut = i; break; }
    seen++;
  }
  // Digits before the point are never cut.
  if (match[2].indexOf(".", cut) >= 0) return text;
  const rest = match[2].slice(cut);
  const kept = `${match[1]}${match[2].slice(0, cut)}`.replace("-", "−");
  return `${kept}${/[1-9]/.test(rest) || (rest && exact === null) ? "…" : ""}${exponent ? ` · 10^${exponent.replace("-", "−")}` : ""}`;
}

/** The decimal without zeros at its end, where that is the number exactly; else null. */
function whole({ decimal: text, exact }) {
  const parts = /^(-?)(\d+)\.(\d+)$/.exec(text ?? "");
  const [above, below = "1"] = (exact ?? "").replace("-", "").split("/");
  if (text === exact) return text;
  if (!parts || !/^\d{1,400}$/.test(above) || !/^\d{1,400}$/.test(below)) return null;
  const places = parts[3].replace(/0+$/, "");
  if (BigInt(parts[2] + places) * BigInt(below) !== BigInt(above) * 10n ** BigInt(places.length)) return null;
  return `${parts[1]}${parts[2]}${places && "."}${places}`;
}

/** Two ends in words. */
const range = (lo, hi) => ["from ", make("span", {}, lo.replace("-", "−")), " to ", make("span", {}, hi.replace("-", "−"))];

/** A centre with its reach, as the engine gives it, `0.249 ± 0.022` or `(5 ± 5)e-13`. */
export function plusMinus(text) {
  const [, both, exponent] = /^\((.*)\)e(-?\d+)$/.exec(text) ?? [null, text, null];
  const shown = exponent ? `(${both})` : both;
  return make("span", { class: "digits" }, shown.replaceAll("-", "−"), exponent ? power(exponent) : null);
}

/** A number in full: decimal, exact form, what is certain of it. */
export function number(value, options = {}) {
  const box = make("div", { class: "number" });
  if (value.decimal !== null && value.decimal !== undefined) {
    const all = whole(value);
    const shown = all ?? value.decimal;
    const many = shown.length > 60;
    box.append(make("p", { class: many ? "decimal many" : "decimal", tabIndex: many ? 0 : undefined }, decimal(shown)));
    const typeset = options.formula ? mathml(options.formula) : null;
    const exact = typeset ?? exactForm(value);
    if (typeset) box.append(make("div", { class: "formula scroll", role: "group", "aria-label": value.radical }, typeset));
    else if (exact) box.append(make("p", { class: "exact-line" }, make("span", { class: "equals" }, "= "), exact));
    box.append(make("p", { class: "hint" }, all !== null ? "exact"
      : value.exact !== null ? `exact; the decimal is rounded to ${value.digits} digits`
      : `irrational; all ${value.digits} digits certified`));
  } else {
    const [lo, hi] = value.enclosure;
    box.append(make("p", { class: "decimal between" }, ...(value.measured ? [plusMinus(value.measured)] : range(lo, hi))));
    box.append(make("p", { class: "hint" }, `every value that the measured inputs allow lies ${value.measured ? "within ±" : "there"}`));
  }
  return box;
}

/** A number in a cell: a whole number alone, else the decimal with a short fraction, or with its closed form below. */
export function cell(value, closed = false, formula = null) {
  if (value.decimal === null || value.decimal === undefined) {
    return value.measured ? plusMinus(value.measured) : make("span", {}, `${value.enclosure[0]} … ${value.enclosure[1]}`);
  }
  const exact = value.exact !== null && value.exact.length <= 16 ? fraction(value.exact) : null;
  if (exact && !value.exact.includes("/")) return exact;
  const all = whole(value);
  if (all !== null) return make("span", { class: "digits" }, decimal(all, false));
  const form = exact ?? (closed ? (formula && mathml(formula)) || exactForm(value) : null);
  if (form?.localName === "math") form.removeAttribute("display");
  return make("span", {}, make("span", { class: "digits" }, decimal(value.decimal, false)),
    form ? make(exact ? "span" : "div", { class: "exact" }, " = ", form) : null);
}

/** A number of the replay: `text` is exact, or a decimal of certified digits, or an approximation and marked as one. */
export const written = ({ text, exact, approximate }) =>
  exact ? (text.includes("/") && !text.includes("√") && text.length <= 24 ? fraction(text) : document.createTextNode(text.replace("-", "−")))
    : make("span", { class: "digits" }, approximate && text !== "0" ? "≈ " : "", decimal(text, false));

/** The same as plain text. */
export const plain = ({ text, approximate }) => `${approximate && text !== "0" ? "≈ " : ""}${text.replace("-", "−")}`;
