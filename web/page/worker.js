// The engine's thread. First message: a part of the engine, compiled, answered when it stands; then one message for each
// job.

const CALLS = {
  first: ["answers", "predict", "replay"],
  whole: ["table", "plot", "worksheet", "check_table", "restitution", "audit", "claim", "catalogue"],
};
let ready;

async function begin({ part, module }) {
  const engine = await (part === "first" ? import("./first.js") : import("./whole.js"));
  await engine.default({ module_or_path: module });
  return { engine, calls: CALLS[part] };
}

self.onmessage = async ({ data }) => {
  if (data.module) {
    ready = begin(data);
    // What went wrong is said to the first job.
    ready.then(() => self.postMessage({ started: true }), () => {});
    return;
  }
  const { id, call, request } = data;
  try {
    const { engine, calls } = await ready;
    if (!calls.includes(call)) throw new Error(`the engine has no function ${call}`);
    self.postMessage({ id, answer: JSON.parse(engine[call](JSON.stringify(request))) });
  } catch (error) {
    // Stack or memory is used up: the module's state is lost, and the page starts another worker.
    self.postMessage({ id, crashed: String(error) });
  }
};
