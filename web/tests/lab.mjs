// The lab in a real browser: what a visitor does, and that nothing complains. A picture of each state goes to web/shots.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { DIST, SHOTS, answered, eta, shoot, shows, visit } from "./browser.mjs";

/** Bytes of all files, compressed by `gzip -9` as web/build prints them. */
const MOST_BYTES = 4_700_000;
/** Milliseconds from the start of the page to its first answer; a machine that does other work may be slower. */
const FIRST_ANSWER = Number(process.env.FIRST_ANSWER_MS ?? 1000);

test("the files are at most 4.7 MB when compressed", () => {
  const compressed = (file) => execFileSync("gzip", ["-9", "-c", DIST + file], { maxBuffer: 2 * MOST_BYTES });
  const bytes = readdirSync(DIST).reduce((all, file) => all + compressed(file).length, 0);
  console.log(`  ${bytes} bytes`);
  assert.ok(bytes <= MOST_BYTES, `${bytes} bytes`);
});

test("the first answer comes within a second", async () => {
  const times = [];
  for (let i = 0; i < 3; i++) {
    await visit("", async (page) => {
      await answered(page);
      times.push(Number(await page.evaluate(() => document.documentElement.dataset.firstAnswer)));
      assert.equal(await eta(page), "0.373137511773739");
    });
  }
  console.log(`  ${times.join(", ")} ms`);
  assert.ok(Math.min(...times) <= FIRST_ANSWER, `${times} ms`);
});

test("typing gives exact answers, and the threshold is recognised", async () => {
  await visit("", async (page) => {
    await answered(page);
    for (const [id, text] of [["m1", "64"], ["e", "44/81"], ["n", "2"]]) await page.fill(`#${id}`, text);
    await shows(page, ".quantity.eta", "0.05532353377");
    await shows(page, ".quantity.eta math", "15625000000282429536481");
    await shows(page, ".quantity.threshold math", "4481");
    await shows(page, ".quantity.helps .decimal", "exactly on the threshold");
    await shows(page, ".quantity.best-n", "one body fewer hands on exactly as much");
    await shows(page, "#bodies td", "16");
    await page.waitForTimeout(800);
    await shoot(page, "exact");
    await page.fill("#n", "3");
    await page.check("#closed");
    await page.waitForFunction(() => document.querySelectorAll("#bodies td div.exact math").length >= 6);
    await shoot(page, "closed");
  });
});

test("dragging a slider changes number and answer", async () => {
  await visit("", async (page) => {
    await answered(page);
    const before = await eta(page);
    const box = await page.locator("#e-slider").boundingBox();
    await page.mouse.move(box.x + box.width * 0.9, box.y + box.height / 2);
    await page.mouse.down();
    for (let i = 9; i >= 4; i--) await page.mouse.move(box.x + (box.width * i) / 10, box.y + box.height / 2, { steps: 4 });
    await page.mouse.up();
    const e = await page.inputValue("#e");
    assert.match(e, /^0\.[34]\d*$/);
    await page.waitForFunction((old) => document.querySelector(".quantity.eta .decimal").textContent !== old, before);
    // A reload keeps what was dragged to.
    await page.waitForFunction((text) => location.hash.includes(`e=${text}`), e);
    await page.reload();
    await answered(page);
    assert.equal(await page.inputValue("#e"), e);
    await page.focus("#n-slider");
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.inputValue("#n"), "8");
  });
});

test("an invalid input is one clear error and freezes nothing", async () => {
  await visit("", async (page) => {
    await answered(page);
    await page.fill("#m1", "ten");
    await shows(page, "#m1-error", "ten");
    const errors = () => page.$$eval(".error, .error-box", (list) => list.filter((n) => !n.hidden && n.textContent).length);
    assert.equal(await errors(), 1);
    assert.equal(await page.getAttribute("#m1", "aria-invalid"), "true");
    await shoot(page, "invalid", false);
    await page.fill("#m1", "10");
    await shows(page, ".quantity.eta .decimal", "0.37313");
    await page.waitForFunction(() => !document.querySelector("#m1-error").textContent);
    await page.fill("#e", "1.5");
    await shows(page, "#e-error", "3/2");
    await page.fill("#e", "1");
    await page.fill("#n", "99999999999999999999");
    await shows(page, "#n-error", "limit reached");
    assert.equal(await errors(), 1);
  });
});

