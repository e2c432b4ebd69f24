// The engine's two parts, each compiled once, while the page's other modules are still on their way, and shared by all
// workers: `first` answers about a chain and replays it, which is what a visitor waits for; `whole` does everything else.

const parts = new Map();

async function compile(part) {
  const response = await fetch(`${part}.engine`);
  if (!response.ok) throw new Error(`${part}.engine: ${response.status}`);
  // The file is compressed by itself, so that it comes as fast from a server that compresses nothing.
  const module = response.body.pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compileStreaming(new Response(module, { headers: { "Content-Type": "application/wasm" } }));
}

/** A part, fetched when it is first asked for. */
export function compiled(part) {
  if (!parts.has(part)) {
    const found = compile(part);
    // Whoever asks for the engine says why it could not be loaded.
    found.catch(() => {});
    parts.set(part, found);
  }
  return parts.get(part);
}

// What the room that is shown first will ask for.
const soon = ["table", "claims", "classroom"].includes(new URLSearchParams(location.hash.slice(1)).get("room")) ? "whole" : "first";
compiled(soon);

/** Both parts, one after the other, so that neither waits for the other's bytes. */
export async function everything() {
  await compiled(soon);
  await compiled(soon === "first" ? "whole" : "first");
}
