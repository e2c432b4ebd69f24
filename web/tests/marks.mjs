// The script of a worksheet that marks what is typed reads numbers, and judges them, as the program does.
// `cargo test --test all marks` compares marks.json with the program.
//
//   node --test tests/marks.mjs

import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import assert from "node:assert/strict";

const script = readFileSync(new URL("../../src/documents/report/worksheet/marks.js", import.meta.url), "utf8");
const { read, reduced, sha256, accepts, Unclear } = new Function(`${script}; return { read, reduced, sha256, accepts, Unclear };`)();
const cases = JSON.parse(readFileSync(new URL("marks.json", import.meta.url), "utf8"));

const reading = (text) => {
  try {
    const found = read(text);
    if (!found) return null;
    const { n, d } = reduced(found);
    return `${n}/${d}`;
  } catch (error) {
    if (error instanceof Unclear) return null;
    throw error;
  }
};

test("a text is read as another number than the program reads", () => {
  const wrong = cases.read.filter(([text, number]) => reading(text) !== number);
  assert.deepEqual(wrong.map(([text, number]) => [text, number, reading(text)]), []);
  assert.ok(cases.read.filter(([, number]) => number !== null).length > 1000, "most of the texts are numbers");
});

test("a digest is not SHA-256", () => {
  for (let length = 0; length < 200; length += 1) {
    const text = "é€x".repeat(length).slice(0, length);
    assert.equal(sha256(text), createHash("sha256").update(text).digest("hex"), `${length}`);
  }
});

test("an answer is marked otherwise than the program judges it", () => {
  for (const [salt, answers, typed, right] of cases.judged) {
    assert.equal(accepts(answers.split(" "), salt, read(typed)), right, `${salt}: ${typed}`);
  }
  assert.ok(cases.judged.some((one) => one[3]) && cases.judged.some((one) => !one[3]));
});
