// The room of the chain: inputs, answers, replay, pictures.

import { Client, clientWith } from "./client.js";
import { $, announce, later, make, outdated, save, sentence, settle, showFault } from "./dom.js";
import { cell, number, plain, plusMinus, short, written } from "./numbers.js";
import * as predict from "./predict.js";
import { COUNT, MASS, RESTITUTION, VELOCITY, attach, move } from "./sliders.js";
import * as stage from "./stage.js";
import * as state from "./state.js";
import { whyButton } from "./why.js";

const BEGINNING = { m1: "10", m2: "1", e: "9/10", n: "7", inserted: "optimal", masses: "", velocities: "", gaps: "", left: "", right: "", wall: "",
  digits: "15", picture: "eta-n" };
/** The fields for distances and walls. */
const PLACES = ["gaps", "left", "right", "wall"];
const EXAMPLES = [
  ["Two bodies towards each other", { m1: "2", m2: "1", e: "1/2", n: "0", velocities: "1, -1" }],
  ["Two bodies between walls", { m1: "2", m2: "1", e: "1", n: "0", velocities: "1, -1", gaps: "2", left: "1", right: "1", wall: "0.9" }],
  ["Ten to one, seven bodies between", { m1: "10", m2: "1", e: "9/10", n: "7" }],
  ["Exactly on the threshold", { m1: "64", m2: "1", e: "44/81", n: "2" }],
  ["Elastic, masses 64 to 1", { m1: "64", m2: "1", e: "1", n: "5" }],
  ["Bodies that meet again", { m1: "2", m2: "1", e: "1/2", n: "2" }],
  ["Final after one pass", { m1: "64", m2: "1", e: "1/2", n: "2" }],
  ["Measured restitution", { m1: "57.1 ± 0.1", m2: "1", e: "[0.88, 0.92]", n: "3" }],
  ["A restitution for each collision", { m1: "10", m2: "1", e: "9/10, 4/5, 7/10", n: "2" }],
  ["Masses of your own", { m1: "10", m2: "1", e: "9/10", masses: "5, 5/2" }],
  ["Two bodies towards a third", { m1: "2", m2: "1", e: "1/2", masses: "1", velocities: "1, 0, -1/2" }],
];
/** Collisions that are listed. */
const MOST_ROWS = 300;
/** Collisions that get a slider each. */
const MOST_SLIDERS = 12;

// What a visitor waits for comes from the small part of the engine.
const engine = clientWith($("chain-busy"), "first");
const replayer = clientWith($("replay-busy"), "first");
const painter = new Client();
const form = $("chain-form");
let answers = null;
let replay = null;
let pictureUrl = null;
let pictureText = "";
/** The inserted masses as they were rounded from the optimal ones, as long as these are what is typed. */
let rounded = null;

/** The elements of a list, for the sliders; commas in brackets belong to ranges. What the list means, the engine says. */
function elements(text) {
  const separator = text.includes(";") ? ";" : ",";
  const list = [""];
  let depth = 0;
  for (const c of text) {
    depth += (c === "[") - (c === "]");
    if (c === separator && depth <= 0) list.push("");
    else list[list.length - 1] += c;
  }
  return list.map((element) => element.trim());
}

