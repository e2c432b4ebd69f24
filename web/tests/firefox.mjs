// The lab in Firefox, driven over WebDriver BiDi, which every Firefox speaks: node --experimental-websocket --test …

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { SHOTS, serve } from "./browser.mjs";

const FIREFOX = process.env.FIREFOX ?? "/usr/bin/firefox-esr";
const PATIENCE = 60_000;

/** A Firefox with an empty profile: commands, and what its page complains of. */
async function firefox() {
  const profile = mkdtempSync(join(tmpdir(), "carom-firefox-"));
  const child = spawn(FIREFOX, ["--headless", "--no-remote", "--profile", profile, "--remote-debugging-port", "0"], { stdio: ["ignore", "ignore", "pipe"] });
  const address = await new Promise((done, failed) => {
    let said = "";
    child.stderr.on("data", (text) => {
      said += text;
      const found = /WebDriver BiDi listening on (ws:\S+)/.exec(said);
      if (found) done(found[1]);
    });
    child.once("exit", () => failed(new Error(`Firefox ended: ${said}`)));
  });
  const socket = new WebSocket(`${address}/session`);
  await new Promise((done, failed) => { socket.onopen = done; socket.onerror = failed; });
  const waiting = new Map();
  const complaints = [];
  let serial = 0;
  socket.onmessage = ({ data }) => {
    const message = JSON.parse(data);
    if (message.type === "event") {
      if (message.method === "log.entryAdded" && ["error", "warn"].includes(message.params.level)) complaints.push(message.params.text);
      return;
    }
    const { done, failed } = waiting.get(message.id);
    waiting.delete(message.id);
    if (message.type === "success") done(message.result);
    else failed(new Error(`${message.error}: ${message.message}`));
  };
  const send = (method, params) => new Promise((done, failed) => {
    waiting.set(++serial, { done, failed });
    socket.send(JSON.stringify({ id: serial, method, params }));
  });
  await send("session.new", { capabilities: {} });
  await send("session.subscribe", { events: ["log.entryAdded"] });
  const context = (await send("browsingContext.getTree", {})).contexts[0].context;
  const close = async () => {
    await send("browser.close", {}).catch(() => {});
    await new Promise((done) => (child.exitCode === null ? child.once("exit", done) : done()));
    rmSync(profile, { recursive: true, force: true });
  };
  return { send, context, complaints, close };
}

/** A page of the lab in Firefox; it must not complain. */
async function visit(fragment, work) {
  const server = await serve();
  const { send, context, complaints, close } = await firefox();
  /** The value of an expression on the page, as JSON. */
  const value = async (expression) => {
    const found = await send("script.evaluate", { expression: `(async () => JSON.stringify(await (${expression})))()`, target: { context }, awaitPromise: true, userActivation: true });
    assert.equal(found.type, "success", JSON.stringify(found.exceptionDetails?.text));
    return found.result.value === undefined ? undefined : JSON.parse(found.result.value);
  };
  const until = async (expression) => {
    const begun = Date.now();
    while (!(await value(`Boolean(${expression})`))) {
      assert.ok(Date.now() - begun < PATIENCE, `never: ${expression}`);
      await new Promise((done) => setTimeout(done, 100));
    }
  };
  const type = (id, text) => value(`(() => { const field = document.getElementById(${JSON.stringify(id)}); field.value = ${JSON.stringify(text)};
    field.dispatchEvent(new Event("input", { bubbles: true })); return true; })()`);
  const click = (selector) => value(`(() => { document.querySelector(${JSON.stringify(selector)}).click(); return true; })()`);
  const shows = (selector, text) => until(`[...document.querySelectorAll(${JSON.stringify(selector)})].some((n) => n.textContent.includes(${JSON.stringify(text)}))`);
  const shoot = async (name) => {
    const { data } = await send("browsingContext.captureScreenshot", { context });
    writeFileSync(join(SHOTS, `${name}.png`), Buffer.from(data, "base64"));
  };
  const size = (width, height) => send("browsingContext.setViewport", { context, viewport: { width, height } });
  try {
    await size(1280, 900);
    await send("browsingContext.navigate", { context, url: server.url + fragment, wait: "complete" });
    await work({ value, until, type, click, shows, shoot, size });
    assert.deepEqual(complaints, []);
  } finally {
    await close();
    await server.close();
  }
}