test("long work can be stopped, and newer input ends it", async () => {
  await visit("", async (page) => {
    await answered(page);
    await page.fill("#digits", "5000");
    await page.fill("#n", "200");
    await page.waitForSelector("#chain-busy:not([hidden])", { timeout: 10_000 });
    // The page answers while the engine works.
    const start = Date.now();
    await page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));
    assert.ok(Date.now() - start < 1000);
    await shoot(page, "busy", false);
    await page.click("#chain-busy button");
    await shows(page, "#chain-error", "stopped");
    await page.fill("#n", "3");
    await page.fill("#digits", "15");
    await shows(page, ".quantity.best-n", "3");
    await page.waitForSelector("#chain-error", { state: "hidden" });
  });
});

test("what is asked while the engine starts waits for it", async () => {
  await visit("", async (page) => {
    await answered(page);
    await page.waitForSelector("#stage g");
    const started = await page.evaluate(async () => {
      const { Client } = await import("./client.js");
      let started = 0;
      // A worker whose engine takes longer to stand than a job may when a newer one waits.
      window.Worker = class extends Worker {
        constructor(...given) { super(...given); started += 1; }
        postMessage(message) { setTimeout(() => super.postMessage(message), message.module ? 500 : 510); }
      };
      const client = new Client(undefined, "first");
      const older = client.ask("replay", {});
      await new Promise((done) => setTimeout(done, 300));
      const newer = await client.ask("replay", {});
      await older;
      return { started, kind: typeof newer };
    });
    assert.deepEqual(started, { started: 1, kind: "object" });
  });
});

test("the chain moves from collision to collision", async () => {
  await visit("#m1=2&e=1%2F2&n=2", async (page) => {
    await answered(page);
    await shows(page, "#again", "Bodies meet again after the pass");
    await page.click("#forward");
    await shows(page, "#event", "1 of");
    await page.click("#forward");
    await shows(page, "#event", "Bodies 2–3");
    await page.click("#back");
    await shows(page, "#event", "Bodies 1–2");
    const before = await page.getAttribute("#stage g:nth-of-type(1)", "transform");
    await page.click("#play");
    await page.waitForFunction((old) => document.querySelector("#stage g").getAttribute("transform") !== old, before);
    await page.click("#play");
    assert.equal(await page.textContent("#play"), "Play");
    await page.click("#view-all");
    for (let i = 0; i < 4; i++) await page.click("#forward");
    await shows(page, "#event", "They meet again");
    await page.click("#collisions-card summary");
    await page.waitForTimeout(600);
    await shoot(page, "again");
  });
});

test("who wants no motion gets steps", async () => {
  await visit("#m1=64&e=1%2F2&n=2", async (page) => {
    await answered(page);
    await page.waitForSelector("#stage g");
    const places = await page.evaluate(() => new Promise((done) => {
      const seen = new Set();
      document.getElementById("play").click();
      const begin = performance.now();
      requestAnimationFrame(function look(now) {
        seen.add(document.querySelector("#stage g").getAttribute("transform"));
        if (now - begin < 800) requestAnimationFrame(look);
        else done([...seen]);
      });
    }));
    assert.equal(places.length, 1, "nothing moves between two steps");
    await shows(page, "#event", "1 of 3");
  }, { reducedMotion: "reduce" });
});