/** A list as it is typed: where an element has a decimal comma, semicolons separate. */
const joined = (list) => list.join(list.some((element) => /^[^[]*,/.test(element)) ? "; " : ", ");

const fields = () => ({
  m1: $("m1").value,
  m2: $("m2").value,
  e: $("e").value,
  n: $("n").value,
  inserted: $("given").checked ? "given" : "optimal",
  masses: $("masses").value,
  velocities: $("moving").checked ? $("v0").value : "",
  ...Object.fromEntries(PLACES.map((key) => [key, $("placed").checked ? $(key).value : ""])),
  digits: $("digits").value,
});

/** What has a slider for each element: a name for the eye and one for the ear, from the place in the list. */
const LISTS = [
  { id: "e", scale: RESTITUTION, shown: () => $("each").checked, exact: () => answers?.plain.e,
    name: (i) => `e${i + 1}`, said: (i) => `Restitution of collision ${i + 1}` },
  { id: "masses", scale: MASS, shown: () => $("given").checked, exact: () => answers?.plain.masses,
    name: (i) => `m of ${i + 2}`, said: (i) => `Mass of body ${i + 2}` },
  { id: "v0", scale: VELOCITY, shown: () => $("moving").checked, exact: () => answers?.plain.velocities,
    name: (i) => `v of ${i + 1}`, said: (i) => `Velocity of body ${i + 1}` },
];

/** A slider for each element of the lists that are shown. */
function showLists() {
  const each = $("each").checked;
  $("e-label").textContent = each ? "Restitutions e₁, e₂, …" : "Restitution e";
  $("e-slider").hidden = each;
  $("e").closest(".field").classList.toggle("list", each);
  for (const list of LISTS) showSliders(list);
}

function showSliders({ id, scale, shown, exact, name, said }) {
  const list = shown() ? elements($(id).value) : [];
  const box = $(`${id}-sliders`);
  box.hidden = !list[0] || list.length > MOST_SLIDERS;
  if (box.hidden) return;
  if (box.children.length !== list.length) {
    box.replaceChildren(...list.map((_, i) => {
      const slider = make("input", { type: "range", min: "0", max: String(scale.max), "aria-label": `${said(i)}, slider` });
      slider.addEventListener("input", () => {
        const now = elements($(id).value);
        now[i] = scale.text(Number(slider.value));
        $(id).value = joined(now);
        ask();
      });
      return make("label", {}, name(i), slider);
    }));
  }
  const known = exact()?.length === list.length ? exact() : list;
  [...box.querySelectorAll("input")].forEach((slider, i) => {
    const [above, below = "1"] = known[i].split("/");
    const near = Number(above) / Number(below);
    if (Number.isFinite(near)) move(slider, scale, near);
  });
}

/** What a smaller number of bodies left over of a list, by field: a larger number brings it back. */
const leftOver = new Map();

/** The list of a field with so many elements: those left over before come first, then as many as `more` gives. */
function fitList(id, count, more) {
  const list = [...elements($(id).value), ...(leftOver.get(id) ?? [])].filter(Boolean);
  while (list.length < count) list.push(more(list));
  leftOver.set(id, list.slice(count));
  $(id).value = joined(list.slice(0, count));
}

/** As many elements of each list as there are bodies: the last coefficient is repeated, more bodies rest, one unit apart. */
function fit() {
  const count = $("given").checked ? elements($("masses").value).filter(Boolean).length : Number($("n").value);
  if (!Number.isInteger(count) || count < 0 || count > 200) return;
  if ($("each").checked && $("e").value.trim()) fitList("e", count + 1, (list) => list.at(-1) ?? BEGINNING.e);
  if ($("moving").checked) fitList("v0", count + 2, (list) => (list.length ? "0" : "1"));
  if ($("placed").checked) fitList("gaps", count + 1, () => "1");
}

/** A distance as it is dragged to: in hundredths. */
const hundredths = (x) => String(Math.round(100 * Math.max(x, 0)) / 100);

/** A body was dragged so far: the distances beside it change, and no other ones. */
function dragged(body, by) {
  const { gaps, room } = replay.drawn;
  if (!$("placed").checked) {
    $("placed").checked = true;
    layout();
  }
  fit();
  const list = elements($("gaps").value);
  if (body > 0) list[body - 1] = hundredths(gaps[body - 1] + by);
  else if (room[0] !== null) $("left").value = hundredths(room[0] + by);
  if (body < gaps.length) list[body] = hundredths(gaps[body] - by);
  else if (room[1] !== null) $("right").value = hundredths(room[1] - by);
  $("gaps").value = joined(list);
  ask();
}

/** Whether a text is a list at first sight: a comma with a blank after it, or more than a decimal comma. */
const several = (text) => elements(text).length > (/^[^,;[]*,\S[^,;]*$/.test(text) && !/[./%]/.test(text) ? 2 : 1);

function restore() {
  leftOver.clear();
  for (const key of ["m1", "m2", "e", "n", "digits"]) $(key).value = state.get(key, BEGINNING[key]);
  $("masses").value = state.get("masses", "");
  $("given").checked = state.get("inserted", "optimal") === "given";
  rounded = state.get("rounded", "") ? $("masses").value : null;
  $("v0").value = state.get("velocities", "");
  $("moving").checked = Boolean($("v0").value);
  for (const key of PLACES) $(key).value = state.get(key, "");
  $("placed").checked = PLACES.some((key) => $(key).value);
  $("each").checked = several($("e").value);
  $("picture").value = state.get("picture", BEGINNING.picture);
  if (!$("picture").value) $("picture").value = BEGINNING.picture;
  layout();
}

const isRounded = () => $("given").checked && rounded !== null && $("masses").value === rounded;

function layout() {
  $("masses-field").hidden = !$("given").checked;
  $("velocities-field").hidden = !$("moving").checked;
  $("masses-note").textContent = isRounded() ? "≈ The optimal masses are irrational. These are rounded, and the answers are those of the rounded masses." : "";
  form.querySelectorAll(".placing").forEach((part) => (part.hidden = !$("placed").checked));
  $("rest").hidden = $("moving").checked;
  form.querySelector('[data-field="n"]').hidden = $("given").checked;
  showLists();
}

/** An inserted body as the paper and as the stage count it. */
const ORDINALS = ["", "st", "nd", "rd"];
const ordinal = (k) => `${k}${(k % 100 - k % 10 !== 10 && ORDINALS[k % 10]) || "th"}`;
const inserted = (k, n) => (n === 1 ? "the inserted body (body 2)" : `the ${ordinal(k)} inserted body (body ${k + 1})`);

const title = (quantity) => {
  const n = Number(answers.n);
  // Given masses have an answer for each inserted body.
  const each = Array.isArray(answers.answers[quantity].value);
  if (each && quantity === "threshold") return ["Thresholds", "least restitution with which each inserted body helps"];
  if (each && quantity === "helps") return ["Do they help?", "does the chain pass on more with this body than without it?"];
  return {
    eta: ["η", "share of the energy that the last body gets"],
    threshold: [make("span", {}, "L", make("sub", {}, answers.n)), `least restitution with which ${inserted(n, n)} helps`],
    helps: ["Does it help?", `does inserting ${inserted(n, n)} pass on more energy?`],
    "best-n": ["n*", answers.optimal ? "best number of inserted bodies" : "best number of inserted bodies of optimal masses"],
  }[quantity];
};

function best(value) {
  const [low, high] = value.enclosure;
  const word = { infinite: "∞", any: "any number" };
  const shown = value.exact ? word[value.exact] ?? value.exact : `from ${word[low] ?? low} to ${word[high] ?? high}`;
  const note = value.tie ? "one body fewer hands on exactly as much"
    : value.exact === "infinite" ? "every further body helps"
    : value.exact === "any" ? "equal masses and e = 1: everything is handed on with any number"
    : value.exact ? "exact" : "depends on the measured inputs";
  return make("div", { class: "number" }, make("p", { class: "decimal" }, shown), make("p", { class: "hint" }, note));
}

const HELPS = { yes: "it passes on more than one body fewer would", no: "one body fewer would pass on more", depends: "depends on the measured inputs",
  "exactly on the threshold": "e = L exactly: with or without it, the same" };

/** What the claims behind an answer say with the numbers of this chain put in. */
function here(quantity) {
  const { value, error, mathml: formula } = answers.answers[quantity];
  if (error || !value || Array.isArray(value)) return [];
  const head = make("p", { class: "label" }, "With the numbers of this chain");
  if (quantity === "eta" || quantity === "threshold") return value.decimal ? [head, number(value, { formula })] : [];
  const least = answers.answers.threshold?.value;
  const e = answers.plain.e;
  if (quantity !== "helps" || !least?.decimal || e.length !== 1) return [];
  const compared = { yes: "above", no: "below", "exactly on the threshold": "exactly" }[value];
  return compared ? [head, make("p", {}, `e = ${e[0]} is ${compared} L`, make("sub", {}, answers.n), " = ",
    short(least, 12), `: ${HELPS[value]}.`)] : [];
}

function card(quantity) {
  const { value, error, mathml: formula } = answers.answers[quantity];
  const list = Array.isArray(value);
  const [sign, words] = title(quantity);
  const head = make("div", { class: "card-head" }, make("h2", {}, make("span", { class: "sign" }, sign), " ", make("small", {}, words)),
    whyButton(words, answers.why[quantity], () => here(quantity)));
  let body;
  if (error) body = make("p", { class: "refusal" }, sentence(error));
  else if (list) {
    body = make("ul", { class: "each-body" }, value.map((one, i) => make("li", {},
      `body ${i + 2}: `, typeof one === "string" ? one : cell(one))));
  }
  else if (quantity === "best-n") body = best(value);
  else if (quantity === "helps") {
    body = make("div", { class: "number" }, make("p", { class: "decimal" }, value), make("p", { class: "hint" }, HELPS[value] ?? ""));
  } else body = number(value, { formula });
  if (isRounded() && value) body.append(make("p", { class: "hint" }, "≈ for the optimal masses, which were rounded"));
  const section = make("section", { class: `card quantity ${quantity}` }, head, body);
  section.dataset.quantity = quantity;
  return section;
}

/** The name of a body of the stage: the first and the last are not inserted. */
const role = (i, count) => (i === 0 ? "first" : i === count - 1 ? "last" : count === 3 ? "inserted" : `inserted ${i}`);

function showBodies() {
  const { masses, velocities, losses } = answers.answers;
  const { energy } = answers;
  const card = $("bodies-card");
  card.hidden = !masses;
  if (!masses) return;
  // The velocities of one chain of many are not those of all.
  const again = replay?.again && !replay.middle;
  const { why } = answers;
  const closed = $("closed").checked;
  const heat = energy?.heat ?? losses?.value;
  const head = [["Body"], ["Mass ", whyButton("the masses", why.masses)],
    ["Velocity after the pass ", whyButton("the velocities", why.velocities)],
    again ? ["Velocity in the end ", whyButton("bodies meet again", why.recollides)] : null,
    energy ? ["Share of the energy it keeps"] : null,
    [energy ? "Share lost as heat in the collision with the next " : "Heat of the collision with the next ", whyButton("the heat of a collision", why.losses)]];
  const count = (masses.value ?? []).length;
  const rows = (masses.value ?? []).map((mass, i) => make("tr", {},
    make("th", { scope: "row" }, `${i + 1} `, make("span", { class: "role" }, role(i, count))),
    make("td", {}, cell(mass, closed, masses.mathml?.[i])),
    make("td", {}, velocities?.value ? cell(velocities.value[i], closed, velocities.mathml?.[i]) : "–"),
    again ? make("td", {}, replay.final[i] ? written(replay.final[i]) : "–") : null,
    energy ? make("td", {}, cell(energy.kept[i])) : null,
    make("td", {}, heat?.[i] ? cell(heat[i], closed) : "–")));
  const foot = energy ? make("tfoot", {}, make("tr", {}, make("th", { scope: "row", colSpan: again ? 4 : 3 }, "all together"),
    make("td", {}, cell(energy.kept_in_all)), make("td", {}, cell(energy.heat_in_all)))) : null;
  $("bodies").replaceChildren(
    make("thead", {}, make("tr", {}, head.filter(Boolean).map((parts) => make("th", { scope: "col" }, parts)))),
    make("tbody", {}, rows), ...(foot ? [foot] : []));
  const notes = [...new Set([masses, velocities, losses].map((a) => a?.error).filter(Boolean).map((e) => `${sentence(e)}.`))];
  if (energy) {
    notes.push(`A share is a part of the kinetic energy before the first collision, which is ${energy.total}. `
      + "What all bodies keep and what all collisions lose add up to 1 exactly.");
  }
  $("bodies-note").textContent = notes.join(" ");
}

/** The answers in one line, beside the stage. */
function showSummary() {
  const { eta: share, helps, "best-n": most } = answers.answers;
  const parts = [];
  if (share?.value?.decimal) parts.push(make("span", {}, "η = ", make("strong", {}, short(share.value))));
  else if (share?.value) parts.push(make("span", {}, "η = ", make("strong", {}, share.value.measured ? plusMinus(share.value.measured) : cell(share.value))));
  if (typeof helps?.value === "string") parts.push(make("span", {}, "helps: ", make("strong", {}, helps.value)));
  const best = most?.value?.exact;
  if (best) parts.push(make("span", {}, "n* = ", make("strong", {}, best === "infinite" ? "∞" : best)));
  $("summary").replaceChildren(...parts);
}

function showAgain() {
  const { recollides } = answers.answers;
  const depends = recollides?.value === "depends";
  const box = $("again");
  box.hidden = !(recollides?.value === true || depends);
  if (box.hidden) return;
  box.replaceChildren(
    make("strong", {}, depends ? "Bodies may meet again after the pass. " : "Bodies meet again after the pass. "),
    depends ? "It depends on the measured inputs whether the velocities below are final. "
      : "The velocities after the pass are not final. ",
    whyButton("bodies meet again", answers.why.recollides));
  if (replay && !replay.error) {
    box.append(" ", make("button", { type: "button", class: "small", onclick: stage.showAll }, "Play all collisions"));
  }
}

function showCollisions() {
  $("collisions-card").hidden = !replay;
  if (!replay) return;
  const head = [["No."], ["Bodies"], ["Time"], ["Velocities before", 2], ["Velocities after", 2], ["Lost as heat"]];
  const rows = replay.events.slice(0, MOST_ROWS).map((c) => make("tr", { class: c.of_the_pass ? "" : "later" },
    make("td", {}, String(c.number)), make("td", {}, c.pair),
    [c.time, c.before[0], c.before[1], c.after[0], c.after[1], c.lost].map((x) => make("td", {}, written(x)))));
  $("collisions").replaceChildren(
    make("thead", {}, make("tr", {}, head.map(([text, colSpan]) => make("th", { scope: "col", colSpan }, text)))), make("tbody", {}, rows));
}

async function askReplay(request) {
  const found = await replayer.ask("replay", request);
  if (!found) return;
  replay = found.error ? null : found;
  stage.show(replay);
  const notes = [];
  if (PLACES.includes(found.error?.field)) showFault(form, $("chain-error"), found.error);
  if (found.error) notes.push(`No replay: ${sentence(found.error)}.`);
  else {
    if (found.middle) {
      notes.push(`This replay is of the middle of the measured values: ${found.middle}. Other values that the measurements allow `
        + "may collide at other times and in another order.");
    }
    notes.push(`In all ${found.total}; ${found.end}.`);
    if (found.rounded) {
      notes.push(`The optimal masses are irrational. The replay takes them with ${found.rounded} digits; its numbers, marked ≈, are those of that chain. `
        + (found.middle ? "" : "The velocities in the table are the chain's own."));
    } else if (!found.exact) notes.push("Numbers that became too long are enclosed; count and order of the collisions are certain.");
    notes.push(found.walled ? "The answers on this page are those of one pass without walls; the replay has the walls."
      : "The answers on this page are those of one pass, in which each body strikes the next one once.");
    notes.push(`${$("placed").checked ? "" : "The bodies start one unit apart. "}Their sizes are chosen for the eye and change no velocity.`);
  }
  $("totals").textContent = found.error ? "" : `Kinetic energy at the start ${plain(found.energy)}, lost as heat in all ${plain(found.lost)}. `
    + `Momentum ${found.walled ? "at the start " : ""}${plain(found.momentum)}, ${found.walled ? "which the walls change" : "the same at all times"}.`;
  $("replay-note").textContent = notes.join(" ");
  $("middle").hidden = !found.middle;
  $("middle").textContent = found.middle ? `Shown: the middle of the measured values, ${found.middle}` : "";
  if (answers) {
    showAgain();
    showBodies();
  }
  showCollisions();
  if ($("picture").value === "space-time") paint();
}

const ALTS = {
  "eta-n": "The share of the energy against the number of inserted bodies, for several restitutions, the best number marked",
  "eta-x": "The share of the energy against the mass ratio, for several numbers of bodies",
  threshold: "The least restitution with which the n-th body helps, against the mass ratio",
  map: "A map of restitution and mass ratio, coloured by the best number of inserted bodies",
  velocities: "The velocities of the bodies before they strike and after the pass",
  "space-time": "Space–time diagram of the replay: place to the right, time upward",
};
let painted = "";

const paint = later(async () => {
  const picture = $("picture").value;
  let found;
  if (picture === "space-time") {
    found = replay ? { svg: replay.svg, middle: replay.middle } : { error: { message: "there is no replay to draw" } };
    painted = "";
  } else {
    const request = { ...fields(), picture };
    const key = JSON.stringify(request);
    if (key === painted) return;
    $("figure").classList.add("waiting");
    found = await painter.ask("plot", request);
    if (!found) return;
    painted = key;
  }
  $("figure").classList.remove("waiting");
  $("picture-note").textContent = found.error ? `No picture: ${sentence(found.error)}.`
    : found.middle ? `Curves are drawn for the middle of the measured values, ${found.middle}; bars show all that they allow.` : "";
  $("picture-image").hidden = $("picture-save").disabled = Boolean(found.error);
  if (found.error) return;
  if (pictureUrl) URL.revokeObjectURL(pictureUrl);
  pictureText = found.svg;
  // As an image, a picture can neither run scripts nor fetch anything.
  pictureUrl = URL.createObjectURL(new Blob([found.svg], { type: "image/svg+xml" }));
  $("picture-image").src = pictureUrl;
  $("picture-image").alt = ALTS[picture];
}, 120);

async function ask() {
  const request = fields();
  const kept = { masses: $("given").checked ? request.masses : "", picture: $("picture").value, rounded: isRounded() ? "yes" : "" };
  state.keep({ ...request, ...kept }, BEGINNING);
  showLists();
  predict.changed();
  const found = await engine.ask("answers", request);
  if (!found) return;
  showFault(form, $("chain-error"), found.error);
  for (const part of document.querySelectorAll(".results > .card:not(#prediction), #quantities, #summary, #again, #stage, #player")) outdated(part, Boolean(found.error));
  if (found.error) {
    $("panel-chain").classList.remove("unready");
    announce(sentence(found.error));
    return;
  }
  answers = found;
  showLists();
  const cards = ["eta", "threshold", "helps", "best-n"].filter((quantity) => found.answers[quantity]).map(card);
  $("quantities").replaceChildren(...cards);
  showSummary();
  move($("m1-slider"), MASS, found.places.m1);
  move($("m2-slider"), MASS, found.places.m2);
  move($("e-slider"), RESTITUTION, found.places.e);
  move($("n-slider"), COUNT, found.places.n);
  showAgain();
  showBodies();
  $("panel-chain").classList.remove("unready");
  document.documentElement.dataset.firstAnswer ??= performance.now().toFixed(0);
  settle($("panel-chain"));
  const eta = found.answers.eta.value;
  if (!predict.waits()) {
    const most = found.answers["best-n"]?.value?.exact;
    announce(`eta ${eta?.decimal ?? eta?.enclosure?.join(" to ") ?? "unknown"}${most ? `, best number ${most}` : ""}`
      + (found.answers.recollides?.value === true ? ", bodies meet again after the pass" : ""));
  }
  askReplay(request);
  paint();
}

/** The same question for the command line, in the spelling that it reads; null where it has none. */
const command = () => {
  if (!answers) return null;
  const { m1, m2, e, n, masses, velocities } = answers.plain;
  if (velocities.length) return null;
  const quote = (text) => (/^[\w./,-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);
  const kind = masses ? `--masses ${quote(masses.join(","))}` : `-n ${quote(n)}`;
  const want = ["eta", ...(answers.answers.threshold ? ["threshold", "helps"] : []), "best-n", "masses", "velocities"]
    .filter((quantity) => answers.answers[quantity] && !answers.answers[quantity].error);
  return `carom eval --m1 ${quote(m1)} --m2 ${quote(m2)} -e ${quote(e.join(","))} ${kind} --digits ${quote($("digits").value)} --want ${want.join(",")}`;
};

async function copy(text, what) {
  try {
    await navigator.clipboard.writeText(text);
    $("copied").textContent = `${what} copied.`;
  } catch {
    $("copied").textContent = text;
  }
}

/** A table as a file: of a list of numbers each is exact where it is short, else with its certified digits. */
function saveRows(rows, name) {
  const quoted = (text) => (/[",]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  save(rows.map((row) => row.map((text) => quoted(String(text))).join(",")).join("\n") + "\n", name, "text/csv");
}

/** The longest fraction that is written into a file instead of its decimal. */
const LONGEST_EXACT = 60;
const entry = (x) => (x.exact?.length <= LONGEST_EXACT ? x.exact : x.decimal ?? x.enclosure.join(" to "));

function saveBodies() {
  const { masses, velocities, losses } = answers.answers;
  const heads = ["body", "mass", "velocity_after_the_pass", "heat_of_the_collision_with_the_next"];
  saveRows([heads, ...masses.value.map((mass, i) =>
    [i + 1, entry(mass), ...[velocities, losses].map((list) => (list?.value?.[i] ? entry(list.value[i]) : ""))])], "carom-bodies.csv");
}

function saveCollisions() {
  const about = replay.events.some((c) => c.time.approximate) ? "approximate_" : "";
  const heads = ["time", "left_before", "right_before", "left_after", "right_after", "energy_lost"].map((name) => about + name);
  saveRows([["number", "bodies", ...heads], ...replay.events.map((c) =>
    [c.number, c.pair, ...[c.time, ...c.before, ...c.after, c.lost].map((x) => x.text)])], "carom-collisions.csv");
}

/** Everything as at the beginning; Back returns to what was before. */
function reset() {
  state.step(Object.fromEntries(Object.keys(BEGINNING).map((key) => [key, ""])));
  restore();
  ask();
}

export function start() {
  $("preset").append(...EXAMPLES.map(([name], i) => make("option", { value: String(i) }, name)));
  $("preset").addEventListener("change", () => {
    const example = EXAMPLES[Number($("preset").value)]?.[1];
    if (!example) return;
    leftOver.clear();
    for (const key of ["m1", "m2", "e", "n"]) $(key).value = example[key] ?? BEGINNING[key];
    $("masses").value = example.masses ?? "";
    $("given").checked = Boolean(example.masses);
    $("v0").value = example.velocities ?? "";
    $("moving").checked = Boolean(example.velocities);
    for (const key of PLACES) $(key).value = example[key] ?? "";
    $("placed").checked = PLACES.some((key) => example[key]);
    $("each").checked = several($("e").value);
    layout();
    const { picture, digits } = { picture: $("picture").value, digits: $("digits").value };
    state.step({ ...fields(), masses: $("masses").value, picture, digits }, BEGINNING);
    ask();
  });
  // Once something is changed by hand, it is no longer that example.
  form.addEventListener("input", (event) => { if (event.target !== $("preset")) $("preset").value = ""; });
  attach($("m1-slider"), $("m1"), MASS, ask);
  attach($("m2-slider"), $("m2"), MASS, ask);
  attach($("e-slider"), $("e"), RESTITUTION, ask);
  attach($("n-slider"), $("n"), COUNT, () => { fit(); ask(); });
  for (const id of ["m1", "m2", "e", "v0", "digits", ...PLACES]) $(id).addEventListener("input", ask);
  for (const id of ["n", "masses"]) $(id).addEventListener("input", () => { fit(); layout(); ask(); });
  $("moving").addEventListener("change", () => {
    // Velocities of all bodies go with given masses; without inserted bodies all masses are given.
    if ($("moving").checked && !$("given").checked && $("n").value.trim() !== "0") $("given").click();
    fit();
    layout();
    ask();
  });
  $("placed").addEventListener("change", () => {
    fit();
    layout();
    ask();
  });
  stage.onDrag(dragged);
  $("each").addEventListener("change", () => {
    if ($("each").checked) fit();
    else fitList("e", 1, () => BEGINNING.e);
    layout();
    ask();
  });
  $("given").addEventListener("change", () => {
    const list = answers?.answers.masses?.value;
    if ($("given").checked && !$("masses").value && list) {
      const inner = list.slice(1, -1);
      const typed = inner.map((m) => (m.exact?.length <= 16 ? m.exact : m.decimal ?? m.enclosure[0]));
      $("masses").value = joined(typed);
      rounded = inner.some((m, i) => m.exact !== typed[i]) ? $("masses").value : null;
    }
    fit();
    layout();
    ask();
  });
  form.addEventListener("submit", (event) => event.preventDefault());
  $("closed").addEventListener("change", () => answers && showBodies());
  $("picture").addEventListener("change", () => { state.keep({ picture: $("picture").value }, BEGINNING); paint(); });
  $("picture-save").addEventListener("click", () => save(pictureText, `carom-${$("picture").value}.svg`, "image/svg+xml"));
  $("bodies-save").addEventListener("click", saveBodies);
  $("collisions-save").addEventListener("click", saveCollisions);
  $("reset").addEventListener("click", reset);
  $("copy-link").addEventListener("click", () => copy(state.link(), "Link"));
  $("copy-command").addEventListener("click", () => {
    const text = command();
    if (text) copy(text, "Command");
    else $("copied").textContent = "The command line reads velocities from a scene file: see carom eval --help.";
  });
  state.onRestore(() => { restore(); ask(); });
  predict.start(fields, stage.play);
  restore();
  return ask();
}
