// A worksheet as a file in Chromium, without a server and a network: fields are marked by value, nothing typed is lost.
//
//   CAROM=path/to/carom node --test tests/sheet.mjs

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import assert from "node:assert/strict";
import { browser, listen, SHOTS } from "./browser.mjs";

const carom = process.env.CAROM ?? new URL("../../target/release/carom", import.meta.url).pathname;
const axe = readFileSync(new URL("../node_modules/axe-core/axe.min.js", import.meta.url), "utf8");
const scene = new URL("../../examples/scenes/car-chain.toml", import.meta.url).pathname;
const folder = mkdtempSync(join(tmpdir(), "carom-sheet-"));
const sheet = join(folder, "sheet.html");
let chromium;
before(async () => {
  execFileSync(carom, ["worksheet", scene, "--places", "6", "--versions", "2", "-o", sheet]);
  chromium = await browser({ offline: true, viewport: { width: 390, height: 844 } });
});
after(async () => {
  await chromium.close();
  rmSync(folder, { recursive: true });
});

async function opened() {
  const { page, complaints } = await listen(chromium.context);
  await page.goto(`file://${sheet}`);
  return { page, complaints, form: page.locator("form").first(), fields: page.locator("form").first().locator("input[data-answer]") };
}

test("an answer of the key is not marked as right, or a prediction otherwise than the key", async () => {
  const { page, complaints, form, fields } = await opened();
  // The key of version A: its tables have numbers where the sheet has fields.
  const key = page.locator("form").nth(2);
  const numbers = await key.locator("td").allTextContents();
  const cells = await form.locator("td").evaluateAll((all) => all.map((cell) => cell.querySelector("input")?.name));
  assert.equal(numbers.length, cells.length);
  for (const [at, name] of cells.entries()) if (name) await form.locator(`[name="${name}"]`).fill(numbers[at]);
  const [momentum, energy, end] = (await key.locator(".answer").allTextContents()).map((text) => text.match(/[0-9]+\.[0-9]+/g));
  const asked = form.locator(".number input");
  for (const [at, text] of [momentum[0], momentum[0], energy[0], ...end].entries()) await asked.nth(at).fill(text);
  for (const field of await fields.all()) await field.blur();
  const wrong = await fields.evaluateAll((all) => all.filter((field) => field.dataset.mark !== "right").map((field) => [field.name, field.value]));
  assert.deepEqual(wrong, []);
  assert.match(await form.locator(".score").textContent(), /^(\d+) of \1 numbers are right\.$/);
  const ticked = await key.locator("input[type=radio]").evaluateAll((all) => all.map((option) => option.checked));
  const options = form.locator("input[type=radio]");
  for (const [at, right] of ticked.entries()) if (right) await options.nth(at).check();
  assert.deepEqual(await form.locator("fieldset output").allTextContents(), ["You predicted this.", "You predicted this.", "You predicted this."]);
  await options.nth(ticked.indexOf(false)).check();
  assert.ok((await form.locator("fieldset output").allTextContents()).includes("It came out otherwise."));
  await page.screenshot({ path: join(SHOTS, "sheet-right.png"), fullPage: true });
  assert.deepEqual(complaints, []);
  await page.close({ runBeforeUnload: false });
});

test("a spelling decides, or what was typed is lost", async () => {
  const { page, form, fields } = await opened();
  const name = await fields.first().getAttribute("name");
  const right = await page.locator("form").nth(2).locator("td").nth(
    await form.locator("td").evaluateAll((all) => all.findIndex((cell) => cell.querySelector("input"))),
  ).textContent();
  const say = async (text) => {
    await form.locator(`[name="${name}"]`).fill(text);
    await form.locator(`[name="${name}"]`).blur();
    return form.locator(`[id="${name}-mark"]`).textContent();
  };
  for (const text of [right, right.replace(".", ","), ` ${right} `, `+${right}`, `${(Number(right) * 100).toFixed(4)} %`, `${right}*1`]) {
    assert.equal(await say(text), "right", text);
  }
  for (const text of [`${Number(right) + 1}`, "0", `-${right}`]) assert.equal(await say(text), "not yet", text);
  assert.equal(await say("ten"), "cannot be read: write a number alone");
  assert.equal(await say("1,000"), "has two readings: write 1000 or 1.000");
  assert.equal(await form.locator(`[name="${name}"]`).inputValue(), "1,000", "it is still there");
  await form.locator("textarea").last().fill("I was wrong about the second car.");
  page.removeAllListeners("dialog");
  page.on("dialog", (dialog) => dialog.accept());
  await page.reload();
  assert.equal(await form.locator(`[name="${name}"]`).inputValue(), "1,000", "after the page was loaded again");
  assert.equal(await form.locator("textarea").last().inputValue(), "I was wrong about the second car.");
  await page.screenshot({ path: join(SHOTS, "sheet-390.png") });
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390, "nothing is wider than a telephone");
  await page.evaluate(axe);
  const found = await page.evaluate(() => axe.run());
  assert.deepEqual(found.violations.map((one) => one.id), []);
});
