// A server for web/dist, a fresh Chromium, and pages whose every complaint counts as a failure.

import { mkdirSync, mkdtempSync, readFileSync, rmSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join, normalize } from "node:path";
import { chromium } from "playwright-core";

export const DIST = process.env.DIST ?? new URL("../dist/", import.meta.url).pathname;
/** Where pictures of what was tried go. */
export const SHOTS = new URL("../shots/", import.meta.url).pathname;
mkdirSync(SHOTS, { recursive: true });

const TYPES = {
  ".html": "text/html; charset=utf-8", ".js": "text/javascript", ".css": "text/css",
  ".svg": "image/svg+xml", ".webmanifest": "application/manifest+json",
};

/** Serves web/dist until it is closed. */
export async function serve() {
  const server = createServer((request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, "http://x").pathname));
    const file = join(DIST, path.endsWith("/") ? `${path}index.html` : path);
    try {
      if (!file.startsWith(DIST) || !statSync(file).isFile()) throw new Error("no such file");
      response.writeHead(200, { "Content-Type": TYPES[extname(file)] ?? "text/plain", "Cache-Control": "no-cache" });
      response.end(readFileSync(file));
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const close = () => new Promise((done) => {
    server.close(done);
    server.closeAllConnections();
  });
  return { url: `http://127.0.0.1:${server.address().port}/`, close };
}

/** Chromium with an empty profile. */
export async function browser(options = {}) {
  const profile = mkdtempSync(join(tmpdir(), "carom-lab-"));
  const launch = () => chromium.launchPersistentContext(profile, {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    acceptDownloads: true,
    args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync"],
    viewport: { width: 1280, height: 900 },
    permissions: ["clipboard-read", "clipboard-write"],
    ...options,
  });
  // On a loaded machine Chromium may break off while it starts; that says nothing about the lab.
  const context = await launch().catch(launch);
  const close = async () => {
    await context.close();
    rmSync(profile, { recursive: true, force: true });
  };
  return { context, close };
}

/** A page that keeps what it complains of. */
export async function listen(context) {
  const page = await context.newPage();
  const complaints = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) complaints.push(`${message.type()}: ${message.text()}`);
  });
  page.on("pageerror", (error) => complaints.push(`exception: ${error.message}`));
  page.on("dialog", (dialog) => {
    complaints.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  return { page, complaints };
}

/** A fresh browser on a fresh page of the lab; the page must not complain. */
export async function visit(fragment, work, options = {}) {
  const { context, close } = await browser(options);
  // After the browser: a server that is left open would keep the tests from ending.
  const server = await serve();
  try {
    const { page, complaints } = await listen(context);
    await page.goto(server.url + fragment);
    await work(page, { server, context });
    if (complaints.length) throw new Error(`the page complains: ${complaints.join("; ")}`);
  } finally {
    await close();
    await server.close();
  }
}

export const answered = (page) => page.waitForFunction(() => document.documentElement.dataset.firstAnswer, null, { timeout: 30_000 });
export const shoot = (page, name, fullPage = true) => page.screenshot({ path: `${SHOTS}${name}.png`, fullPage });
export const eta = (page) => page.textContent(".quantity.eta .decimal");
export const shows = (page, selector, text) => page.waitForFunction(
  ([s, t]) => [...document.querySelectorAll(s)].some((node) => node.textContent.includes(t)), [selector, text], { timeout: 30_000 });
