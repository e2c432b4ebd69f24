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

/** Groups of five digits after the point, for the eye; the text stays one number. */
function grouped(decimal) {
  const match = /^(-?\d+)\.(\d{6,})(e.*)?$/.exec(decimal);
  if (!match) return [decimal.replace("-", "−")];
  const [, whole, digits, power] = match;
  const groups = digits.match(/.{1,5}/g).map((group) => make("span", { class: "group" }, group));
  return [`${whole.replace("-", "−")}.`, ...groups, power ?? ""];
}

/** A number in full: decimal, exact form, what is certain of it. */
export function number(value, options = {}) {
  const box = make("div", { class: "number" });
  if (value.decimal !== null && value.decimal !== undefined) {
    const whole = value.exact !== null && value.exact === value.decimal;
    const many = value.decimal.length > 60;
    box.append(make("p", { class: many ? "decimal many" : "decimal", tabIndex: many ? 0 : undefined }, ...grouped(value.decimal)));
    const typeset = options.formula ? mathml(options.formula) : null;
    const exact = typeset ?? exactForm(value);
    if (typeset) box.append(make("div", { class: "formula scroll", role: "group", "aria-label": value.radical, tabIndex: 0 }, typeset));
    else if (exact) box.append(make("p", { class: "exact-line" }, make("span", { class: "equals" }, "= "), exact));
    box.append(make("p", { class: "hint" }, whole ? "exact"
      : value.exact !== null ? `exact; the decimal is rounded to ${value.digits} digits`
      : `irrational; all ${value.digits} digits certified`));
  } else {
    const [lo, hi] = value.enclosure;
    box.append(make("p", { class: "decimal between" }, "from ", make("span", {}, lo), " to ", make("span", {}, hi)));
    box.append(make("p", { class: "hint" }, "every value that the measured inputs allow lies between these two"));
  }
  return box;
}

/** A number in a cell: a whole number alone, else the decimal with a short fraction, or with its closed form below. */
export function cell(value, closed = false, formula = null) {
  if (value.decimal === null || value.decimal === undefined) return make("span", {}, `${value.enclosure[0]} … ${value.enclosure[1]}`);
  const exact = value.exact !== null && value.exact.length <= 16 ? fraction(value.exact) : null;
  if (exact && !value.exact.includes("/")) return exact;
  const form = exact ?? (closed ? (formula && mathml(formula)) || exactForm(value) : null);
  if (form?.localName === "math") form.removeAttribute("display");
  return make("span", {}, make("span", { class: "digits" }, value.decimal.replace("-", "−")),
    form ? make(exact ? "span" : "div", { class: "exact" }, " = ", form) : null);
}

/** A number of the replay: `text` is exact or a decimal of certified digits. */
export const written = ({ text, exact }) =>
  exact ? (text.includes("/") && !text.includes("√") && text.length <= 24 ? fraction(text) : document.createTextNode(text.replace("-", "−")))
    : make("span", { class: "digits" }, text.replace("-", "−"));
