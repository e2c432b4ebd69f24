// The teacher's tools in the lab: worksheets, a pupil's table, bounces, the glossary; measured values; files for a
// spreadsheet. Each test is named for what would be wrong.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { answered, shoot, shows, visit } from "./browser.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true, deviceScaleFactor: 2 };
const SCREENS = [["desktop", {}], ["desktop-dark", { colorScheme: "dark" }], ["phone", PHONE], ["phone-dark", { ...PHONE, colorScheme: "dark" }]];
const wide = (page) => page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
const room = async (page) => {
  await shows(page, "#sheets h3", "answer key");
  await shows(page, "#checked-summary", "cells:");
  await shows(page, "#bounced", "e = ");
};

test("a sheet has blanks for pupils, and its key the numbers of the chain", async () => {
  await visit("#room=classroom", async (page) => {
    await room(page);
    assert.equal(await page.title(), "Classroom – Carom lab");
    await page.fill("#w-masses", "2; 1");
    await page.fill("#w-e", "1/2");
    await page.waitForFunction(() => {
      const captions = [...document.querySelectorAll("#sheets caption")].map((caption) => caption.textContent);
      return captions.length === 2 && captions.every((text) => text.includes("e = 1/2") || text.includes("e = 0.5"));
    });
    const sheets = await page.$$eval("#sheets .sheet", (list) => list.map((sheet) => ({
      title: sheet.querySelector("h3").textContent, blanks: sheet.querySelectorAll("td.blank").length, text: sheet.textContent })));
    assert.deepEqual(sheets.map((sheet) => sheet.title), ["Carts in a row: worksheet", "Carts in a row: answer key"]);
    assert.ok(sheets[0].blanks > 10 && sheets[1].blanks === 0, JSON.stringify(sheets.map((sheet) => sheet.blanks)));
    // m1 = 2, m2 = 1, e = 1/2, v = 3: afterwards 3/2 and 3, as 2·3/2 + 3 = 6.
    assert.ok(!sheets[0].text.includes("1.500") && sheets[1].text.includes("1.500") && sheets[1].text.includes("3.000"));
    await page.fill("#w-versions", "3");
    await page.waitForFunction(() => document.querySelectorAll("#sheets .sheet").length === 6);
    const masses = () => page.$$eval("#sheets .sheet tbody tr:first-child", (rows) => rows.map((row) => row.textContent).join("|"));
    const first = await masses();
    await page.fill("#w-seed", "2");
    await page.waitForFunction(() => document.querySelector("#sheets .foot").textContent.includes("seed 2"));
    assert.notEqual(await masses(), first);
    await page.fill("#w-seed", "1");
    await page.waitForFunction(() => document.querySelector("#sheets .foot").textContent.includes("seed 1"));
    assert.equal(await masses(), first, "the same seed, the same sheets");
    await page.reload();
    await shows(page, "#sheets .foot", "version C");
    await page.fill("#w-masses", "2");
    await shows(page, '[data-field="masses"] .error', "at least two masses");
    assert.equal(await page.isDisabled("[data-sheet-form=pdf]"), true);
    await page.selectOption("#w-kind", "drop");
    await page.fill("#w-versions", "0");
    await page.fill("#w-masses", "620 ± 2; 57,7(1)");
    await shows(page, "#sheets", "±");
    assert.equal(await page.isVisible("#w-velocity"), false);
  });
});

test("sheets are saved in every form, the PDF with its pages", async () => {
  await visit("#room=classroom&w.versions=2", async (page) => {
    await shows(page, "#sheets .foot", "version B");
    for (const [form, ending, sign] of [["pdf", "pdf", "%PDF-"], ["html", "html", "<!DOCTYPE html>"], ["latex", "tex", "\\documentclass"], ["markdown", "md", "#"]]) {
      const [file] = await Promise.all([page.waitForEvent("download"), page.click(`[data-sheet-form=${form}]`)]);
      assert.equal(file.suggestedFilename(), `worksheet.${ending}`);
      const bytes = readFileSync(await file.path());
      assert.ok(bytes.toString("latin1").startsWith(sign) || bytes.toString("latin1").includes(sign), form);
      if (form === "pdf") {
        assert.ok((bytes.toString("latin1").match(/\/Type \/Page\b/g) ?? []).length >= 4);
        assert.match(bytes.toString("latin1").slice(-8), /%%EOF/);
      }
    }
  });
});