test("why? shows the equation, its verdict and its argument", async () => {
  await visit("", async (page) => {
    await answered(page);
    await page.click(".quantity.eta .why");
    await shows(page, "#why-body .badge", "proved");
    await shows(page, "#why-body h3", "(25)");
    // The numbers of this chain are put in.
    assert.match(await page.textContent("#why-here"), /0\.373137511773739/);
    assert.ok(await page.locator("#why-here math mn").count() > 3);
    assert.ok(await page.locator("#why-body .formula math mfrac").count() > 0);
    assert.ok(await page.locator("#why-body .argument li").count() > 0);
    await shoot(page, "why", false);
    await page.click("#why-tabs button:nth-child(2)");
    await shows(page, "#why-body h3", "No chain does better");
    await page.keyboard.press("Escape");
    await page.waitForSelector("#why", { state: "hidden" });
    await page.click(".quantity.helps .why");
    assert.match(await page.textContent("#why-here"), /e = 9\/10 is below L7 = 0\.976745871221…/);
    await page.keyboard.press("Escape");
  });
});

test("all pictures are drawn and saved", async () => {
  await visit("#m1=100&e=0.95&n=4", async (page) => {
    await answered(page);
    for (const picture of ["eta-x", "threshold", "map", "velocities", "space-time", "eta-n"]) {
      const old = await page.getAttribute("#picture-image", "src");
      await page.selectOption("#picture", picture);
      await page.waitForFunction((before) => {
        const image = document.getElementById("picture-image");
        return image.getAttribute("src") !== before && image.complete && image.naturalWidth > 0;
      }, old, { timeout: 60_000 });
      assert.notEqual(await page.getAttribute("#picture-image", "alt"), "");
      await page.locator("#figure").screenshot({ path: `${SHOTS}picture-${picture}.png` });
    }
    const [file] = await Promise.all([page.waitForEvent("download"), page.click("#picture-save")]);
    assert.match(readFileSync(await file.path(), "utf8"), /<svg/);
  });
});

test("restitutions for each collision, masses of one's own, measured values", async () => {
  await visit("", async (page) => {
    await answered(page);
    await page.fill("#n", "2");
    await page.check("#each");
    assert.equal(await page.inputValue("#e"), "9/10, 9/10, 9/10");
    assert.equal(await page.locator("#e-sliders input").count(), 3);
    await page.focus("#e-sliders label:nth-child(2) input");
    await page.keyboard.press("ArrowLeft");
    assert.equal(await page.inputValue("#e"), "9/10, 0.899, 9/10");
    await shows(page, ".quantity.best-n", "one coefficient of restitution");
    await page.check("#given");
    await page.fill("#masses", "5, 5/2");
    await shows(page, "#bodies td", "5/2".replace("/", ""));
    await shows(page, ".quantity.helps", "body 2: yes");
    assert.equal(await page.locator(".quantity.best-n").count(), 0, "the best number is about optimal masses");
    await page.waitForTimeout(600);
    await shoot(page, "own");
    await page.selectOption("#preset", { label: "Measured restitution" });
    await shows(page, ".quantity.eta .decimal", "±");
    await shows(page, "#replay-note", "the middle of the measured values");
    await page.waitForTimeout(600);
    await shoot(page, "measured");
  });
});

test("tables are shown and saved, and a wrong grid is one error", async () => {
  await visit("#room=table", async (page) => {
    await shows(page, "#table-note", "60 rows");
    await page.fill("#t-ratio", "1,10");
    await shows(page, "#t-ratio-error", "write 1.10 if the comma is a decimal point, 1; 10 if it separates two numbers");
    await page.fill("#t-ratio", "1; 10");
    await shows(page, "#table-note", "30 rows");
    await shoot(page, "table");
    const [csv] = await Promise.all([page.waitForEvent("download"), page.click('[data-form="csv"]')]);
    assert.equal(csv.suggestedFilename(), "carom-eta.csv");
    const lines = readFileSync(await csv.path(), "utf8").trim().split("\n").filter((line) => !line.startsWith("#"));
    assert.equal(lines.length, 31);
    assert.ok(lines.includes("10,0.9,3,0.478433,"), lines.join("\n"));
    const [latex] = await Promise.all([page.waitForEvent("download"), page.click('[data-form="latex"]')]);
    assert.match(readFileSync(await latex.path(), "utf8"), /\\begin\{tabular\}|\\begin\{table\}/);
    await page.fill("#t-e", "0.5:1");
    await shows(page, "#t-e-error", "a progression has three parts");
    assert.equal(await page.isDisabled('[data-form="csv"]'), true);
    await page.fill("#t-e", "1");
    await page.fill("#t-ratio", "1:100000:1");
    await shows(page, "#table-error", "limit reached");
  });
});

