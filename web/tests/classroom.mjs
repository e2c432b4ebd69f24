// The lab as a class uses it: numbers as they are typed, energy that adds up, telephones, paper, Back, predictions.
// Each test is named for what was wrong.

import assert from "node:assert/strict";
import { test } from "node:test";
import { DIST, answered, browser, eta, listen, shoot, shows, visit } from "./browser.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true, deviceScaleFactor: 2 };
const numbers = (list) => list.map((text) => Number(text.replace("−", "-").replace("×10", "e")));

test("no verdict stands beside a text that it is not about", async () => {
  await visit("#room=claims", async (page) => {
    await shows(page, "#verdicts .badge", "refuted");
    // In the same turn in which the text changes, before any answer can come.
    const at = await page.evaluate(() => {
      const text = document.getElementById("claim-text");
      text.value = 'claim two "Two"\nprove 1 + 1 = 2\n';
      text.dispatchEvent(new Event("input", { bubbles: true }));
      const verdicts = document.getElementById("verdicts");
      return { opacity: Number(getComputedStyle(verdicts).opacity), hidden: verdicts.getAttribute("aria-hidden"), note: !document.getElementById("verdicts-stale").hidden };
    });
    assert.ok(at.opacity < 0.6, `opacity ${at.opacity}`);
    assert.equal(at.hidden, "true");
    assert.ok(at.note);
    await shows(page, "#verdicts .badge", "proved");
    assert.equal(await page.evaluate(() => getComputedStyle(document.getElementById("verdicts")).opacity), "1");
    assert.equal(await page.getAttribute("#verdicts", "aria-hidden"), null);
  });
});

test("no formula and no counterexample of the catalogue is cut off at 1440 px", async () => {
  await visit("#room=claims", async (page) => {
    await page.waitForFunction(() => document.querySelectorAll("#catalogue li").length >= 90);
    await shows(page, "#tally", "claims:");
    const ids = await page.$$eval("#catalogue li button", (list) => list.map((b) => b.textContent));
    const cut = [];
    for (const id of ids) {
      await page.evaluate((name) => [...document.querySelectorAll("#catalogue li button")].find((b) => b.textContent === name).click(), id);
      await page.waitForFunction((name) => document.querySelector("#why-body .hint")?.textContent.startsWith(name), id);
      const found = await page.evaluate(() => {
        const body = document.getElementById("why-body");
        const wide = body.scrollWidth > body.clientWidth + 1;
        const boxes = [...body.querySelectorAll(".scroll")].filter((box) => box.scrollWidth > box.clientWidth + 1);
        const witness = [...body.querySelectorAll(".counterexample .scroll")].some((box) => box.scrollWidth > box.clientWidth + 1);
        const unreachable = boxes.filter((box) => box.tabIndex < 0).length;
        return { wide, boxes: boxes.length, witness, unreachable };
      });
      if (found.wide || found.witness || found.unreachable || found.boxes) cut.push([id, found]);
      await page.click("#why-close");
    }
    assert.deepEqual(cut.filter(([, f]) => f.wide || f.witness || f.unreachable), []);
    console.log(`  ${ids.length} claims, ${cut.length} with a formula that scrolls: ${cut.map(([id]) => id).join(" ")}`);
    assert.ok(cut.length <= 3, JSON.stringify(cut));
  }, { viewport: { width: 1440, height: 900 } });
});

test("a room that does not exist is the room of the chain, whatever JavaScript inherits", async () => {
  for (const room of ["constructor", "toString", "__proto__", "hasOwnProperty", "nothing"]) {
    await visit(`#room=${room}`, async (page) => {
      await answered(page);
      assert.ok(await page.isVisible("#panel-chain"));
    });
  }
});

