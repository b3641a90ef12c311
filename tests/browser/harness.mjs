// Starts `pathlight serve` on a free port, and Chromium with a profile of its own; every browser test begins with it.
//
//     const session = await start();
//     const page = await session.open('/');
//     await session.stop();        // fails if the page complained in its console
//
// Knows nothing of what is on the page.

import { spawn } from "node:child_process";
import { once } from "node:events";
import { existsSync } from "node:fs";
import { dirname, join } from "node:path";
import { createInterface } from "node:readline";
import { afterEach, beforeEach } from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const root = join(dirname(fileURLToPath(import.meta.url)), "..", "..");

export const binary = join(root, "target", "release", "pathlight");

const flags = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
];

/**
 * Starts a server of the built page and a browser.
 * @param {{ dir?: string }} [options] `dir`: another folder
 */
export async function start({ dir = "target/page" } = {}) {
  return startOn(await startServer(["--dir", dir]));
}

/**
 * Starts a browser for a server that runs already.
 * @param {{ origin: string, stop: () => Promise<unknown> }} server `origin` is where the page is, without the last
 *   slash
 * @param {string[]} [further] flags of the browser
 */
export async function startOn(server, further = []) {
  return new Session(server, await launch(further));
}

/** Starts a browser only. */
export function launch(further = []) {
  return chromium.launch({ executablePath: findChromium(), headless: true, args: [...flags, ...further] });
}

/** The browsers of the sessions that have not ended. @type {Set<import('playwright-core').Browser>} */
const browsers = new Set();

// Pages that a test has opened are closed after it: they move, and would slow the next tests down.
if (process.env.NODE_TEST_CONTEXT) {
  const contexts = () => [...browsers].flatMap((browser) => browser.contexts());
  let before = new Set();
  beforeEach(() => {
    before = new Set(contexts());
  });
  afterEach(async () => {
    const opened = contexts().filter((context) => !before.has(context));
    await Promise.all(opened.map((context) => context.close()));
  });
}

class Session {
  /** The problems of the pages: errors in the console, uncaught exceptions, failed requests. */
  problems = [];

  #server;
  /** Playwright's. */
  browser;

  constructor(server, browser) {
    this.#server = server;
    this.browser = browser;
    browsers.add(browser);
    /** `http://127.0.0.1:PORT` */
    this.origin = server.origin;
  }

  /**
   * Opens a path (or nothing yet, if empty) in a new page with a fresh profile; `options` are Playwright's for a
   * context (viewport, …).
   */
  async open(path = "/", options = {}) {
    return this.openIn(await this.browser.newContext(options), path);
  }

  /** Opens a path in a new page of a context of Playwright's, whose pages share a profile. */
  async openIn(context, path = "/") {
    // A machine under load may take much longer than usual.
    context.setDefaultTimeout(90_000);
    const page = await context.newPage();
    page.on("console", (message) => {
      if (message.type() === "error") this.problems.push(`console: ${message.text()}`);
    });
    page.on("pageerror", (error) => this.problems.push(`uncaught: ${error.message}`));
    page.on("requestfailed", (request) => {
      const why = request.failure()?.errorText;
      // A page that is left aborts what it was still loading; that is not a failure.
      if (why !== "net::ERR_ABORTED") this.problems.push(`failed: ${request.url()} ${why}`);
    });
    if (path) await page.goto(this.origin + path);
    return page;
  }

  /** Returns the problems so far and forgets them: the test expected them. */
  takeProblems() {
    return this.problems.splice(0);
  }

  /** Ends browser and server. Throws if there are problems that no test expected. */
  async stop() {
    browsers.delete(this.browser);
    await this.browser.close();
    await this.#server.stop();
    if (this.problems.length > 0) throw new Error(`The page complained:\n${this.problems.join("\n")}`);
  }
}

/**
 * Starts a server only, with arguments of `pathlight serve`.
 * @param {string[]} serve
 */
export async function startServer(serve) {
  if (!existsSync(binary)) throw new Error(`${binary} is missing: run make build`);
  const child = spawn(binary, ["serve", "--port", "0", ...serve], { cwd: root, stdio: ["ignore", "pipe", "pipe"] });
  const closed = once(child, "close");
  let said = "";
  child.stderr.on("data", (text) => (said += text));
  process.once("exit", () => child.kill());
  for await (const line of createInterface({ input: child.stdout })) {
    const origin = line.match(/http:\/\/[^/]+/)?.[0];
    if (origin) return { origin, stop: () => stopped(child) };
  }
  // What it says of the reason may come after the end of its output.
  await closed;
  throw new Error(`pathlight serve did not start: ${said}`);
}

/** @param {import('node:child_process').ChildProcess} child */
async function stopped(child) {
  child.kill("SIGINT");
  if (child.exitCode === null) await once(child, "exit");
}

/**
 * Waits until what has changed is painted: a canvas is drawn at the frame that follows.
 * @param {import('playwright-core').Page} page
 */
export async function painted(page) {
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
}

function findChromium() {
  const places = process.env.CHROMIUM
    ? [process.env.CHROMIUM]
    : ["chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "google-chrome-stable"].map(
        (name) => `/usr/bin/${name}`,
      );
  const found = places.find(existsSync);
  if (!found)
    throw new Error(`Chromium is missing (looked at ${places.join(", ")}): install it, or set CHROMIUM to its path`);
  return found;
}