test("the editor marks an error, refutes with a counterexample, proves what is true", async () => {
  await visit("#room=claims", async (page) => {
    await shows(page, "#verdicts .badge", "refuted");
    await shows(page, "#verdicts .counterexample", "e = 1/2");
    await shows(page, "#verdicts .witness", "9/16");
    await page.waitForFunction(() => document.querySelectorAll("#catalogue li").length >= 90);
    await shoot(page, "refuted", false);
    await page.selectOption("#example", { label: "A name that nothing declares (error)" });
    await shows(page, "#faults .fault", "nothing declares the name w3");
    await shows(page, "#faults .caret", "^");
    assert.equal(await page.textContent("#mirror mark"), "w3");
    await shoot(page, "fault", false);
    await page.click("#faults button");
    assert.equal(await page.evaluate(() => getSelection().toString() || document.activeElement.value.slice(
      document.activeElement.selectionStart, document.activeElement.selectionEnd)), "w3");
    await page.keyboard.type("w2");
    await shows(page, "#verdicts .badge", "proved");
    assert.equal(await page.locator("#faults .fault").count(), 0);
    await page.fill("#filter", "superball");
    await page.waitForFunction(() => document.querySelectorAll("#catalogue li").length === 0
      || [...document.querySelectorAll("#catalogue li")].every((n) => n.textContent.includes("superball")));
    await page.fill("#filter", "b-grow");
    await page.click("#catalogue li button");
    await shows(page, "#why-body .badge", "proved");
  });
});

test("a paper's LaTeX is pasted and judged", async () => {
  await visit("#room=claims", async (page) => {
    await shows(page, "#verdicts .badge", "refuted");
    await page.selectOption("#example", { label: "A paper's LaTeX (one proved, one refuted)" });
    await shows(page, "#verdicts h3", "Equation (3)");
    const verdicts = () => page.$$eval("#verdicts .claim", (list) => list.map((n) => [n.querySelector(".hint").textContent.split(" ")[0], n.querySelector(".badge").textContent.slice(2)]));
    assert.deepEqual(await verdicts(), [["momentum", "proved"], ["energy", "refuted"]]);
    await page.fill("#claim-text", "\\[ x^2 \\ge 0 \\]\n\\[ 1 = 1 \\]");
    await shows(page, "#faults", "nothing declares the name x");
    assert.deepEqual(await verdicts(), [["line-2", "proved"]]);
    await shoot(page, "latex");
  });
});

test("markup in a claim stays text", async () => {
  const evil = "<img src=x onerror=\"document.title='broken'\"><script>document.title='broken'</script>";
  const title = "<img src=x onerror=document.title=1><script>document.title=2</script>";
  await visit("#room=claims", async (page) => {
    await page.fill("#claim-text", `claim evil "${title}"\nnote "${title}"\nsource "${title}"\ngiven m > 0\nprove m^2 = m\n`);
    await shows(page, "#verdicts h3", title);
    await shows(page, "#verdicts .note", title);
    await page.fill("#claim-text", `claim evil "x"\n${evil}`);
    await shows(page, "#faults .fault", "Error");
    assert.equal(await page.locator("#verdicts img, #verdicts script, #faults img, #faults script, #mirror img").count(), 0);
    assert.equal(await page.title(), "Claims – Carom lab");
  });
  // The same by a link, into every field.
  const all = ["m1", "m2", "e", "n", "digits", "picture", "room", "t.ratio", "t.want", "claim"];
  const fragment = all.map((key) => `${key}=${encodeURIComponent(evil)}`).join("&");
  await visit(`#${fragment}`, async (page) => {
    await shows(page, ".error", "img");
    assert.equal(await page.title(), "Chain – Carom lab");
  });
});