test("only the sheets are printed, each on a page of its own", async () => {
  await visit("#room=classroom", async (page) => {
    await room(page);
    await page.evaluate(() => { globalThis.print = () => { globalThis.printed = true; }; });
    await page.click("#sheets-print");
    assert.ok(await page.evaluate(() => globalThis.printed));
    await page.emulateMedia({ media: "print" });
    for (const hidden of ["header", "#sheet-form", "#check-form", "#bounce-form", "#glossary", "#sheets-print", "#checked", "footer"]) {
      assert.equal(await page.isVisible(hidden), false, hidden);
    }
    assert.ok(await page.isVisible("#sheets .sheet"));
    assert.equal(await page.$eval("#sheets .sheet", (sheet) => getComputedStyle(sheet).breakAfter), "page");
    await page.pdf({ path: new URL("../shots/print-sheets.pdf", import.meta.url).pathname, format: "A4" });
    await page.evaluate(() => dispatchEvent(new Event("afterprint")));
    await page.emulateMedia({ media: "screen" });
    assert.ok(await page.isVisible("#sheet-form"));
  });
});

test("a pupil's table is marked cell by cell", async () => {
  await visit("#room=classroom", async (page) => {
    await room(page);
    await shows(page, "#checked-summary", "3 cells: 2 right");
    assert.equal(await page.locator("#checked tr.wrong").count() + await page.locator("#checked tr.rounded").count(), 1);
    assert.equal(await page.locator("#checked tr.empty").count(), 1);
    await page.setInputFiles("#p-file", { name: "pupils.csv", mimeType: "text/csv", buffer: Buffer.from("\ufeffratio;e;n;eta\r\n9;1;1;9\u204416\r\n9;1;1;0,56\r\n") });
    await shows(page, "#checked-summary", "2 cells: 2 right");
    assert.match(await page.getAttribute("#checked-summary", "class"), /good/);
    await page.fill("#p-table", "eta\n0.5625\n");
    await shows(page, '[data-field="table"] .error', "there is no column ratio");
    for (const [id, text] of [["ratio", "9"], ["e", "1"], ["n", "1"]]) await page.fill(`#p-${id}`, text);
    await shows(page, "#checked-summary", "1 cell: 1 right");
    await page.fill("#p-e", "0,9; 1");
    await shows(page, '[data-field="e"] .error', "expected");
  });
});

test("bounces give e, or the readings that exclude each other", async () => {
  await visit("#room=classroom", async (page) => {
    await room(page);
    await shows(page, "#bounced .said", "e = 0.799 ± 0.006");
    await page.fill("#b-readings", "1,20\n0,77\n0,49\n0,31");
    await page.fill("#b-within", "0,01");
    await shows(page, "#bounced .said", "e = 0.799 ± 0.006");
    await page.selectOption("#b-kind", "pairs");
    await page.fill("#b-readings", "1.00; 0.64\n1.00; 0.49");
    await shows(page, "#bounced .said", "no e fits");
    assert.match(await page.textContent("#bounced"), /reading.*1\.00 and 0\.64/);
    await page.fill("#b-readings", "1.00; x");
    await shows(page, '[data-field="readings"] .error', "expected a number");
  });
});

