// A person who does anything at all: clicks whatever is there, presses keys, drags in the scene, types nonsense, goes
// back and forward, reloads, turns the phone. All is drawn from a seed.
//
//     const walk = new RandomWalk(page, seed);
//     await walk.step();
//     walk.log;            // what was done, a line each

/** @typedef {import('playwright-core').Page} Page */

const TASKS = ["00000:000", "00007:008", "00013:002", "00024:099"];
const KEYS = [
  "Tab",
  "Shift+Tab",
  "Enter",
  "Space",
  "Escape",
  "ArrowLeft",
  "ArrowRight",
  "ArrowUp",
  "ArrowDown",
  "Shift+ArrowUp",
  "Home",
  "End",
  "PageDown",
  "PageUp",
  "Control+z",
  "Control+y",
  "Control+Shift+z",
  "Delete",
  "Backspace",
  "+",
  "-",
  ".",
  ",",
  "[",
  "]",
  "?",
  "1",
  "2",
  "3",
  "4",
  "5",
  "6",
  "d",
  "n",
  "N",
  "p",
  "r",
  "v",
  "x",
];
const TEXTS = ["", "0", "5", "-3", "128", "255", "32", "1e9", "0.5", "999", "soup", "…<b>", "00007:008"];
const FRAGMENTS = [
  "",
  "#",
  "#soup",
  "#task=99999:999",
  "#task=00007:008&panel=soup",
  "#view=results",
  "#view=results&model=cross-0",
  "#view=learns",
  "#task=00000:000&ball=60,240,12",
  "#task=00000:000&panel=compare&model=cross-0",
  "#task=00001:005&view=presentation",
  "#task=00001:005&view=presentation&step=success",
  "#task=00002:007&panel=imagine&layers=base,target",
  "#task=00002:007&hide=puzzles,tools,imagine",
  "#task=00000:000&proposal=3&panel=compare",
  "#task=00003:001&challenge=2",
  "#scene=soup",
  "#task=00000:000&panel=make",
  "#task=00000:000&forecast=on&ball=100,200,20",
  "#task=00004:004&model=soup&panel=imagine",
];
const FILES = [
  { name: "soup.json", mimeType: "application/json", buffer: Buffer.from("soup") },
  { name: "empty.json", mimeType: "application/json", buffer: Buffer.from("") },
  {
    name: "progress.json",
    mimeType: "application/json",
    buffer: Buffer.from('{"tasks":{"00007:008":{"attempts":3,"solved":2}}}'),
  },
];
const VIEWPORTS = [
  { width: 1280, height: 800 },
  { width: 390, height: 844 },
  { width: 844, height: 390 },
  { width: 320, height: 480 },
];

export class RandomWalk {
  /** What was done. */
  log = /** @type {string[]} */ ([]);
  #page;
  #random;
  /** @type {[share: number, act: () => Promise<string>][]} */
  #acts;

