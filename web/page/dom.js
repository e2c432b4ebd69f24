// Elements made from text: nothing on this page is ever parsed as HTML.

export const $ = (id) => document.getElementById(id);

/** An element with properties and children; texts become text nodes. */
export function make(name, properties = {}, ...children) {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (value === undefined || value === null) continue;
    if (key === "class") node.className = value;
    else if (key.startsWith("on")) node.addEventListener(key.slice(2), value);
    else if (key.includes("-") || key === "role" || key === "scope" || key === "for") node.setAttribute(key, value);
    else node[key] = value;
  }
  node.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return node;
}

const MATHML = "http://www.w3.org/1998/Math/MathML";
const ALLOWED = new Set([
  "math", "mrow", "mi", "mn", "mo", "mtext", "mfrac", "msqrt", "mroot", "msup", "msub", "munder", "munderover",
  "mtable", "mtr", "mtd",
]);

/** The engine's MathML, element by element; whatever is not MathML is left out. */
export function mathml(text) {
  const parsed = new DOMParser().parseFromString(text, "application/xml").documentElement;
  const copy = (from) => {
    if (from.nodeType === Node.TEXT_NODE) return document.createTextNode(from.data);
    if (from.nodeType !== Node.ELEMENT_NODE || !ALLOWED.has(from.localName)) return null;
    const node = document.createElementNS(MATHML, from.localName);
    for (const child of from.childNodes) {
      const copied = copy(child);
      if (copied) node.append(copied);
    }
    return node;
  };
  const math = parsed.localName === "math" ? copy(parsed) : null;
  math?.setAttribute("display", "block");
  return math;
}

/** p/q as a fraction, a whole number as it is. */
export function fraction(text) {
  const element = (name, ...children) => {
    const node = document.createElementNS(MATHML, name);
    node.append(...children);
    return node;
  };
  const sign = text.startsWith("-") ? [element("mo", "−")] : [];
  const [above, below] = text.replace("-", "").split("/");
  const number = below ? element("mfrac", element("mn", above), element("mn", below)) : element("mn", above);
  const math = element("math", element("mrow", ...sign, number));
  math.setAttribute("displaystyle", "true");
  return math;
}

/** A formula on one line, as the claim language writes it: fractions and roots keep their strokes. */
export function line(node) {
  const parts = [...node.children].map(line);
  const whole = (text) => (/^[\w.]+$/.test(text) ? text : `(${text})`);
  switch (node.localName) {
    case "mfrac": return parts.map(whole).join("/");
    case "msqrt": return `sqrt(${parts.join("")})`;
    case "mroot": return `${whole(parts[0])}^(1/${parts[1]})`;
    case "msup": return parts.map(whole).join("^");
    default: return parts.length ? parts.join("") : node.textContent;
  }
}

/** Copied tables are lines of fields with tabs between them, which spreadsheets read: without buttons, formulas on one line. */
document.addEventListener("copy", (event) => {
  const range = getSelection().rangeCount ? getSelection().getRangeAt(0) : null;
  const around = range?.commonAncestorContainer;
  if (!(around?.nodeType === Node.ELEMENT_NODE ? around : around?.parentElement)?.closest("table, .scroll:has(table)")) return;
  const part = range.cloneContents();
  const rows = [...part.querySelectorAll("tr")];
  const cells = (root) => [...root.querySelectorAll("th, td")];
  // Of a single cell there is no row.
  if (!rows.length && !part.querySelector("math, td")) return;
  for (const shown of part.querySelectorAll("button, .power")) shown.remove();
  for (const math of part.querySelectorAll("math")) math.replaceWith(line(math));
  const field = (cell) => cell.textContent.trim().replace(/\s+/g, " ").replaceAll("−", "-").replaceAll("\u2062", "*") + "\t".repeat((cell.colSpan || 1) - 1);
  const text = rows.length ? rows.map((row) => cells(row).map(field).join("\t")).join("\n")
    : (cells(part).length ? cells(part) : [part]).map(field).join("\t");
  event.clipboardData.setData("text/plain", text);
  event.preventDefault();
});

/** Offers a text as a file. */
export function save(text, name, type) {
  const url = URL.createObjectURL(new Blob([text], { type }));
  const link = make("a", { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** Calls a function when nothing has happened for some time. */
export function later(work, milliseconds) {
  let timer;
  return (...all) => {
    clearTimeout(timer);
    timer = setTimeout(() => work(...all), milliseconds);
  };
}

/** Says something to those who listen instead of looking. */
export const announce = later((text) => { $("announcer").textContent = text; }, 700);

/** Scroll boxes that hold more than they show can be reached with the keyboard; a formula is set smaller before it is cut. */
export function settle(root) {
  for (const box of root.querySelectorAll(".scroll:not([role=region])")) {
    if (!box.clientWidth) continue;
    const formula = box.querySelector(":scope > math");
    if (formula) {
      formula.style.fontSize = "";
      const share = box.clientWidth / box.scrollWidth;
      if (share < 1) formula.style.fontSize = `${Math.max(0.62, Math.floor(share * 97) / 100)}em`;
    }
    const more = box.scrollWidth > box.clientWidth || box.scrollHeight > box.clientHeight + 1;
    if (more) box.tabIndex = 0;
    else box.removeAttribute("tabindex");
    box.classList.toggle("more", more);
  }
}

/** Answers to an input that is no longer there: dimmed, and neither read out nor reached. */
export function outdated(box, on) {
  box.classList.toggle("stale", on);
  box.inert = on;
  if (on) box.setAttribute("aria-hidden", "true");
  else box.removeAttribute("aria-hidden");
}

/** Shows a fault: in its field if it has one that is on the form, else in the box. */
export function showFault(form, box, error) {
  for (const field of form.querySelectorAll(".field")) {
    const here = Boolean(error) && field.dataset.field === error.field;
    const place = field.querySelector(".error");
    const input = field.querySelector("input, select");
    if (place) place.textContent = here ? sentence(error) : "";
    if (input) here ? input.setAttribute("aria-invalid", "true") : input.removeAttribute("aria-invalid");
  }
  const placed = error?.field && form.querySelector(`.field[data-field="${CSS.escape(error.field)}"] .error`);
  const inBox = Boolean(error) && !placed;
  box.hidden = !inBox;
  box.textContent = inBox ? sentence(error) : "";
}

/** What is wrong, and what would be right. */
export const sentence = (error) => (error.help ? `${error.message} (${error.help})` : error.message);