test("heat is called heat, and all shares add up to 1", async () => {
  await visit("", async (page) => {
    await answered(page);
    const heads = await page.$$eval("#bodies thead th", (list) => list.map((th) => th.textContent));
    assert.ok(heads.some((text) => text.includes("heat in the collision with the next")), heads.join("|"));
    assert.ok(!heads.some((text) => text.includes("lost to the next")));
    const cells = (column) => page.$$eval("#bodies tbody tr", (rows, k) => rows.map((tr) => tr.children[k].textContent), column);
    const at = (name) => heads.findIndex((text) => text.includes(name));
    const [kept, heat] = [numbers(await cells(at("it keeps"))), numbers((await cells(at("heat"))).slice(0, -1))];
    assert.equal(kept.length, 9);
    assert.equal(heat.length, 8);
    const sum = (list) => list.reduce((a, b) => a + b, 0);
    assert.ok(Math.abs(sum(kept) + sum(heat) - 1) < 1e-12, `${sum(kept)} + ${sum(heat)}`);
    const foot = numbers(await page.$$eval("#bodies tfoot td", (list) => list.map((td) => td.textContent)));
    assert.ok(Math.abs(foot[0] - sum(kept)) < 1e-12 && Math.abs(foot[1] - sum(heat)) < 1e-12, foot.join());
    assert.match(await page.textContent("#bodies-note"), /which is 5\./);
    // The replay comes after the answer.
    await page.waitForFunction(() => /start (≈ )?5\b/.test(document.getElementById("totals").textContent), null, { timeout: 30_000 });
  });
});

test("bodies are counted alike on the stage, in the table and in the cards", async () => {
  await visit("", async (page) => {
    await answered(page);
    assert.match(await page.textContent(".quantity.threshold h2"), /the 7th inserted body \(body 8\) helps/);
    assert.equal(await page.textContent("#bodies tbody tr:nth-child(8) th"), "8 inserted 7");
    assert.equal(await page.textContent("#bodies tbody tr:nth-child(9) th"), "9 last");
    const titles = await page.$$eval(".sign", (list) => list.map((n) => n.textContent));
    assert.ok(!titles.includes("Help"), titles.join());
    for (const [n, ordinal] of [["1", "the inserted body (body 2)"], ["2", "2nd"], ["3", "3rd"], ["11", "11th"], ["22", "22nd"]]) {
      await page.fill("#n", n);
      await shows(page, ".quantity.threshold h2", ordinal);
    }
  });
});

test("on a telephone stage and answer stay visible while a slider moves", async () => {
  for (const options of [PHONE, { ...PHONE, viewport: { width: 820, height: 1180 } }, { ...PHONE, viewport: { width: 844, height: 390 } }]) {
    await visit("", async (page) => {
      await answered(page);
      await page.waitForSelector("#stage g");
      for (const id of ["m1", "n", "e"]) {
        await page.locator(`#${id}-slider`).evaluate((node) => node.scrollIntoView({ block: "center" }));
        const boxes = await page.evaluate((slider) => ["stage", "summary", slider].map((name) => {
          const { top, bottom, height } = document.getElementById(name).getBoundingClientRect();
          return { name, top, bottom, height };
        }), `${id}-slider`);
        for (const { name, top, bottom, height } of boxes) {
          assert.ok(height > 15 && top >= -1 && bottom <= options.viewport.height + 1, `${options.viewport.width} px, ${name}: ${top} to ${bottom}`);
        }
      }
      const before = await page.textContent("#summary");
      await page.focus("#e-slider");
      for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowLeft");
      await page.waitForFunction((old) => document.getElementById("summary").textContent !== old, before);
      const size = await page.evaluate(() => document.querySelector(".body-number").getBoundingClientRect().height);
      assert.ok(size >= 10, `numbers of bodies ${size} px high`);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth), 0);
      await shoot(page, `slider-${options.viewport.width}`, false);
    }, options);
  }
});