test("a link restores the state", async () => {
  await visit("#m1=3&m2=2&e=4%2F5&n=4&digits=20&picture=threshold", async (page, { server }) => {
    await answered(page);
    await page.fill("#n", "6");
    await page.click("#copy-link");
    await shows(page, "#copied", "copied");
    const link = await page.evaluate(() => navigator.clipboard.readText());
    const before = await eta(page);
    await page.goto("about:blank");
    await page.goto(link);
    await answered(page);
    assert.equal(await eta(page), before);
    for (const [id, value] of [["m1", "3"], ["m2", "2"], ["e", "4/5"], ["n", "6"], ["digits", "20"], ["picture", "threshold"]]) {
      assert.equal(await page.inputValue(`#${id}`), value);
    }
    await page.click("#tab-claims");
    await page.fill("#claim-text", 'claim two "Two"\nprove 1 + 1 = 2\n');
    await shows(page, "#verdicts .badge", "proved");
    await page.waitForFunction(() => location.hash.includes("two"));
    const claims = page.url();
    await page.goto("about:blank");
    await page.goto(claims);
    await shows(page, "#verdicts h3", "Two");
    assert.ok(claims.startsWith(server.url));
  });
});

test("offline the lab works after a reload", async () => {
  await visit("", async (page, { server, context }) => {
    await answered(page);
    await page.waitForFunction(() => document.documentElement.dataset.offline === "ready", null, { timeout: 30_000 });
    await server.close();
    await context.setOffline(true);
    await page.goto(`${server.url}?from=elsewhere#m1=64&e=44%2F81&n=2`);
    await answered(page);
    await shows(page, ".quantity.helps .decimal", "exactly on the threshold");
    await page.click("#tab-claims");
    await shows(page, "#verdicts .badge", "refuted");
    // The address follows a moment after the page.
    await page.waitForFunction(() => location.hash.includes("room=claims"));
    await page.reload();
    await shows(page, "#verdicts .badge", "refuted");
    const caches = await page.evaluate(() => caches.keys());
    assert.equal(caches.length, 1);
    assert.match(caches[0], /^carom-lab-[0-9a-f]{16}$/);
  });
});

for (const [name, options] of [["phone", { viewport: { width: 360, height: 740 }, isMobile: true, hasTouch: true, deviceScaleFactor: 2 }],
  ["dark", { colorScheme: "dark" }]]) {
  test(`the lab on a screen that is: ${name}`, async () => {
    await visit("#m1=2&e=1%2F2&n=3", async (page) => {
      await answered(page);
      await page.waitForTimeout(1500);
      const wide = () => page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.equal(await wide(), 0, "nothing is wider than the screen");
      await shoot(page, name);
      await page.click(".quantity.eta .why");
      await shows(page, "#why-body .badge", "proved");
      await shoot(page, `${name}-why`, false);
      await page.click("#why-close");
      await page.click("#tab-table");
      await shows(page, "#table-note", "rows");
      assert.equal(await wide(), 0);
      await shoot(page, `${name}-table`, false);
      await page.click("#tab-claims");
      await shows(page, "#verdicts .badge", "refuted");
      assert.equal(await wide(), 0);
      await shoot(page, `${name}-claims`);
    }, options);
  });
}

