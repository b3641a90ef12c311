// Whatever a person does, in whatever order, the page stays whole. STEPS and SEED in the environment walk further, or
// elsewhere.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { painted } from "./harness.mjs";
import { EASY, drop, known, modelIsThere, place, says, spot, startPlayer } from "./player.mjs";

const STEPS = Number(process.env.STEPS ?? 200);
const SEED = Number(process.env.SEED ?? 1);

let session;
before(async () => (session = await startPlayer()));
after(() => session.stop());

const KEYS = ["ArrowLeft", "Shift+ArrowUp", "ArrowDown", "Shift+ArrowRight", "+", "-", "Enter", "Space", "r", ",", "."];
const OTHER_KEYS = ["Control+z", "Control+y", "1", "2", "3", "4", "5", "[", "]", "n", "d", "Delete", "Escape"];
const LINKS = [
  "#",
  `#task=${EASY}`,
  "#task=00007:008&panel=imagine&step=run&ball=40,200,12",
  "#task=00002:017&challenge=2",
  "#task=00001:000&lesson=00001:000,00002:000&hide=puzzles,model",
  "#task=00003:000&view=presentation&panel=imagine",
  "#task=00004:000&panel=make",
  "#task=99:9&ball=0",
];

/** What a person can do; each says what it has done. */
const ACTIONS = [
  async (page, pick) => {
    const key = pick([...KEYS, ...KEYS, ...OTHER_KEYS]);
    const scene = page.getByRole("application");
    if (pick([true, true, false])) await scene.evaluate((canvas) => canvas.focus());
    await page.keyboard.press(key);
    return `key ${key}`;
  },
  async (page, pick) => {
    const count = await page.evaluate(controlsInPage, null);
    return `press ${await page.evaluate(controlsInPage, pick(Array.from({ length: count }, (_, index) => index)))}`;
  },
  async (page, pick) => {
    const point = () => [pick([10, 60, 128, 200, 250]), pick([5, 60, 128, 200, 250])];
    const [from, to] = [point(), point()];
    await page.mouse.move(...(await spot(page, from[0], from[1])));
    await page.mouse.down();
    await page.mouse.move(...(await spot(page, to[0], to[1])), { steps: 3 });
    await page.mouse.up();
    return `drag from ${from} to ${to}`;
  },
  async (page, pick) => {
    const link = pick(LINKS);
    await page.evaluate((link) => void (location.hash = link), link);
    return `go to ${link}`;
  },
  async (page, pick) => {
    const media = pick([{ colorScheme: "dark" }, { colorScheme: "light" }, { reducedMotion: "reduce" }]);
    await page.emulateMedia({ reducedMotion: "no-preference", ...media });
    await page.setViewportSize(
      pick([
        { width: 390, height: 664 },
        { width: 1280, height: 800 },
      ]),
    );
    return `look otherwise ${JSON.stringify(media)}`;
  },
];
/** How often each is done. */
const WEIGHTS = [0, 0, 0, 1, 1, 1, 1, 2, 3, 4].map((index) => ACTIONS[index]);

test(`${STEPS} steps from seed ${SEED}`, { timeout: 60_000 + STEPS * 3000 }, async () => {
  let state = SEED;
  const pick = (list) => list[Math.floor(((state = (state * 16807) % 2147483647) / 2147483647) * list.length)];
  const page = await session.open("");
  await page.goto(`${session.origin}/#task=${EASY}`);
  await modelIsThere(page);
  const done = [];
  for (let step = 0; step < STEPS; step++) {
    const hadFocus = await page.evaluate(() => document.activeElement !== document.body);
    done.push(await pick(WEIGHTS)(page, pick));
    await painted(page);
    // A pointer beside the scene takes it away, as in any page.
    const keepsFocus = hadFocus && !done.at(-1).startsWith("drag");
    const wrong = [...(await page.evaluate(wrongInPage, keepsFocus)), ...session.takeProblems()];
    assert.deepEqual(wrong, [], `seed ${SEED}, step ${step}:\n${done.slice(-12).join("\n")}`);
  }
  await page.keyboard.press("Escape");
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.evaluate((hash) => void (location.hash = hash), `#task=${EASY}`);
  await page.getByRole("tab", { name: /^(Play|Spielen)$/ }).click();
  await place(page, (await known()).solving);
  await drop(page);
  await says(page, /Solved|You beat|A draw/);
});

/** Presses one of the controls that can be pressed; null: returns how many there are. */
function controlsInPage(index) {
  const root = document.querySelector("dialog[open]") ?? document;
  const controls = [...root.querySelectorAll("button, summary, input[type=checkbox], input[type=radio], a[href^='#']")];
  const shown = /** @type {HTMLElement[]} */ (controls).filter(
    // The language stays, so that the end can be read.
    (one) => one.checkVisibility() && !one.hasAttribute("disabled") && !one.closest("[lang=de], #update"),
  );
  if (index === null) return shown.length;
  const control = shown[index];
  const name = control.getAttribute("aria-label") ?? control.closest("label")?.textContent ?? control.textContent;
  control.focus();
  control.click();
  return name?.trim();
}

function wrongInPage(keepsFocus) {
  const labels = [...document.querySelectorAll("[aria-label], [alt], [title]")].flatMap((one) =>
    ["aria-label", "alt", "title"].map((name) => one.getAttribute(name) ?? ""),
  );
  const words = [document.body.innerText, ...labels].join("\n");
  const large = [...document.querySelectorAll("button.step")].filter((one) => one.checkVisibility());
  const canvas = document.querySelector("canvas");
  const ground = canvas?.getContext("2d")?.getImageData(2, 2, 1, 1).data[3];
  return [
    /undefined|NaN|\[object|Infinity/.test(words) &&
      `words: ${words.match(/.*(undefined|NaN|\[object|Infinity).*/)?.[0]}`,
    document.documentElement.scrollWidth > innerWidth && `it is ${document.documentElement.scrollWidth} wide`,
    large.length !== 1 && `${large.length} large buttons`,
    ground !== 255 && "the scene is not painted",
    keepsFocus && document.activeElement === document.body && "the focus is lost",
  ].filter(Boolean);
}
