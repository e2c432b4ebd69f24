// The lab over a slow line, from the server that web/serve starts: when the first answer comes, and what is sent twice.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { test } from "node:test";
import { DIST, answered, browser, listen, serve, shows, visit } from "./browser.mjs";

const SERVER = new URL("../server.py", import.meta.url).pathname;
/** Bits per second of a slow line, and milliseconds for a round trip. */
const LINE = 1_600_000;
const LATENCY = 150;
/** Milliseconds to the first answer over that line, on a machine that does other work meanwhile: more. */
const SLOW_ANSWER = Number(process.env.SLOW_ANSWER_MS ?? 9000);
/** The same in rooms that need the whole engine. */
const SLOW_ROOM = SLOW_ANSWER + 15_000;

async function served(work) {
  const server = spawn("python3", [SERVER, DIST, "0"], { stdio: ["ignore", "pipe", "inherit"] });
  try {
    const url = await new Promise((done) => server.stdout.once("data", (text) => done(String(text).trim().replace("localhost", "127.0.0.1"))));
    await work(`${url}/`);
  } finally {
    server.kill();
  }
}

test("web/serve compresses, and does not send again what the browser has", async () => {
  await served(async (url) => {
    const fetched = await fetch(`${url}first.js`);
    assert.equal(fetched.headers.get("content-encoding"), "gzip");
    assert.equal(fetched.headers.get("content-type"), "text/javascript; charset=utf-8");
    assert.ok(Number(fetched.headers.get("content-length")) < (await fetched.arrayBuffer()).byteLength / 2);
    const again = await fetch(`${url}first.js`, { headers: { "If-None-Match": fetched.headers.get("etag"), "Cache-Control": "no-cache" } });
    assert.equal(again.status, 304);
    // The engine is compressed as a file, and not a second time.
    const engine = await fetch(`${url}first.engine`);
    assert.equal(engine.headers.get("content-encoding"), null);
    assert.deepEqual([...new Uint8Array(await engine.arrayBuffer()).slice(0, 2)], [0x1f, 0x8b]);
    assert.equal((await fetch(`${url}../server.py`)).status, 404);
    assert.equal((await fetch(`${url}%2e%2e/server.py`)).status, 404);
    assert.equal((await fetch(`${url}nothing`)).status, 404);
    assert.equal((await fetch(url)).headers.get("content-type"), "text/html; charset=utf-8");
  });
});

/** An empty browser on a slow line; `work` is given a page that must not complain. */
async function slowly(work) {
  const { context, close } = await browser();
  try {
    const { page, complaints } = await listen(context);
    const line = await context.newCDPSession(page);
    await line.send("Network.enable");
    await line.send("Network.emulateNetworkConditions", { offline: false, latency: LATENCY, downloadThroughput: LINE / 8, uploadThroughput: LINE / 8 });
    await work(page);
    assert.deepEqual(complaints, []);
  } finally {
    await close();
  }
}

test("the first answer over 1.6 Mbit/s, and each part of the engine sent once", async () => {
  await served(async (url) => {
    await slowly(async (page) => {
      await page.goto(url);
      await answered(page);
      const first = Number(await page.evaluate(() => document.documentElement.dataset.firstAnswer));
      await page.waitForSelector("#stage g");
      const stage = await page.evaluate(() => performance.now());
      console.log(`  first answer ${first} ms, bodies on the stage ${stage.toFixed(0)} ms`);
      await page.waitForFunction(() => document.documentElement.dataset.offline === "ready", null, { timeout: 60_000 });
      const sizes = await page.evaluate(() => performance.getEntriesByType("resource").filter((e) => e.name.endsWith(".engine")).map((e) => [e.name.replace(/.*\//, ""), e.transferSize]));
      assert.deepEqual(sizes.map(([name]) => name).sort(), ["first.engine", "whole.engine"]);
      assert.ok(first <= SLOW_ANSWER, `${first} ms`);
    });
  });
});

test("every room answers over 1.6 Mbit/s from a server that compresses nothing", async () => {
  const server = await serve();
  try {
    for (const [room, most, shown] of [
      ["chain", SLOW_ANSWER, answered],
      ["table", SLOW_ROOM, (page) => shows(page, "#table-note", "rows")],
      ["claims", SLOW_ROOM, (page) => shows(page, "#verdicts .badge", "refuted")],
      ["classroom", SLOW_ROOM, (page) => shows(page, "#sheets h3", "answer key")],
    ]) {
      await slowly(async (page) => {
        await page.goto(`${server.url}#room=${room}`);
        await shown(page);
        const first = await page.evaluate(() => performance.now());
        console.log(`  first answer, room ${room}: ${first.toFixed(0)} ms`);
        assert.ok(first <= most, `${room}: ${first} ms`);
      });
    }
  } finally {
    await server.close();
  }
});

test("the offline cache asks, and is not sent what has come already", async () => {
  const server = spawn("python3", ["-u", "-c", `
import sys
sys.path.insert(0, ${JSON.stringify(new URL("..", import.meta.url).pathname)})
import server
def log(self, code="-", size="-"):
    print("REQUEST", self.path, code)
server.Handler.log_request = log
sys.argv = ["server.py", ${JSON.stringify(DIST)}, "0"]
server.main()
`], { stdio: ["ignore", "pipe", "inherit"] });
  let log = "";
  server.stdout.on("data", (text) => { log += text; });
  const { context, close } = await browser();
  try {
    while (!/http:\S+/.test(log)) await new Promise((done) => setTimeout(done, 50));
    const { page } = await listen(context);
    await page.goto(/http:\S+/.exec(log)[0]);
    await page.waitForFunction(() => document.documentElement.dataset.offline === "ready", null, { timeout: 60_000 });
    for (const part of ["first.engine", "whole.engine"]) {
      const codes = [...log.matchAll(new RegExp(`REQUEST /${part} (?:HTTPStatus\\.)?(\\S+)`, "g"))].map((m) => m[1]);
      const whole = codes.filter((code) => code === "200" || code === "OK").length;
      assert.equal(whole, 1, `${part}: ${codes}`);
    }
  } finally {
    await close();
    server.kill();
  }
});

test("nothing jumps while the page fills", async () => {
  for (const options of [{ viewport: { width: 1350, height: 940 } }, { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true }]) {
    await visit("", async (page) => {
      await page.addInitScript(() => {
        globalThis.shifts = [];
        new PerformanceObserver((list) => globalThis.shifts.push(...list.getEntries().map((e) => e.value))).observe({ type: "layout-shift", buffered: true });
      });
      await page.reload();
      await answered(page);
      await page.waitForSelector("#stage g");
      await page.waitForTimeout(1000);
      const all = await page.evaluate(() => globalThis.shifts.reduce((a, b) => a + b, 0));
      console.log(`  ${options.viewport.width} px: layout shift ${all.toFixed(3)}`);
      assert.ok(all < 0.1, `layout shift ${all}`);
    }, options);
  }
});
