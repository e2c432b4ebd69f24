// The engine as WebAssembly against the same engine as a program: verdicts of the whole catalogue, answers, replays.
//
//   CAROM=path/to/carom node tests/engine.mjs

import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gunzipSync } from "node:zlib";
import assert from "node:assert/strict";

const here = dirname(fileURLToPath(import.meta.url));
const dist = process.env.DIST ?? join(here, "../dist");
const carom = process.env.CAROM ?? join(here, "../../target/release/carom");
const parts = await Promise.all(["first", "whole"].map(async (name) => {
  const part = await import(join(dist, `${name}.js`));
  part.initSync({ module: gunzipSync(readFileSync(join(dist, `${name}.engine`))) });
  return part;
}));
const call = (name, request) => JSON.parse(parts.find((part) => name in part)[name](JSON.stringify(request)));
const native = (...all) => {
  try {
    return JSON.parse(execFileSync(carom, all, { encoding: "utf8", maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "pipe"] }));
  } catch (error) {
    // An audit with verdicts that are not as expected is still an audit.
    if (error.status === 1 && error.stdout) return JSON.parse(error.stdout);
    throw error;
  }
};

const began = performance.now();
const listed = call("catalogue", {}).claims;
const judged = new Map(native("audit", "--format", "json").claims.map((c) => [c.id, c]));
assert.deepEqual(new Set(listed.map((c) => c.id)), new Set(judged.keys()));
for (const { id } of listed) {
  const { claim } = call("claim", { id });
  const other = judged.get(id);
  for (const key of ["verdict", "method", "as_expected", "reason"]) assert.equal(claim[key], other[key], `${id}: ${key}`);
  assert.deepEqual(claim.used, other.assumptions, id);
}
console.log(`catalogue: ${listed.length} verdicts agree, ${(performance.now() - began).toFixed(0)} ms`);

let compared = 0;
const want = "eta,threshold,helps,best-n,recollides,masses,velocities,losses";
const chains = [];
for (const m1 of ["10", "1/3", "64", "1", "2.5e-3", "123456789/1000", "1e40"]) {
  for (const e of ["9/10", "0", "1", "44/81", "0.999"]) {
    for (const n of ["1", "2", "5", "12"]) chains.push({ m1, m2: "1", e, n });
  }
}
chains.push({ m1: "57.1 ± 0.1", m2: "1", e: "[0.88, 0.92]", n: "3", want: "eta,threshold,helps,best-n,recollides,masses" });
chains.push({ m1: "10", m2: "3", e: "9/10,4/5,7/10", n: "2", want: "eta,threshold,masses,velocities,losses,recollides" });
for (const { m1, m2, e, n, want: own } of chains) {
  for (const digits of ["15", "60"]) {
    const names = own ?? want;
    const other = native("eval", `--m1=${m1}`, `--m2=${m2}`, `-e=${e}`, "-n", n, "--want", names, "--digits", digits, "--format", "json");
    const found = call("answers", { m1, m2, e, n, digits, inserted: "optimal" });
    for (const name of names.split(",")) {
      assert.deepEqual(found.answers[name].value, other[name], `${m1} ${e} ${n} ${digits}: ${name}`);
      compared++;
    }
  }
}
for (const [e, masses] of [["9/10", "1000, 0.001"], ["7/11", "2"], ["1/2, 4/5", "2"], ["[0.57, 0.575]", "[2, 5]"]]) {
  const names = "eta,threshold,helps";
  const other = native("eval", "--m1=10", "--m2=1", `-e=${e}`, `--masses=${masses}`, "--want", names, "--format", "json");
  const found = call("answers", { m1: "10", m2: "1", e, masses, digits: "15", inserted: "given" });
  for (const name of names.split(",")) {
    assert.deepEqual(found.answers[name].value, other[name], `${e} ${masses}: ${name}`);
    compared++;
  }
}
console.log(`answers: ${compared} agree`);
console.log(`all in ${(performance.now() - began).toFixed(0)} ms`);