test("Firefox: answers, replay and bars of a chain", async () => {
  await visit("", async ({ value, until, type, click, shows, shoot, size }) => {
    await until("document.documentElement.dataset.firstAnswer");
    assert.equal(await value('document.querySelector(".quantity.eta .decimal").textContent'), "0.373137511773739");
    await until('document.querySelectorAll("#stage g").length === 9');
    await click("#forward");
    await shows("#event", "1 of 8");
    const before = await value('document.querySelector("#stage g").getAttribute("transform")');
    await click("#play");
    await until(`document.querySelector("#stage g").getAttribute("transform") !== ${JSON.stringify(before)}`);
    await click("#play");
    assert.ok((await value('document.querySelectorAll("#bars .piece").length')) >= 18);
    await shoot("firefox-chain");
    await type("e", "0,5");
    await shows("#bodies td", "0.0");
    await until('document.querySelector(".quantity.best-n .decimal").textContent === "0"');
    await click(".quantity.eta .why");
    await shows("#why-body .badge", "proved");
    await shoot("firefox-why");
    await click("#why-close");
    await size(390, 844);
    await value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))");
    assert.equal(await value("document.documentElement.scrollWidth - document.documentElement.clientWidth"), 0);
    await value('(() => { document.getElementById("e-slider").scrollIntoView({ block: "center" }); return true; })()');
    const { top, bottom } = await value('(() => { const { top, bottom } = document.getElementById("stage").getBoundingClientRect(); return { top, bottom }; })()');
    assert.ok(top >= -1 && bottom < 400, `the stage lies from ${top} to ${bottom}`);
    await shoot("firefox-phone");
  });
});

test("Firefox: tables, claims, the catalogue and Back", async () => {
  await visit("#room=table", async ({ value, until, type, click, shows, shoot }) => {
    await shows("#table-note", "60 rows");
    await click("#tab-claims");
    await shows("#verdicts .badge", "refuted");
    await shows("#tally", "claims:");
    assert.ok((await value('[...document.querySelectorAll("#catalogue .badge")].filter((n) => n.textContent.includes("refuted")).length')) >= 9);
    await type("claim-text", 'claim two "Two"\nprove 1 + 1 = 2\n');
    assert.equal(await value('document.getElementById("verdicts").getAttribute("aria-hidden")'), "true");
    await shows("#verdicts .badge", "proved");
    await shoot("firefox-claims");
    await value("(() => { history.back(); return true; })()");
    await until('document.title.startsWith("Table") && !document.getElementById("panel-table").hidden');
  });
});

test("Firefox: the classroom", async () => {
  await visit("#room=classroom", async ({ value, until, type, size, shows, shoot }) => {
    await shows("#sheets h3", "answer key");
    await shows("#checked-summary", "3 cells: 2 right");
    await shows("#bounced .said", "e = 0.799 ± 0.006");
    await type("w-versions", "2");
    await shows("#sheets .foot", "version B");
    await shoot("firefox-classroom");
    await size(390, 844);
    await value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))");
    await until("document.documentElement.scrollWidth === document.documentElement.clientWidth");
  });
});

test("Firefox: kept for use offline", async () => {
  await visit("", async ({ until, value }) => {
    await until('document.documentElement.dataset.offline === "ready"');
    const kept = await value("(async () => { const [name] = await caches.keys(); return (await (await caches.open(name)).keys()).length; })()");
    assert.ok(kept > 25, `${kept} files`);
  });
});
