// The engine's thread. First message: the compiled module; then one message for each job.
import init, * as engine from "./engine.js";

const CALLS = ["answers", "replay", "table", "plot", "audit", "claim", "catalogue"];
let ready;

self.onmessage = async ({ data }) => {
  if (data.module) {
    ready = init({ module_or_path: data.module });
    return;
  }
  const { id, call, request } = data;
  try {
    await ready;
    if (!CALLS.includes(call)) throw new Error(`the engine has no function ${call}`);
    self.postMessage({ id, answer: JSON.parse(engine[call](JSON.stringify(request))) });
  } catch (error) {
    // Stack or memory is used up: the module's state is lost, and the page starts another worker.
    self.postMessage({ id, crashed: String(error) });
  }
};