  /**
   * @param {Page} page
   * @param {number} seed
   */
  constructor(page, seed) {
    this.#page = page;
    this.#random = mulberry32(seed);
    this.#acts = [
      [36, () => this.#useControl()],
      [16, () => this.#press()],
      [8, () => this.#clickScene()],
      [9, () => this.#drag()],
      [8, () => this.#run()],
      [3, () => this.#wheel()],
      [5, () => this.#go()],
      [2, () => this.#reload()],
      [3, () => this.#follow()],
      [3, () => this.#changeScreen()],
      [7, () => this.#wait()],
    ];
    page.on("filechooser", (chooser) => chooser.setFiles(this.#any(FILES)).catch(() => {}));
    page.on("download", (download) => download.delete().catch(() => {}));
    page.on("dialog", (dialog) => dialog.dismiss().catch(() => {}));
  }

  /** Does one thing, and returns in words what it was. */
  async step() {
    let left = this.#random() * this.#acts.reduce((sum, [share]) => sum + share, 0);
    const [, act] = this.#acts.find(([share]) => (left -= share) < 0) ?? this.#acts[0];
    const words = await act();
    this.log.push(words);
    return words;
  }

  /**
   * @template Item
   * @param {readonly Item[]} list
   */
  #any(list) {
    return list[Math.floor(this.#random() * list.length)];
  }

  #coordinate() {
    return this.#random() * 256;
  }

  /**
   * Uses any control that can be seen: those of a kind count as one, so that a hundred links are not all that is
   * clicked.
   */
  async #useControl() {
    const found = await this.#page.evaluateHandle(controlInPage, [this.#random(), this.#random()]);
    const control = found.asElement();
    if (!control) return "no control";
    const { name, kind, type, seen, gone } = await control.evaluate(describe);
    if (gone) return `${name} has gone`;
    if (kind === "SELECT") {
      const index = await control.evaluate(
        (select, part) => Math.floor(part * /** @type {HTMLSelectElement} */ (select).options.length),
        this.#random(),
      );
      await control.selectOption({ index }, { timeout: 2000 }).catch(() => {});
      return `chooses ${index} of ${name}`;
    }
    if (type === "number" || type === "text") {
      const text = this.#any(TEXTS);
      await control.evaluate((input) => /** @type {HTMLInputElement} */ (input).select());
      await this.#page.keyboard.insertText(text);
      if (!text) await this.#page.keyboard.press("Delete");
      await this.#page.keyboard.press(this.#any(["Tab", "Enter", "a"]));
      return `types “${text}” into ${name}`;
    }
    if (!seen || this.#random() < 0.15) {
      await control.focus();
      const key = this.#any(["Enter", "Space"]);
      await this.#page.keyboard.press(key);
      return `focuses ${name} and presses ${key}`;
    }
    const box = await control.boundingBox();
    if (!box) return `${name} has gone`;
    const clickCount = this.#random() < 0.1 ? 2 : 1;
    const across = type === "range" ? this.#random() : 0.5;
    await this.#page.mouse.click(box.x + box.width * across, box.y + box.height / 2, { clickCount });
    return `clicks ${name}${clickCount > 1 ? " twice" : ""}`;
  }

  async #press() {
    const key = this.#any(KEYS);
    const times = this.#random() < 0.2 ? 5 : 1;
    for (let count = 0; count < times; count++) await this.#page.keyboard.press(key);
    return `presses ${key}${times > 1 ? ` ${times} times` : ""}`;
  }

  /**
   * Brings the scene into sight, and returns what turns px of it into a place on the screen; null if there is none.
   * @returns {Promise<((x: number, y: number) => [number, number]) | null>}
   */
  async #toScene() {
    const box = await this.#page.evaluate(() => {
      const scene = /** @type {any} */ (document.getElementById("puzzle")).shadowRoot.getElementById("scene");
      if (!scene?.checkVisibility()) return null;
      scene.scrollIntoView({ block: "center" });
      return scene.getBoundingClientRect().toJSON();
    });
    return box && ((x, y) => [box.x + (x / 256) * box.width, box.y + box.height - (y / 256) * box.height]);
  }

  async #clickScene() {
    const spot = await this.#toScene();
    if (!spot) return "no scene";
    const [x, y] = [this.#coordinate(), this.#coordinate()];
    await this.#page.mouse.click(...spot(x, y));
    return `clicks the scene at ${Math.round(x)}, ${Math.round(y)}`;
  }

  async #drag() {
    const spot = await this.#toScene();
    if (!spot) return "no scene";
    const points = Array.from({ length: 2 + Math.floor(this.#random() * 4) }, () =>
      spot(this.#coordinate() * 1.2 - 20, this.#coordinate() * 1.2 - 20),
    );
    await this.#page.mouse.move(...points[0]);
    await this.#page.mouse.down();
    for (const point of points) await this.#page.mouse.move(...point, { steps: 5 });
    // Sometimes a key or another puzzle comes while the button is down.
    const between = this.#random() < 0.3 ? this.#any(KEYS) : null;
    if (between) await this.#page.keyboard.press(between);
    await this.#page.mouse.up();
    return `drags over ${points.length} points${between ? `, presses ${between} meanwhile` : ""}`;
  }

  /** Places a ball and runs it, wherever the focus is. */
  async #run() {
    const spot = await this.#toScene();
    if (!spot) return "no scene";
    await this.#page.mouse.click(...spot(this.#coordinate(), 100 + this.#coordinate() * 0.6));
    await this.#page.keyboard.press("Enter");
    return "places a ball and runs it";
  }

  async #wheel() {
    const spot = await this.#toScene();
    if (!spot) return "no scene";
    await this.#page.mouse.move(...spot(this.#coordinate(), this.#coordinate()));
    const way = this.#any([-300, -100, 100, 300]);
    await this.#page.mouse.wheel(0, way);
    return `turns the wheel by ${way}`;
  }

  async #go() {
    const way = this.#any(["back", "back", "forward"]);
    // Not to the empty page before the first entry.
    const goes = await this.#page.evaluate(
      (way) =>
        (way === "back" ? navigation.canGoBack : navigation.canGoForward) && (setTimeout(() => history[way]()), true),
      way,
    );
    if (!goes) return `cannot go ${way}`;
    await this.#page.waitForTimeout(100);
    return `goes ${way}`;
  }

  async #reload() {
    await this.#page.reload();
    return "reloads";
  }

  async #follow() {
    const fragment = this.#random() < 0.5 ? `#task=${this.#any(TASKS)}` : this.#any(FRAGMENTS);
    await this.#page.evaluate((hash) => void (location.hash = hash), fragment);
    return `follows a link to ${fragment}`;
  }

  async #changeScreen() {
    if (this.#random() < 0.5) {
      const viewport = this.#any(VIEWPORTS);
      await this.#page.setViewportSize(viewport);
      return `looks at ${viewport.width} x ${viewport.height}`;
    }
    const [colorScheme, reducedMotion] = [
      this.#any(/** @type {const} */ (["dark", "light"])),
      this.#any(/** @type {const} */ (["reduce", "no-preference"])),
    ];
    await this.#page.emulateMedia({ colorScheme, reducedMotion });
    return `prefers ${colorScheme} and ${reducedMotion}`;
  }

  async #wait() {
    const time = this.#any([50, 200, 500, 1500]);
    await this.#page.waitForTimeout(time);
    return `waits ${time} ms`;
  }
}

/** Any control that can be used: first a kind is drawn, then one of the kind. */
function controlInPage([kindPart, onePart]) {
  const shadowRoot = /** @type {ShadowRoot} */ (document.getElementById("puzzle")?.shadowRoot);
  const all = [document, shadowRoot].flatMap((root) => [
    ...root.querySelectorAll('a[href], button, input:not([type=file]), select, summary, [tabindex="0"]'),
  ]);
  const dialog = [
    ...shadowRoot.querySelectorAll("dialog[open], :popover-open"),
    ...document.querySelectorAll("dialog[open]"),
  ].at(-1);
  const usable = all.filter((one) => {
    if (
      !one.checkVisibility({ visibilityProperty: true }) ||
      /** @type {HTMLButtonElement} */ (one).disabled ||
      one.closest("[inert]")
    )
      return false;
    if (dialog && !dialog.contains(one)) return false;
    return !(one instanceof HTMLAnchorElement) || one.origin === location.origin;
  });
  const kinds = Map.groupBy(
    usable,
    (one) => one.id || (one.closest("[id]")?.id ?? "") + one.tagName + (one.getAttribute("data-act") ?? ""),
  );
  const kind = [...kinds.values()][Math.floor(kindPart * kinds.size)];
  return kind?.[Math.floor(onePart * kind.length)] ?? null;
}

/** @param {any} control */
function describe(control) {
  control.scrollIntoView({ block: "center" });
  const box = control.getBoundingClientRect();
  const root = control.getRootNode();
  const hit =
    root instanceof Document || root instanceof ShadowRoot
      ? root.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2)
      : null;
  const name = `${control.id || `${control.closest("[id]")?.id} ${control.tagName.toLowerCase()}`} (${(control.textContent || control.title || control.getAttribute("aria-label") || "").trim().slice(0, 24)})`;
  return {
    name,
    kind: control.tagName,
    type: control instanceof HTMLInputElement ? control.type : "",
    seen: hit !== null && (control.contains(hit) || hit.contains(control)),
    gone: !control.isConnected,
  };
}

/**
 * Random numbers in 0..1 (mulberry32, by Tommy Ettinger, public domain).
 * @param {number} seed
 */
function mulberry32(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let bits = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    bits = (bits + Math.imul(bits ^ (bits >>> 7), 61 | bits)) ^ bits;
    return ((bits ^ (bits >>> 14)) >>> 0) / 4294967296;
  };
}
