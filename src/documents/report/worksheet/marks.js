// Marks what is typed into the fields of a worksheet, without a network and without the engine, which has megabytes.
//
// A field holds salted SHA-256 digests of its right answers. What is typed is read as the program reads numbers
// (src/exact/number/typed.rs; web/tests/marks.mjs compares the two readers), and judged by its value. Nothing that was typed
// is changed or deleted; it is kept for as long as the page's tab is open.

const BLANKS = /[ \u00a0\u2009\u202f]/;
const TIMES = /[·*×⋅]/;
const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻";
const VULGAR = { "½": [1n, 2n], "⅓": [1n, 3n], "⅔": [2n, 3n], "¼": [1n, 4n], "¾": [3n, 4n], "⅕": [1n, 5n], "⅛": [1n, 8n], "⅒": [1n, 10n] };
const MOST_DIGITS = 10000;
const digits = (text) => /^[0-9]+$/.test(text);

/** A text with two readings; the message says what to write. */
class Unclear extends Error {}

/** The number `n`/`d` that was typed, or null. Throws Unclear. */
function read(text) {
  text = text.trim();
  if (/^[\[(]|[\])]$|±|\+\/?-/.test(text)) return null;
  const minus = /^[\u2212\u2013-]/.test(text);
  if (minus || text.startsWith("+")) text = minus ? text.slice(1).trimStart() : text.slice(1);
  const percent = text.endsWith("%");
  const found = unsigned(percent ? text.slice(0, -1).trimEnd() : text);
  if (!found) return null;
  return { n: minus ? -found.n : found.n, d: percent ? found.d * 100n : found.d };
}

/** A number without sign and percent. */
function unsigned(text) {
  const raised = power(text);
  if (TIMES.test(text) && !(raised && !TIMES.test(raised[0]))) return product(text);
  const last = text.slice(-1);
  if (last in VULGAR) {
    const whole = text.replace(new RegExp(`${last}+$`), "").trim();
    return mixed(whole === "" ? "0" : whole, VULGAR[last]);
  }
  const line = text.search(/[/\u2044]/);
  if (line >= 0) {
    const [above, below] = [text.slice(0, line).trim(), text.slice(line + 1).trim()];
    const parts = above.split(BLANKS);
    const rest = parts.pop();
    if (parts.length > 0 && rest.length !== 3 && /^[0-9]*$/.test(rest)) {
      if (!digits(rest) || !digits(below) || rest.length + below.length > MOST_DIGITS || BigInt(below) === 0n) return null;
      return mixed(above.slice(0, -rest.length - 1), [BigInt(rest), BigInt(below)]);
    }
    const [n, d] = [natural(above), natural(below)];
    if (n === null || d === null || n.length + d.length > MOST_DIGITS || BigInt(d) === 0n) return null;
    return { n: BigInt(n), d: BigInt(d) };
  }
  const at = text.search(/e/i);
  const [mantissa, exponent] = raised ?? (at < 0 ? [text, "0"] : [text.slice(0, at).trim(), text.slice(at + 1).replaceAll("\u2212", "-")]);
  const marks = mantissa.match(/[.,]/g) ?? [];
  if (marks.length > 1) return null;
  let [whole, places] = marks.length === 0 ? [mantissa, null] : mantissa.split(marks[0]);
  if (marks[0] === "," && at < 0 && !raised && digits(whole) && whole.length <= 3 && !whole.startsWith("0")
    && digits(places) && places.length === 3) {
    throw new Unclear(`has two readings: write ${whole}${places} or ${whole}.${places}`);
  }
  whole = whole === "" && places ? "0" : natural(whole);
  // A point may end a number, but not be one.
  if (places === "" && marks[0] === "." && !mantissa.startsWith(".")) places = null;
  const fraction = places === null ? "" : grouped(places);
  if (whole === null || fraction === null || !/^[+-]?[0-9]+$/.test(exponent)) return null;
  if (whole.length + fraction.length > MOST_DIGITS || exponent.replace(/^[+-]?0*/, "").length > 5 || Math.abs(Number(exponent)) > 10000) return null;
  const shift = Number(exponent) - fraction.length;
  return { n: BigInt(whole + fraction) * 10n ** BigInt(Math.max(shift, 0)), d: 10n ** BigInt(Math.max(-shift, 0)) };
}

