// The engine, compiled while the page's other modules are still on their way; shared by all workers.

async function compile() {
  const response = await fetch("engine_bg.wasm");
  if (!response.ok) throw new Error(`engine_bg.wasm: ${response.status}`);
  // Not every server names the type of the file.
  const typed = response.headers.get("Content-Type")?.startsWith("application/wasm");
  return typed ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

export const compiled = compile();
// Whoever asks for the engine says why it could not be loaded.
compiled.catch(() => {});
