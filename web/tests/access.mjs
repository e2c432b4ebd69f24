// axe-core on every state of the lab: no violation of WCAG 2.0 to 2.2 A and AA, nor of its best practices.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";
import { answered, shows, visit } from "./browser.mjs";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const PHONE = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true };

/** What axe finds wrong with the page as it stands. */
async function violations(page, name) {
  // The page's content policy allows no foreign script; the debugger's protocol does.
  await page.evaluate(AXE);
  const found = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
  assert.ok(found.passes.length > 15, `axe tried ${found.passes.length} rules`);
  return found.violations.flatMap((rule) => rule.nodes.map((node) => `${name}: ${rule.id} (${rule.impact}): ${node.target.join(" ")}: ${node.html.slice(0, 120)}`));
}

const STATES = [
  ["chain", "", async (page) => answered(page)],
  ["closed forms", "", async (page) => { await answered(page); await page.check("#closed"); }],
  ["after a step", "#m1=2&e=1%2F2&n=2", async (page) => { await answered(page); await page.waitForSelector("#stage g"); await page.click("#view-all"); await page.click("#forward"); await page.check("#centre"); }],
  ["collisions listed", "", async (page) => { await answered(page); await page.click("#collisions-card summary"); await page.waitForTimeout(500); }],
  ["wrong input", "", async (page) => { await answered(page); await page.fill("#m1", "ten"); await shows(page, "#m1-error", "ten"); }],
  ["each its own", "#e=9%2F10%2C+4%2F5%2C+7%2F10&n=2", async (page) => answered(page)],
  ["own masses and velocities", "#inserted=given&masses=1&velocities=1%2C+0%2C+-1", async (page) => answered(page)],
  ["distances and walls", "#m1=2&n=0&e=1&velocities=1%2C+-1&gaps=2&left=1&right=1&wall=0.9", async (page) => { await answered(page); await page.waitForSelector("#stage .wall"); }],
  ["measured", "#m1=57.1+%C2%B1+0.1&e=%5B0.88%2C+0.92%5D&n=3", async (page) => answered(page)],
  ["prediction", "", async (page) => { await answered(page); await page.click("#predict"); }],
  ["prediction marked", "", async (page) => { await answered(page); await page.click("#predict"); await page.fill("#guess", "0.5"); await page.click("#check"); await shows(page, "#mark", "Too"); await page.click("#play"); }],
  ["why", "", async (page) => { await answered(page); await page.click(".quantity.eta .why"); await shows(page, "#why-body .badge", "proved"); }],
  ["why, refuted", "#m1=2&e=1%2F2&n=2", async (page) => { await answered(page); await page.click("#again .why"); await shows(page, "#why-body .badge", "refuted"); }],
  ["many digits", "#digits=300", async (page) => answered(page)],
  ["table", "#room=table", async (page) => shows(page, "#table-note", "rows")],
  ["wrong grid", "#room=table", async (page) => { await shows(page, "#table-note", "rows"); await page.fill("#t-e", "0.5:1"); await shows(page, "#t-e-error", "progression"); }],
  ["classroom", "#room=classroom", async (page) => { await shows(page, "#sheets h3", "answer key"); await shows(page, "#checked-summary", "cells:"); await shows(page, "#bounced", "e = "); await page.click("#guide summary"); await shows(page, "#guide-text h3", "The classroom"); }],
  ["classroom, wrong input", "#room=classroom&w.masses=2&p.table=eta&b.readings=1%0Ax", async (page) => { await shows(page, "#sheet-form .error", "two masses"); await shows(page, "#check-form .error", "no column"); await shows(page, "#bounce-form .error", "expected"); }],
  ["classroom, contradiction", "#room=classroom&b.kind=pairs&b.readings=1.00%3B+0.64%0A1.00%3B+0.49&w.kind=drop&w.versions=2", async (page) => { await shows(page, "#bounced .said", "no e fits"); await shows(page, "#sheets .foot", "version B"); }],
  ["claims", "#room=claims", async (page) => { await shows(page, "#tally", "claims:"); await shows(page, "#verdicts .badge", "refuted"); }],
  ["fault", "#room=claims", async (page) => { await shows(page, "#tally", "claims:"); await page.fill("#claim-text", 'claim a "A"\nprove m = 1\n'); await shows(page, "#faults .fault", "Error"); }],
  ["verdicts of a former text", "#room=claims", async (page) => {
    await shows(page, "#verdicts .badge", "refuted");
    await page.evaluate(() => { const t = document.getElementById("claim-text"); setInterval(() => { t.value += " "; t.dispatchEvent(new Event("input")); }, 50); });
    await page.waitForSelector("#verdicts-stale:not([hidden])");
  }],
  ["no claim", "#room=claims", async (page) => { await page.fill("#claim-text", "words"); await shows(page, "#verdicts button", "Begin"); }],
  ["language", "#room=claims", async (page) => { await shows(page, "#tally", "claims:"); await page.click("summary:has-text('The language in full')"); }],
];

for (const [screen, options] of [["light", {}], ["dark", { colorScheme: "dark" }], ["phone", PHONE]]) {
  test(`axe finds nothing, ${screen}`, async () => {
    const found = [];
    for (const [name, fragment, reach] of STATES) {
      await visit(fragment, async (page) => {
        await reach(page);
        await page.waitForTimeout(300);
        found.push(...(await violations(page, `${screen}, ${name}`)));
      }, options);
    }
    assert.deepEqual(found, []);
  });
}