test("paper shows answers, not buttons, and nothing lies over anything else", async () => {
  for (const room of ["chain", "claims", "table"]) {
    await visit(`#room=${room}`, async (page) => {
      await (room === "chain" ? answered(page) : shows(page, "h2", "The"));
      await page.waitForTimeout(1500);
      await page.emulateMedia({ media: "print" });
      await page.setViewportSize({ width: 718, height: 1000 });
      const found = await page.evaluate(() => {
        const visible = (node) => node.getClientRects().length > 0 && getComputedStyle(node).visibility !== "hidden";
        const controls = [...document.querySelectorAll("button, input[type=range], input[type=checkbox], [role=tablist]")]
          .filter(visible).filter((n) => !n.closest("#catalogue, .claim")).map((n) => n.outerHTML.slice(0, 60));
        const cards = [...document.querySelectorAll("main .card")].filter(visible)
          .filter((card) => !card.parentElement.closest(".card")).map((card) => card.getBoundingClientRect());
        const over = cards.some((a, i) => cards.some((b, j) => i < j && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1
          && Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1));
        const { color, backgroundColor } = getComputedStyle(document.querySelector("header"));
        return { controls, over, ink: getComputedStyle(document.querySelector("h1")).color, color, backgroundColor, wide: document.documentElement.scrollWidth - innerWidth };
      });
      assert.deepEqual(found.controls, []);
      assert.equal(found.over, false, "cards overlap");
      assert.equal(found.ink, "rgb(0, 0, 0)");
      assert.ok(found.wide <= 0, `${found.wide} px too wide`);
      await page.pdf({ path: new URL(`../shots/print-${room}.pdf`, import.meta.url).pathname, format: "A4" });
    });
  }
});

test("the catalogue shows its verdicts", async () => {
  await visit("#room=claims", async (page) => {
    await shows(page, "#tally", "claims:");
    const found = await page.$$eval("#catalogue li", (list) => list.map((li) => [li.querySelector("button").textContent, li.querySelector(".badge").textContent.trim()]));
    assert.ok(found.length >= 90);
    const verdicts = new Map(found);
    assert.equal(verdicts.get("p-final"), "✗ refuted");
    assert.equal(verdicts.get("eq25"), "✓ proved");
    assert.ok(found.filter(([, v]) => v === "✗ refuted").length >= 9);
    await page.fill("#filter", "refuted");
    const left = await page.$$eval("#catalogue li .badge", (list) => list.map((n) => n.textContent));
    assert.ok(left.length >= 9 && left.every((text) => text.includes("refuted")), left.join());
    await shoot(page, "catalogue");
  });
});

test("numbers are read as classes type them", async () => {
  await visit("#n=2", async (page) => {
    await answered(page);
    const expected = await eta(page);
    for (const [typed, plain] of [[".9", "0.9"], ["0,9", "0.9"], ["90 %", "0.90"], ["90%", "0.90"], ["0.90", "0.90"]]) {
      await page.fill("#e", "0.5");
      await page.waitForFunction((old) => document.querySelector(".quantity.eta .decimal").textContent !== old, expected);
      await page.fill("#e", typed);
      await page.waitForFunction((text) => document.querySelector(".quantity.eta .decimal").textContent === text, expected, { timeout: 10_000 });
      assert.equal(await page.textContent("#e-error"), "", typed);
      await page.click("#copy-command");
      await shows(page, "#copied", "copied");
      assert.ok((await page.evaluate(() => navigator.clipboard.readText())).includes(` -e ${plain} `), typed);
    }
    await page.fill("#m1", "1 000");
    await shows(page, "#bodies td", "1000");
    await page.fill("#m1", "1,000");
    await shows(page, "#m1-error", "write 1000 or 1.000");
    await page.fill("#m1", "10");
    await page.check("#given");
    await page.fill("#masses", "5; 2,5");
    await shows(page, "#bodies td", "2.5");
    await page.check("#moving");
    await page.fill("#v0", "1, 0, 0, −3");
    await shows(page, "#totals", "9.5".replace("9.5", "19/2"));
    for (const [id, text] of [["m1", "NaN"], ["m1", "ten"], ["e", "1.2.3"], ["m1", "1/0"]]) {
      await page.fill(`#${id}`, text);
      await page.waitForFunction((name) => document.getElementById(`${name}-error`).textContent, id);
      assert.doesNotMatch(await page.textContent(`#${id}-error`), /byte|numeral/);
      await page.fill(`#${id}`, id === "e" ? "0.9" : "10");
    }
    await page.click("#tab-table");
    await shows(page, "#table-note", "60 rows");
    await page.fill("#t-e", ".5; 0,9; 100 %");
    await page.fill("#t-ratio", "1,ten");
    await shows(page, "#t-ratio-error", "expected a number");
    assert.doesNotMatch(await page.textContent("#t-ratio-error"), /byte/);
    await page.fill("#t-ratio", "1,2,10,100");
    await shows(page, "#table-note", "60 rows");
  });
});