test("everything has a name, and the keyboard reaches it", async () => {
  await visit("", async (page) => {
    await answered(page);
    const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input, select, textarea, [role=img], img")]
      .filter((node) => !node.closest("[hidden]"))
      .filter((node) => !(node.getAttribute("aria-label") || node.labels?.length || node.textContent.trim() || node.alt !== undefined && node.hasAttribute("alt")))
      .map((node) => node.outerHTML));
    assert.deepEqual(nameless, []);
    const levels = await page.$$eval("#panel-chain h1, #panel-chain h2, #panel-chain h3, header h1", (list) => list.map((n) => Number(n.tagName[1])));
    assert.equal(levels[0], 1);
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.className), "skip");
    await page.keyboard.press("Tab");
    await page.keyboard.press("ArrowRight");
    await shows(page, "#table-note", "rows");
    assert.equal(await page.getAttribute("#tab-table", "aria-selected"), "true");
    await page.waitForFunction(() => document.querySelector("#announcer").textContent.includes("best number 3"));
  });
});

test("optimal masses that are rounded are not called exact", async () => {
  await visit("#m1=2&n=1&e=1/2", async (page) => {
    await answered(page);
    await page.check("#moving");
    await shows(page, "#masses-note", "≈ The optimal masses are irrational");
    await shows(page, ".quantity.eta .hint", "≈ for the optimal masses, which were rounded");
    await page.waitForFunction(() => location.hash.includes("rounded=yes"));
    await page.reload();
    await shows(page, "#masses-note", "≈ The optimal masses are irrational");
    await page.fill("#masses", "7/5");
    await shows(page, ".quantity.eta .hint", "exact");
    assert.equal(await page.textContent("#masses-note"), "");
    assert.ok(!(await page.textContent(".quantity.eta")).includes("≈ for the optimal"));
  });
  await visit("#m1=4&n=1&e=1/2", async (page) => {
    await answered(page);
    await page.check("#given");
    assert.equal(await page.textContent("#masses-note"), "", "2 is the optimal mass itself");
  });
});

test("a copied table keeps its fractions and leaves its buttons out", async () => {
  await visit("#m1=2&n=0&e=1/3&inserted=given&masses=3", async (page) => {
    await answered(page);
    await page.click("#collisions-card summary");
    await page.waitForSelector("#collisions tbody tr");
    const copied = async (selector) => {
      await page.evaluate((s) => getSelection().selectAllChildren(document.querySelector(s)), selector);
      await page.keyboard.press("Control+C");
      return page.evaluate(() => navigator.clipboard.readText());
    };
    const [head, first] = (await copied("#collisions")).split("\n");
    assert.equal(head, "No.\tBodies\tTime\tVelocities before\t\tVelocities after\t\tLost as heat");
    assert.equal(first, "1\t1–2\t1\t1\t0\t1/5\t8/15\t8/15");
    assert.doesNotMatch(await copied("#bodies"), /why\?/);
    assert.match(await copied("#bodies"), /^2 inserted\t3\t0\.3555\d+ = 16\/45\t/m);
    assert.equal(await copied("#collisions tbody td:nth-child(6)"), "1/5");
  });
});

test("the replay says at once why it has no collision", async () => {
  await visit("#m1=2&e=1/2&inserted=given&masses=1&velocities=2;1;0", async (page) => {
    await answered(page);
    await shows(page, "#event", "This replay has no collision: the bodies 1 to 3 touch");
  });
});

test("graphs and numbers of each body follow the player", async () => {
  await visit("#m1=2&n=0&e=1/2", async (page) => {
    await answered(page);
    await page.waitForSelector("#graph .curve");
    assert.equal(await page.locator("#graph .curve").count(), 2);
    await page.click("#motion summary");
    await page.waitForSelector("#now td");
    const numbers = () => page.$$eval("#now tbody tr", (rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent).join(" ")));
    const cursor = async () => Number(await page.getAttribute("#graph .zero", "x1"));
    assert.deepEqual(await numbers(), ["1 1 2 1", "2 0 0 0"]);
    assert.equal(await cursor(), 0);
    await page.click("#forward");
    assert.deepEqual(await numbers(), ["1 0.5 1 0.25", "2 1 1 0.5"]);
    assert.ok(await cursor() > 10);
    for (const kind of ["places", "momenta", "energies"]) {
      await page.selectOption("#curve", kind);
      const [points, name] = [await page.getAttribute("#graph .curve", "points"), await page.getAttribute("#graph", "aria-label")];
      assert.doesNotMatch(points, /NaN|Infinity/);
      assert.match(name, { places: /position/, momenta: /momentum/, energies: /kinetic energy/ }[kind]);
    }
    await shoot(page, "graph");
  });
});

