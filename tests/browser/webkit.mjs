// Starts WebKitGTK's MiniBrowser on a display of its own, over WebDriver: Debian's webkit2gtk-driver and xvfb. Its
// pages have the part of Puppeteer's interface that the tests need.
//
//     const webkit = await startWebKit();
//     const page = await webkit.newPage();
//     await webkit.close();

import { spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import { createServer } from "node:net";
import { createInterface } from "node:readline";
import { setTimeout as wait } from "node:timers/promises";

/** It prints what pages write to the console, in lines that begin so. */
const CONSOLE = /^CONSOLE \S+ (ERROR|WARN) (.*)$/;
const SETTINGS = ["--automation", "--enable-write-console-messages-to-stdout=true"];
/** As WebDriver writes them. */
const KEYS = { Tab: "\uE004" };
/** For a script or a page, ms. */
const TIMEOUT = 600_000;
/** Between two looks at a condition, ms. */
const LOOK = 50;

/** Why WebKit cannot be started here, or null. */
export function whyNoWebKit() {
  const missing = ["WebKitWebDriver", "Xvfb"].filter(
    (command) => spawnSync(command, ["-help"], { timeout: 10_000 }).error,
  );
  return missing.length ? `${missing.join(" and ")} cannot be started: apt-get install webkit2gtk-driver xvfb` : null;
}

export async function startWebKit() {
  const display = spawn("Xvfb", ["-displayfd", "1", "-screen", "0", "1280x1024x24", "-nolisten", "tcp"], {
    stdio: ["ignore", "pipe", "ignore"],
  });
  const [number] = await once(createInterface({ input: display.stdout }), "line");
  const port = await freePort();
  // As root WebKit has no sandbox, and no display here has a graphics card.
  const env = {
    ...process.env,
    DISPLAY: `:${number}`,
    WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: "1",
    LIBGL_ALWAYS_SOFTWARE: "1",
  };
  const driver = spawn("WebKitWebDriver", [`--port=${port}`], { stdio: ["ignore", "pipe", "ignore"], env });
  process.once("exit", () => [driver, display].forEach((child) => child.kill()));
  return new WebKit(port, driver, display);
}

class WebKit {
  /** Errors and warnings in the console. */
  problems = /** @type {string[]} */ ([]);
  #port;
  #children;
  #session = "";

  /**
   * @param {number} port
   * @param {import('node:child_process').ChildProcess} driver
   * @param {import('node:child_process').ChildProcess} display
   */
  constructor(port, driver, display) {
    this.#port = port;
    this.#children = [driver, display];
    createInterface({ input: /** @type {import('node:stream').Readable} */ (driver.stdout) }).on("line", (line) => {
      const problem = line.match(CONSOLE)?.[2];
      if (problem) this.problems.push(problem);
    });
  }

  async newPage() {
    const alwaysMatch = {
      "webkitgtk:browserOptions": { args: SETTINGS },
      timeouts: { script: TIMEOUT, pageLoad: TIMEOUT },
    };
    const { sessionId } = await this.command("POST", "/session", { capabilities: { alwaysMatch } });
    this.#session = `/session/${sessionId}`;
    return new Page((method, path, body) => this.command(method, this.#session + path, body));
  }

  /**
   * @param {string} method
   * @param {string} path
   * @param {object} [body]
   */
  async command(method, path, body) {
    const answer = await this.#reached(() =>
      fetch(`http://127.0.0.1:${this.#port}${path}`, { method, body: body && JSON.stringify(body) }),
    );
    const { value } = await answer.json();
    if (!answer.ok) throw new Error(`WebKit answered ${method} ${path}: ${value.error}: ${value.message}`);
    return value;
  }

  /** The driver listens some moments after it has been started. */
  async #reached(ask) {
    for (const end = Date.now() + TIMEOUT; ; await wait(LOOK)) {
      try {
        return await ask();
      } catch (error) {
        if (this.#session || Date.now() > end) throw error;
      }
    }
  }

  async close() {
    if (this.#session) await this.command("DELETE", this.#session);
    for (const child of this.#children) child.kill();
  }
}

class Page {
  #command;

  /** @param {(method: string, path: string, body?: object) => Promise<any>} command of the session */
  constructor(command) {
    this.#command = command;
  }

  mouse = {
    click: (x, y) =>
      this.#act("pointer", [
        { type: "pointerMove", x: Math.round(x), y: Math.round(y) },
        { type: "pointerDown", button: 0 },
        { type: "pointerUp", button: 0 },
      ]),
  };

  keyboard = {
    type: (text) =>
      this.#act(
        "key",
        [...text].flatMap((value) => [
          { type: "keyDown", value },
          { type: "keyUp", value },
        ]),
      ),
    press: (key) => this.keyboard.type(KEYS[key]),
  };

  /** @param {string} url */
  goto(url) {
    return this.#command("POST", "/url", { url });
  }

  reload() {
    return this.#command("POST", "/refresh", {});
  }

  /** @param {(...args: any[]) => unknown} inPage */
  evaluate(inPage, ...args) {
    return this.#command("POST", "/execute/sync", { script: `return (${inPage})(...arguments);`, args });
  }

  /** @param {(...args: any[]) => unknown} inPage */
  async waitForFunction(inPage, { timeout }, ...args) {
    for (const end = Date.now() + timeout; !(await this.evaluate(inPage, ...args)); await wait(LOOK)) {
      if (Date.now() > end) throw new Error(`${timeout} ms were not enough for ${inPage} of ${args}`);
    }
  }

  /**
   * @param {'pointer' | 'key'} type
   * @param {object[]} actions
   */
  #act(type, actions) {
    return this.#command("POST", "/actions", { actions: [{ type, id: type, actions }] });
  }
}

async function freePort() {
  const server = createServer().listen(0, "127.0.0.1");
  await once(server, "listening");
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  await new Promise((closed) => server.close(closed));
  return port;
}