test("Back returns to the room before, and every room has its title", async () => {
  await visit("", async (page) => {
    await answered(page);
    assert.equal(await page.title(), "Chain – Carom lab");
    await page.fill("#n", "4");
    await shows(page, ".quantity.threshold .sign", "L4");
    await page.click("#tab-table");
    assert.equal(await page.title(), "Table – Carom lab");
    await page.click("#tab-claims");
    assert.equal(await page.title(), "Claims – Carom lab");
    await page.goBack();
    await page.waitForFunction(() => document.title.startsWith("Table"));
    assert.ok(await page.isVisible("#panel-table"));
    await page.goBack();
    await page.waitForFunction(() => document.title.startsWith("Chain"));
    assert.equal(await page.inputValue("#n"), "4");
    await page.goForward();
    await page.waitForFunction(() => document.title.startsWith("Table"));
    await page.goBack();
    await page.selectOption("#preset", { label: "Exactly on the threshold" });
    await shows(page, ".quantity.helps .decimal", "exactly on the threshold");
    await page.goBack();
    await shows(page, ".quantity.threshold .sign", "L4");
    assert.equal(await page.inputValue("#n"), "4");
  });
});

test("an unfinished claim takes no verdict away from the others", async () => {
  await visit("#room=claims", async (page) => {
    await page.fill("#claim-text", 'claim good "Good"\ngiven m > 0\nprove m^2 > 0\n\nclaim half "Half"\ngiven m > 0\nprove m +\n');
    await shows(page, "#verdicts .badge", "proved");
    await shows(page, "#faults .fault", "Error");
    // What is wrong is said once.
    const said = await page.textContent("#faults .fault p");
    const excerpt = await page.textContent("#faults .caret");
    assert.doesNotMatch(excerpt, /error/);
    assert.match(excerpt, /\^/);
    assert.ok(said.length > 10);
    await page.fill("#claim-text", "the energy is conserved");
    await shows(page, "#verdicts button", "Begin with this");
    await page.click("#verdicts button");
    await shows(page, "#verdicts .badge", "proved");
    // What was typed is kept as a comment, and undo brings it back.
    assert.match(await page.inputValue("#claim-text"), /^# the energy is conserved\n\nclaim mine/);
    await page.focus("#claim-text");
    await page.keyboard.press("Control+z");
    assert.equal(await page.inputValue("#claim-text"), "the energy is conserved");
    await page.click("summary:has-text('The language in full')");
    const manual = await page.evaluate(() => ({ tables: document.querySelectorAll("#language table").length,
      code: document.querySelectorAll("#language code").length, text: document.getElementById("language").textContent }));
    assert.ok(manual.tables > 0 && manual.code > 20);
    assert.doesNotMatch(manual.text, /\|\s*-{3,}|```|\*(proved|refuted)\*/);
  });
});

test("a decimal is one number to a screen reader, and its power of ten is one piece", async () => {
  await visit("#m1=1e-40&e=1%2F2&n=1", async (page) => {
    await answered(page);
    const box = await page.evaluate(() => {
      const number = document.querySelector(".quantity.eta .decimal [role=math]");
      const power = number.querySelector(".power");
      return { name: number.getAttribute("aria-label"), hidden: number.firstElementChild.getAttribute("aria-hidden"),
        power: power.textContent, lines: power.getClientRects().length };
    });
    assert.match(box.name, /^\d\.\d+ times ten to the power −\d+$/);
    assert.equal(box.hidden, "true");
    assert.match(box.power, /^×10−\d+$/);
    assert.equal(box.lines, 1);
    // Copied, it is what every program reads.
    await page.evaluate(() => getSelection().selectAllChildren(document.querySelector(".quantity.eta .decimal")));
    await page.keyboard.press("Control+C");
    assert.match(await page.evaluate(() => navigator.clipboard.readText()), /^\d\.\d+e-\d+$/);
  });
});

test("bodies that stick are played to the end", async () => {
  await visit("#m1=1&m2=1&e=0&n=3", async (page) => {
    await answered(page);
    await page.waitForSelector("#stage g");
    await page.click("#view-all");
    for (let i = 0; i < 4; i++) await page.click("#forward");
    await shows(page, "#event", "4 of 4 steps");
    await shows(page, "#event", "Bodies 1 to 5");
    await shows(page, "#event", "move on together with velocity");
    await shows(page, "#replay-note", "no further collision follows");
  });
});

test("numbers of a replay with rounded masses are marked as near ones", async () => {
  await visit("", async (page) => {
    await answered(page);
    await page.waitForSelector("#stage g");
    await page.click("#forward");
    await page.click("#forward");
    const text = await page.textContent("#event");
    assert.match(text, /t ≈ 1\.92/);
    assert.equal(await page.locator("#event mfrac").count(), 0);
    assert.match(await page.textContent("#replay-note"), /marked ≈/);
    assert.doesNotMatch(await page.textContent("#replay-note"), /exact for those|rods/);
    // Where all masses are rational, the numbers are exact.
    await page.selectOption("#preset", { label: "Final after one pass" });
    await shows(page, "#replay-note", "In all 3 collisions");
    await page.click("#forward");
    assert.doesNotMatch(await page.textContent("#event"), /≈/);
  });
});

test("an example's name goes when its numbers are changed, and a huge field stays out of the address", async () => {
  await visit("", async (page) => {
    await answered(page);
    await page.selectOption("#preset", { label: "Elastic, masses 64 to 1" });
    await page.waitForFunction(() => document.querySelector(".quantity.threshold .sign").textContent === "L5");
    assert.equal(await page.inputValue("#preset"), "4");
    await page.fill("#n", "4");
    assert.equal(await page.inputValue("#preset"), "");
    await page.fill("#m1", "1".repeat(100_000));
    await shows(page, "#m1-error", "limit reached");
    await page.waitForTimeout(500);
    assert.ok(page.url().length < 10_000, `${page.url().length}`);
  });
});

test("a page that was opened as a file says why it is empty", async () => {
  const { context, close } = await browser();
  try {
    const { page } = await listen(context);
    await page.goto(`file://${DIST}index.html`);
    assert.ok(await page.isVisible("#from-a-file"));
    assert.match(await page.textContent("#from-a-file"), /web server/);
  } finally {
    await close();
  }
  await visit("", async (page) => {
    await answered(page);
    assert.ok(!(await page.isVisible("#from-a-file")));
  });
});

test("arrows, bars, clock, speed and repetition", async () => {
  await visit("#m1=64&e=1%2F2&n=2", async (page) => {
    await answered(page);
    await page.waitForSelector("#stage .arrow");
    const arrows = () => page.$$eval("#stage .arrow", (list) => list.map((node) => node.getAttribute("d") !== ""));
    assert.deepEqual(await arrows(), [true, false, false, false]);
    await page.click("#forward");
    assert.deepEqual(await arrows(), [true, true, false, false]);
    assert.match(await page.textContent("#clock"), /^t = 1\.00$/);
    // Widths of the bars: the bodies' energies and the heat make the whole.
    const bars = () => page.$$eval("#bars .piece", (list) => list.map((node) => [Number(node.getAttribute("y")), Number(node.getAttribute("width")), node.classList.contains("heat")]));
    const first = (await bars()).filter(([y]) => y < 40);
    const whole = first.reduce((all, [, w]) => all + w, 0);
    // m1 = 64 and m2 = 16, e = 1/2: heat is (1 − e²)·m2/(m1 + m2) = 3/20 of the energy.
    const heat = first.find(([, , hot]) => hot)[1];
    assert.ok(Math.abs(heat / whole - 0.15) < 0.01, `${heat} of ${whole}`);
    await page.uncheck("#arrows");
    assert.equal(await page.isVisible("#stage .arrow"), false);
    await page.check("#centre");
    assert.ok(await page.isVisible("#stage .centre"));
    await page.uncheck("#ledger");
    assert.equal(await page.isVisible("#bars"), false);
    // Four times as fast: 7 s become 1.75 s; repeated, it goes on.
    await page.selectOption("#speed", "4");
    await page.check("#loop");
    await page.click("#play");
    await shows(page, "#event", "3 of 3");
    await shows(page, "#event", "0 of 3");
    assert.equal(await page.textContent("#play"), "Pause");
    await page.click("#play");
    // What happens is also said.
    await page.click("#forward");
    await page.waitForFunction(() => /collision/.test(document.getElementById("announcer").textContent));
  });
});

test("bodies may move towards each other", async () => {
  await visit("", async (page) => {
    await answered(page);
    await page.selectOption("#preset", { label: "Two bodies towards each other" });
    await shows(page, "#totals", "Momentum 1,");
    assert.equal(await page.inputValue("#v0"), "1, -1");
    assert.equal(await page.locator("#bodies tbody tr").count(), 2, "two bodies, as the example says");
    await page.selectOption("#preset", { label: "Two bodies towards a third" });
    await shows(page, "#totals", "Momentum 3/2,");
    assert.equal(await page.inputValue("#v0"), "1, 0, -1/2");
    await shows(page, "#event", "of 3 collisions");
    await page.reload();
    await answered(page);
    assert.equal(await page.inputValue("#v0"), "1, 0, -1/2");
    await shows(page, "#totals", "start 9/8");
    assert.equal(await page.isVisible("#rest"), false, "nothing says that all others rest");
    await page.fill("#v0", "1, 0");
    await shows(page, "#velocities-error", "3 velocities are needed, 2 are given");
    await page.uncheck("#moving");
    await shows(page, "#totals", "start 1,");
    assert.equal(await page.isVisible("#rest"), true);
  });
});

test("two carts towards each other are set up by hand", async () => {
  await visit("", async (page) => {
    await answered(page);
    await page.fill("#n", "0");
    await page.check("#moving");
    assert.equal(await page.isChecked("#given"), false, "no inserted mass is asked for");
    assert.equal(await page.inputValue("#v0"), "1, 0");
    for (const [id, text] of [["m1", "2"], ["e", "1/2"], ["v0", "1, -1"]]) await page.fill(`#${id}`, text);
    await shows(page, "#totals", "start 3/2");
    assert.equal(await page.locator(".error:visible").count(), 0);
  });
});

test("a prediction comes before the answer and is marked exactly", async () => {
  await visit("#m1=64&e=1%2F2&n=2", async (page) => {
    await answered(page);
    await page.click("#predict");
    for (const hidden of ["#quantities", "#summary", "#bodies-card", "#event"]) assert.equal(await page.isVisible(hidden), false, hidden);
    await page.fill("#guess", "a lot");
    await page.click("#check");
    await shows(page, "#guess-error", "expected a number");
    assert.equal(await page.isVisible("#quantities"), false);
    // x = 4, e = 1/2: eta = (36/25)^3/64… the engine knows; a guess of a tenth is marked and shows it.
    await page.fill("#guess", "0.1");
    await page.click("#check");
    await shows(page, "#mark", "Too");
    assert.ok(await page.isVisible("#quantities"));
    const right = await page.evaluate(() => document.querySelector(".quantity.eta .decimal").textContent);
    await page.fill("#e", "0.6");
    await page.waitForFunction(() => document.getElementById("panel-chain").classList.contains("predicting"));
    await page.fill("#e", "1/2");
    await page.fill("#guess", right);
    await page.click("#check");
    await shows(page, "#mark", "Right");
    await shoot(page, "prediction");
    await page.click("#predict");
    assert.ok(await page.isVisible("#quantities"));
  });
});