test("sliders set inserted masses and velocities, and Reset takes everything back", async () => {
  await visit("#m1=2&e=1/2&inserted=given&masses=1;1&velocities=1;0;0;0", async (page) => {
    await answered(page);
    assert.equal(await page.locator("#masses-sliders input").count(), 2);
    await page.focus("#v0-sliders label:nth-child(4) input");
    await page.keyboard.press("ArrowLeft");
    assert.equal(await page.inputValue("#v0"), "1, 0, 0, -0.01");
    await page.focus("#masses-sliders label:nth-child(2) input");
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.inputValue("#masses"), "1, 1.1");
    await shows(page, "#bodies td", "1.1");
    await page.click("#reset");
    await shows(page, ".quantity.eta .decimal", "0.37313");
    assert.equal(await page.evaluate(() => location.hash), "");
    assert.equal(await page.isVisible("#v0-sliders"), false);
    await page.goBack();
    await page.waitForFunction(() => document.querySelector("#masses").value === "1, 1.1");
  });
});

test("fewer bodies and more again leave the lists as they were typed", async () => {
  await visit("#m1=2&e=1/2,1/3,1/4&inserted=given&masses=1;1&velocities=1;0;0;-1&gaps=1;2;3", async (page) => {
    await answered(page);
    await page.fill("#masses", "1");
    assert.equal(await page.inputValue("#v0"), "1, 0, 0");
    await page.fill("#masses", "1, 1");
    assert.equal(await page.inputValue("#v0"), "1, 0, 0, -1");
    assert.equal(await page.inputValue("#e"), "1/2, 1/3, 1/4");
    assert.equal(await page.inputValue("#gaps"), "1, 2, 3");
    await page.uncheck("#each");
    assert.equal(await page.inputValue("#e"), "1/2");
    await page.check("#each");
    assert.equal(await page.inputValue("#e"), "1/2, 1/3, 1/4");
  });
});

test("bodies and collisions are saved as CSV, all of them", async () => {
  await visit("#m1=2&n=0&e=1/3&inserted=given&masses=3", async (page) => {
    await answered(page);
    await page.waitForSelector("#collisions tbody tr", { state: "attached" });
    const saved = async (selector) => {
      const [file] = await Promise.all([page.waitForEvent("download"), page.click(selector)]);
      return readFileSync(await file.path(), "utf8").split("\n");
    };
    assert.deepEqual((await saved("#bodies-save")).slice(0, 2), ["body,mass,velocity_after_the_pass,heat_of_the_collision_with_the_next", "1,2,1/5,8/15"]);
    await page.click("#collisions-card summary");
    const lines = await saved("#collisions-save");
    assert.equal(lines[1], "1,1–2,1,1,0,1/5,8/15,8/15");
    assert.equal(lines.length - 2, await page.locator("#collisions tbody tr").count());
  });
});

