// "Why?": the claims of the catalogue behind a result, in a dialog.

import { claimView } from "./claim-view.js";
import { Client } from "./client.js";
import { $, make, sentence, settle } from "./dom.js";

const client = new Client();
const known = new Map();
let names = [];
let asked = null;

/** A claim of the catalogue with its verdict, judged once; null where a newer question took its place. */
export async function judged(id, by = client) {
  if (known.has(id)) return known.get(id);
  const answer = await by.ask("claim", { id });
  if (answer && !answer.error) known.set(id, answer);
  return answer;
}

async function show(id) {
  asked = id;
  for (const button of $("why-tabs").children) button.setAttribute("aria-pressed", String(button.dataset.id === id));
  const body = $("why-body");
  if (!known.has(id)) body.replaceChildren(make("p", { class: "hint" }, `Judging ${id}…`));
  const answer = await judged(id);
  // Another claim may have been asked for meanwhile.
  if (!answer || asked !== id) return;
  if (answer.error) {
    body.replaceChildren(make("p", { class: "notice error-box" }, sentence(answer.error)));
    return;
  }
  const { claim, text } = answer;
  body.replaceChildren(claimView(claim, (cited) => open("Why?", [...new Set([...names, cited])], cited)));
  if (text) body.append(make("details", {}, make("summary", {}, "The claim file"), make("pre", { class: "language" }, text)));
  body.scrollTop = 0;
  settle(body);
}

/** Opens the dialog on some claims; `here` gives what they say about the chain on the page. */
export function open(title, ids, first = ids[0], here = null) {
  names = ids;
  const numbers = here?.() ?? [];
  $("why-here").replaceChildren(...numbers);
  $("why-here").hidden = !numbers.length;
  $("why-title").textContent = title;
  $("why-tabs").replaceChildren(...ids.map((id) => {
    const button = make("button", { type: "button", onclick: () => show(id), "aria-pressed": "false" }, id);
    button.dataset.id = id;
    return button;
  }));
  $("why-tabs").hidden = ids.length < 2;
  if (!$("why").open) $("why").showModal();
  show(first);
}

/** A button beside a result. */
export const whyButton = (of, ids, here) =>
  make("button", { type: "button", class: "why", "aria-label": `why? ${of}`, onclick: () => open(`Why? ${of}`, ids, ids[0], here) }, "why?");

$("why").addEventListener("close", () => $("why-here").replaceChildren());
$("why-close").addEventListener("click", () => $("why").close());
$("why").addEventListener("click", (event) => { if (event.target === $("why")) $("why").close(); });