test("the glossary and the guide are one link away and leave the chain alone", async () => {
  await visit("#m1=64&e=1%2F2&n=2", async (page) => {
    await answered(page);
    await page.click('footer a[data-show="glossary"]');
    await shows(page, "#glossary dt", "threshold");
    assert.ok(await page.isVisible("#glossary"));
    await page.click('footer a[data-show="guide"]');
    await shows(page, "#guide-text h3", "The classroom");
    await page.click("#tab-chain");
    assert.equal(await page.inputValue("#m1"), "64");
    const links = await page.$$eval("footer a:not([data-show])", (list) => list.map((a) => a.href));
    assert.ok(links.length >= 3);
    for (const link of links) assert.equal(await page.evaluate(async (url) => (await fetch(url)).status, link), 200, link);
    assert.ok(!(await page.textContent("footer")).includes("@"), "every place is filled in");
  });
});

test("measured values are played at their middle, and every number says what it is", async () => {
  await visit("#m1=57.1+%C2%B1+0.1&e=%5B0.88%2C+0.92%5D&n=3", async (page) => {
    await answered(page);
    assert.match(await page.textContent(".quantity.eta .decimal"), /^0\.25 ± 0\.03$/);
    await shows(page, ".quantity.eta .hint", "within ±");
    await shows(page, "#middle", "the middle of the measured values, m1 = 57.1, e = 0.9");
    await page.waitForSelector("#stage g");
    const before = await page.getAttribute("#stage g", "transform");
    await page.click("#play");
    await page.waitForFunction((old) => document.querySelector("#stage g").getAttribute("transform") !== old, before);
    await page.click("#play");
    await shows(page, "#replay-note", "middle of the measured values: m1 = 57.1, e = 0.9");
    assert.ok(!(await page.textContent("#bodies thead")).includes("in the end"), "no velocity of one chain stands for all");
    for (const picture of ["eta-x", "velocities", "eta-n", "space-time", "threshold"]) {
      await page.selectOption("#picture", picture);
      await shows(page, "#picture-note", "middle of the measured values");
      await page.waitForFunction(() => document.getElementById("picture-image").complete && document.getElementById("picture-image").naturalWidth > 0);
      assert.equal(await page.isVisible("#picture-image"), true, picture);
    }
    await shoot(page, "measured-desktop");
    // A single number is no longer a middle.
    await page.fill("#m1", "57.1");
    await page.fill("#e", "0.9");
    await page.waitForSelector("#middle", { state: "hidden" });
  });
});

test("a table is saved for a spreadsheet without dates in it", async () => {
  await visit("#room=table&t.ratio=9&t.e=1%2F3%2C1&t.n=1", async (page) => {
    await shows(page, "#table-note", "2 rows");
    for (const [form, row] of [["spreadsheet", "9,1,1,0.562500,9\u204416"], ["spreadsheet-comma", "9;1;1;0,562500;9\u204416"]]) {
      const [file] = await Promise.all([page.waitForEvent("download"), page.click(`[data-form="${form}"]`)]);
      assert.match(file.suggestedFilename(), /\.csv$/);
      const text = readFileSync(await file.path(), "utf8");
      assert.ok(text.startsWith("\ufeffratio") && !text.includes("#") && !text.includes("/"), text);
      assert.ok(text.split("\n").includes(row), text);
    }
  });
});

for (const [name, options] of SCREENS) {
  test(`the classroom fits the screen: ${name}`, async () => {
    await visit("#room=classroom", async (page) => {
      await room(page);
      await page.click("#guide summary");
      await shows(page, "#guide-text h3", "The classroom");
      assert.equal(await wide(page), 0, "nothing is wider than the screen");
      await shoot(page, `classroom-${name}`);
      await page.click("#tab-table");
      await shows(page, "#table-note", "rows");
      assert.equal(await wide(page), 0);
    }, options);
    await visit("#m1=57.1+%C2%B1+0.1&e=%5B0.88%2C+0.92%5D&n=3", async (page) => {
      await answered(page);
      await shows(page, "#middle", "middle");
      assert.equal(await wide(page), 0);
      await page.waitForTimeout(1000);
      await shoot(page, `measured-${name}`);
    }, options);
  });
}