test("a body is dragged to another place, and walls are those of the fields", async () => {
  await visit("#m1=2&n=0&e=1&velocities=1,+-1", async (page) => {
    await answered(page);
    await page.waitForSelector("#stage g circle");
    await page.locator("#time").fill("0");
    assert.equal(await page.locator("#placed").isChecked(), false);
    const drag = async (body, by) => {
      const box = await page.locator("#stage circle").nth(body).boundingBox();
      const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + by, y, { steps: 5 });
      await page.mouse.up();
    };
    // The second body to the right: the way between the two grows, and the fields are there.
    await drag(1, 60);
    await page.waitForFunction(() => Number(document.getElementById("gaps").value) > 1);
    assert.ok(await page.locator("#gaps").isVisible() && await page.locator("#placed").isChecked());
    // With walls a body goes no farther than to its wall.
    for (const [id, text] of [["gaps", "2"], ["left", "1"], ["right", "0,5"], ["wall", "90 %"]]) await page.fill(`#${id}`, text);
    await page.waitForFunction(() => document.querySelectorAll("#stage .wall").length === 2);
    await shows(page, "#totals", "which the walls change");
    await page.locator("#time").fill("0");
    await drag(0, -900);
    await page.waitForFunction(() => document.getElementById("left").value === "0");
    assert.equal(await page.inputValue("#gaps"), "3");
    assert.equal(await page.inputValue("#right"), "0,5", "what was typed and not dragged stays");
    await page.click("#view-all");
    await page.click("#forward");
    await page.click("#forward");
    await shows(page, "#event", "wall");
    await shoot(page, "walls");
    await page.fill("#left", "far");
    await shows(page, "#left-error", "far");
    await page.reload();
    assert.equal(await page.inputValue("#right"), "0,5", "a link keeps the walls");
  });
});

test("embedded, a room stands alone", async () => {
  await visit("?embed=1#m1=2&n=0&e=1/2", async (page) => {
    await answered(page);
    assert.equal(await page.isVisible("header"), false);
    assert.equal(await page.isVisible("footer"), false);
    assert.ok(await page.isVisible("#play"));
    await page.click("#reset");
    await page.waitForFunction(() => !location.hash && location.search === "?embed=1");
  });
});

test("a statement without a head is judged, and its declarations are proposed", async () => {
  await visit("#room=claims", async (page) => {
    await shows(page, "#verdicts .badge", "refuted");
    await page.fill("#claim-text", "given x real\nprove x^2 >= 0");
    await shows(page, "#verdicts .badge", "proved");
    await page.fill("#claim-text", "p = m*v");
    await shows(page, "#verdicts pre", "given p, m, v real\nprove p = m*v");
    // The marks are at the names as they are typed.
    assert.deepEqual(await page.$$eval("#mirror mark", (marks) => marks.map((mark) => mark.textContent)), ["p", "m", "v"]);
    await shows(page, "#faults button", "line 1, column 1");
    await page.click("#verdicts button");
    await shows(page, "#verdicts .badge", "refuted");
    assert.doesNotMatch(await page.inputValue("#claim-text"), /#/);
    await page.fill("#claim-text", "claim a “A”\ngiven x real\nprove x^2 >= 0");
    await shows(page, "#verdicts .badge", "proved");
    assert.equal(await page.textContent("#faults"), "");
  });
});

test("an unreadable guess takes the verdict of the former one away", async () => {
  await visit("", async (page) => {
    await answered(page);
    await page.click("#predict");
    await page.fill("#guess", "0.5");
    await page.click("#check");
    await shows(page, "#mark", "Too large");
    await page.fill("#guess", "abc");
    await page.click("#check");
    await shows(page, "#guess-error", "abc");
    assert.equal(await page.textContent("#mark"), "");
  });
});

test("advice in the classroom names what is on the page", async () => {
  await visit("#room=classroom", async (page) => {
    await shows(page, "#bounced", "e = ");
    await page.fill("#b-readings", "1.2, 0.77, 0.49");
    await shows(page, "#bounce-form .error", "write one reading a line");
    await page.fill("#b-within", "");
    await page.fill("#b-readings", "1.2\n0.77\n0.49\n0.31");
    await shows(page, "#bounced", 'fill in "Each reading is within ±"');
    assert.doesNotMatch(await page.textContent("#bounced"), /--/);
    await page.fill("#w-masses", "10 5 2");
    await shows(page, "#sheet-form .error", "separate numbers by semicolons: 10; 5; 2");
  });
});
