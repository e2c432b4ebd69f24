// Predict, then run: the answers stay hidden until a prediction is typed, which the engine marks exactly.

import { Client } from "./client.js";
import { $, showFault } from "./dom.js";

const engine = new Client(undefined, "first");
let on = false;
let marked = false;

/** Whether answers are hidden until there is a prediction. */
export const waits = () => on && !marked;

function show() {
  $("predict").setAttribute("aria-pressed", String(on));
  $("prediction").hidden = !on;
  $("panel-chain").classList.toggle("predicting", waits());
}

/** Another chain: another prediction. */
export function changed() {
  if (!on) return;
  marked = false;
  $("mark").textContent = "";
  show();
}

const WORDS = { eta: "The share", "last-velocity": "The velocity", "best-n": "The best number" };

function words({ mark, side, off }, quantity) {
  if (mark === "exact") return "Right, exactly.";
  if (mark === "rounded") return "Right, to all the digits that you gave.";
  const far = off ? `, ${off} % off` : "";
  return `Too ${side}${far}. ${WORDS[quantity]} is ${side === "small" ? "larger" : "smaller"}.`;
}

/** Ties the form to the chain: `fields` gives the chain as it is typed, `play` runs it. */
export function start(fields, play) {
  $("predict").addEventListener("click", () => {
    on = !on;
    marked = false;
    $("mark").textContent = "";
    show();
    if (on) $("guess").focus();
  });
  $("predict-quantity").addEventListener("change", changed);
  $("predict-form").addEventListener("submit", async (event) => {
    event.preventDefault();
    const quantity = $("predict-quantity").value;
    const found = await engine.ask("predict", { ...fields(), quantity, guess: $("guess").value });
    if (!found) return;
    showFault($("predict-form"), $("predict-error"), found.error);
    if (found.error) {
      // The verdict on a former guess is none on this one.
      $("mark").textContent = "";
      return;
    }
    marked = true;
    $("mark").textContent = words(found, quantity);
    show();
    play();
  });
}