/** A product of at most eight numbers, of which only the last one may have a line of a fraction. */
function product(text) {
  const factors = text.split(TIMES).map((factor) => factor.trim());
  if (factors.length > 8) return null;
  const found = { n: 1n, d: 1n };
  for (const factor of factors) {
    const number = unsigned(factor);
    if (!number) return null;
    found.n *= number.n;
    found.d *= number.d;
  }
  const earlier = factors.slice(0, -1).find((factor) => /[/\u2044]/.test(factor));
  if (earlier) throw new Unclear("has two readings: write one number");
  return size(found) > MOST_DIGITS ? null : found;
}

/** How many digits a reduced fraction has. */
function size(number) {
  const { n, d } = reduced(number);
  return `${n}${d === 1n ? "" : d}`.length;
}

/** Mantissa and exponent of 10^3, 10³, 2·10^3, 2*10^-3. */
function power(text) {
  let [before, exponent] = [text, ""];
  const at = text.indexOf("^");
  if (at >= 0) {
    [before, exponent] = [text.slice(0, at), text.slice(at + 1).trim().replaceAll("\u2212", "-")];
  } else {
    while (before !== "" && RAISED.includes(before.slice(-1))) {
      exponent = "0123456789-"[RAISED.indexOf(before.slice(-1))] + exponent;
      before = before.slice(0, -1);
    }
  }
  exponent = exponent.match(/^\{(.*)\}$/)?.[1] ?? exponent;
  before = before.trimEnd();
  if (!before.endsWith("10") || !/^[+-]*[0-9]+$/.test(exponent)) return null;
  before = before.slice(0, -2).trimEnd();
  if (before === "") return ["1", exponent];
  return TIMES.test(before.slice(-1)) ? [before.slice(0, -1).trimEnd(), exponent] : null;
}

/** Digits, perhaps in groups of three from the right. */
function natural(text) {
  const [first, ...rest] = text.split(BLANKS);
  const fits = digits(first) && rest.every((group) => group.length === 3 && digits(group));
  return fits && (rest.length === 0 || first.length <= 3) ? [first, ...rest].join("") : null;
}

/** Digits after the point, perhaps in equal groups of three or five from the left. */
function grouped(text) {
  const full = text.split(BLANKS);
  const last = full.pop();
  const size = full[0]?.length ?? 5;
  const fits = digits(last) && full.every((group) => group.length === size && digits(group));
  return fits && (full.length === 0 || ((size === 3 || size === 5) && last.length <= size)) ? [...full, last].join("") : null;
}

/** A whole number and a fraction: their sum. */
function mixed(whole, [n, d]) {
  const found = natural(whole);
  if (found === null || found.length > MOST_DIGITS) return null;
  const sum = { n: BigInt(found) * d + n, d };
  return size(sum) > MOST_DIGITS ? null : sum;
}

function reduced({ n, d }) {
  let [a, b] = [n < 0n ? -n : n, d];
  while (b > 0n) [a, b] = [b, a % b];
  return { n: n / a, d: d / a };
}

const ROUNDS = [
  0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
  0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
  0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
  0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
  0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
  0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
  0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
  0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2,
];
const START = [0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19];

/** The SHA-256 of a text, in hexadecimal digits. */
function sha256(text) {
  const bytes = new TextEncoder().encode(text);
  const blocks = new DataView(new ArrayBuffer((bytes.length + 72) & ~63));
  bytes.forEach((byte, at) => blocks.setUint8(at, byte));
  blocks.setUint8(bytes.length, 0x80);
  blocks.setUint32(blocks.byteLength - 4, bytes.length * 8);
  const turned = (x, by) => (x >>> by) | (x << (32 - by));
  const state = [...START];
  for (let block = 0; block < blocks.byteLength; block += 64) {
    const words = Array.from({ length: 16 }, (_, at) => blocks.getUint32(block + 4 * at));
    let [a, b, c, d, e, f, g, h] = state;
    for (let round = 0; round < 64; round += 1) {
      if (round >= 16) {
        const [x, y] = [words[round - 15], words[round - 2]];
        const [s, t] = [turned(x, 7) ^ turned(x, 18) ^ (x >>> 3), turned(y, 17) ^ turned(y, 19) ^ (y >>> 10)];
        words.push((words[round - 16] + s + words[round - 7] + t) | 0);
      }
      const one = (h + (turned(e, 6) ^ turned(e, 11) ^ turned(e, 25)) + ((e & f) ^ (~e & g)) + ROUNDS[round] + words[round]) | 0;
      const two = ((turned(a, 2) ^ turned(a, 13) ^ turned(a, 22)) + ((a & b) ^ (a & c) ^ (b & c))) | 0;
      [a, b, c, d, e, f, g, h] = [(one + two) | 0, a, b, c, (d + one) | 0, e, f, g];
    }
    [a, b, c, d, e, f, g, h].forEach((word, at) => (state[at] = (state[at] + word) | 0));
  }
  return state.map((word) => (word >>> 0).toString(16).padStart(8, "0")).join("");
}

