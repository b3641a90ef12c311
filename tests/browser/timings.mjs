// Prints how long a person waits for what `make play` serves, on this machine: make timings. A tool, not a test: it
// asserts nothing.
//
//   first puzzle   from asking for the page, with an empty cache, until the scene (or the grid's first picture) is
// drawn; the page is the one asked for, a puzzle by its link or the grid drag           the time between two frames
// while the ball is dragged, and the work in each editing        the same while the green object of a scene is dragged
// in Make, and from a move until its maps are drawn maps           from opening another puzzle until its maps are
// drawn, once the weights are there in wasm        the model's own part of it: the maps of a puzzle, a hundred balls
// proposed for it, one ball imagined
//
// Each is measured several times; the median is printed with the worst, beside what it should be.

import { start } from "./harness.mjs";
import { editingTimings, drag } from "./drag-timings.mjs";
import { openPuzzle } from "./page-actions.mjs";

const TIMES = 7;
/** The templates whose first task is opened. */
const TEMPLATES = [1, 7, 12, 16, 20, 23, 24];

const session = await start({ serve: ["--dir", "target/page"] });
const rows = [];
const row = (what, values, unit, wanted) => {
  const sorted = values.toSorted((a, b) => a - b);
  const [median, worst] = [sorted[Math.floor(sorted.length / 2)], sorted.at(-1)];
  rows.push({ what, median: `${median.toFixed(1)} ${unit}`, worst: `${worst.toFixed(1)} ${unit}`, wanted });
};

// The page's own instance of the wasm is in its bundle.
const sources = await start();
const plain = await sources.open("/");
await plain.locator("#templates a").first().waitFor();
const tasks = await plain.evaluate(async () =>
  (await import("/pkg/pathlight.js")).templates().map((template) => template.tasks[0]),
);
const task = (time) => tasks[TEMPLATES[time]];

/** From the start of the navigation until this selector's canvas has something on it. */
async function drawn(path, selector) {
  const page = await session.open("");
  await page.addInitScript((selector) => {
    const look = (now) => {
      const canvas =
        document.querySelector("#puzzle")?.shadowRoot?.querySelector(selector) ?? document.querySelector(selector);
      // The paper is opaque; an empty canvas is transparent.
      const ready =
        canvas?.width > 1 &&
        canvas.getContext("2d").getImageData(canvas.width >> 1, canvas.width >> 1, 1, 1).data[3] > 0;
      if (ready) globalThis.drawnAt = now;
      else requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  }, selector);
  await page.goto(session.origin + path);
  await page.waitForFunction(() => globalThis.drawnAt);
  const time = await page.evaluate(() => globalThis.drawnAt);
  await page.context().close();
  return time;
}

async function repeat(act) {
  const values = [];
  for (let time = 0; time < TIMES; time += 1) values.push(await act(time));
  return values;
}

row("first puzzle, by its link", await repeat((time) => drawn(`/#task=${task(time)}`, "#scene")), "ms", "< 1000 ms");
row("first puzzle, on the grid", await repeat(() => drawn("/", "#templates canvas")), "ms", "< 1000 ms");

const page = await openPuzzle(session, { fragment: "&panel=imagine&layers=base,placement&ball=128,200,12" });
await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();

/** Lists the times between the frames of a drag. */
function rowsOfDrag(what, gaps) {
  row(`${what}, between two frames`, gaps, "ms", "16.7 ms");
  const seconds = gaps.reduce((sum, gap) => sum + gap, 0) / 1000;
  rows.push({ what: `${what}, frames a second`, median: (gaps.length / seconds).toFixed(1), worst: "", wanted: "60" });
}

rowsOfDrag("drag", await drag(page, [128, 200], [60, 40]));

/** Opens a task by its link and waits for all maps. They come together; a timer would look for them every 4 ms only. */
const maps = (task) =>
  page.evaluate(async (task) => {
    const root = /** @type {ShadowRoot} */ (document.querySelector("#puzzle")?.shadowRoot);
    const labelled = [...root.querySelectorAll("#maps canvas[role=img]")];
    const areThere = () => labelled.every((map) => !/not imagined yet/.test(map.getAttribute("aria-label") ?? ""));
    const start = performance.now();
    const all = new Promise((/** @type {(time: number) => void} */ resolve) => {
      // First the maps of the puzzle before go, then the new ones come: the labels have changed both times.
      const observer = new MutationObserver(() => {
        if (!areThere()) return;
        observer.disconnect();
        resolve(performance.now() - start);
      });
      for (const map of labelled) observer.observe(map, { attributeFilter: ["aria-label"] });
    });
    location.hash = `task=${task}&panel=imagine`;
    return all;
  }, task);
row("maps of another puzzle", await repeat((time) => maps(task(time))), "ms", "< 100 ms");

const spent = await plain.evaluate(
  async (tasks) => {
    const { Model } = await import("/pkg/pathlight.js");
    const { models } = await (await fetch("/assets/model.json")).json();
    const model = new Model(new Uint8Array(await (await fetch(`/assets/${models[0].file}`)).arrayBuffer()));
    const timed = (act) => {
      const start = performance.now();
      act();
      return performance.now() - start;
    };
    // Balls that are valid. The first of a task takes longer: the net reads the scene.
    const pairs = tasks.map((task) =>
      model
        .propose(task, 0)
        .slice(0, 2)
        .map(({ ball }) => ball),
    );
    const imagined = (model) =>
      tasks.map((task, index) => pairs[index].map((ball) => timed(() => model.imagineBall(task, ball))));
    return {
      maps: tasks.map((task) => timed(() => model.imagine(task))),
      balls: tasks.map((task) => timed(() => model.propose(task, 0))),
      imagined: imagined(model),
    };
  },
  TEMPLATES.map((template) => tasks[template]),
);
row("five maps, in wasm", spent.maps, "ms", "");
row("a hundred balls proposed, in wasm", spent.balls, "ms", "< 1000 ms");
row(
  "the first ball imagined, in wasm",
  spent.imagined.map(([first]) => first),
  "ms",
  "",
);
row(
  "the next ball imagined, in wasm",
  spent.imagined.map(([, next]) => next),
  "ms",
  "< 16 ms",
);

const sceneOf = (task) => plain.evaluate(async (task) => (await import("/pkg/pathlight.js")).customScene(task), task);
for (const { bodies, gaps, latencies } of await editingTimings(session, sceneOf)) {
  rowsOfDrag(`editing ${bodies} bodies`, gaps);
  row(`editing ${bodies} bodies, from a move to its maps`, latencies, "ms", "< 100 ms");
}

console.table(rows);
await session.stop();
await sources.stop();