const salted = (salt, text) => sha256(`${salt} ${text}`).slice(0, 20);

/** Whether a number is among the right answers of a field. */
function accepts(answers, salt, number) {
  const { n, d } = reduced(number);
  return answers.includes(salted(salt, `${n}/${d}`));
}

/** Marks the fields of one sheet. */
function mark(form) {
  const fields = [...form.querySelectorAll("input[data-answer]")];
  const choices = [...form.querySelectorAll("fieldset[data-answer]")];
  const written = [...form.querySelectorAll("input, textarea")];
  const score = form.querySelector(".score");
  const salt = (name) => `${form.dataset.salt} ${name}`;
  const right = new Set();

  const say = (field) => {
    const told = field.parentElement.querySelector("output");
    right.delete(field);
    let [word, mark] = ["", ""];
    if (field.value.trim() !== "") {
      try {
        const number = read(field.value);
        if (!number) [word, mark] = ["unread", "cannot be read: write a number alone"];
        else if (accepts(field.dataset.answer.split(" "), salt(field.name), number)) [word, mark] = ["right", "right"];
        else [word, mark] = ["wrong", "not yet"];
      } catch (error) {
        if (!(error instanceof Unclear)) throw error;
        [word, mark] = ["unread", error.message];
      }
    }
    if (word === "right") right.add(field);
    field.dataset.mark = word;
    told.dataset.mark = word;
    told.textContent = mark;
  };
  const count = () => {
    const all = fields.length > 0 && right.size === fields.length;
    const begun = fields.some((field) => field.value.trim() !== "");
    score.textContent = begun ? `${right.size} of ${fields.length} numbers are right.` : "";
    for (const choice of choices) {
      const ticked = [...choice.querySelectorAll("input")].findIndex((option) => option.checked);
      const correct = choice.dataset.answer === salted(salt(choice.name), `tick ${ticked}`);
      const told = choice.querySelector("output");
      told.textContent = !all || ticked < 0 ? "" : correct ? "You predicted this." : "It came out otherwise.";
    }
  };

  // What was typed stays when the page is loaded again.
  const key = `carom ${location.pathname} ${form.dataset.salt}`;
  const keep = () => {
    const values = written.map((field) => (field.type === "radio" ? field.checked : field.value));
    try {
      sessionStorage.setItem(key, JSON.stringify(values));
    } catch {
      // A browser that keeps nothing asks before the page is left.
    }
  };
  try {
    const values = JSON.parse(sessionStorage.getItem(key)) ?? [];
    values.forEach((value, at) => {
      if (!written[at]) return;
      if (typeof value === "boolean") written[at].checked = value;
      else written[at].value = value;
    });
  } catch {
    // There is nothing to bring back.
  }

  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("input", (event) => {
    // A mark belongs to what it was given for.
    if (fields.includes(event.target)) {
      right.delete(event.target);
      event.target.dataset.mark = "";
      event.target.parentElement.querySelector("output").textContent = "";
    }
    typed = true;
    keep();
  });
  form.addEventListener("change", (event) => {
    if (fields.includes(event.target)) say(event.target);
    count();
  });
  fields.forEach(say);
  count();
  form.querySelectorAll(".marks").forEach((text) => (text.hidden = false));
}

let typed = false;
if (typeof document !== "undefined") {
  document.querySelectorAll("form[data-salt]").forEach(mark);
  window.addEventListener("beforeunload", (event) => {
    if (typed) event.preventDefault();
  });
}
