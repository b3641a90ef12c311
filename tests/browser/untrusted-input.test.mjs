// What comes into the page from outside, whatever it is: links, what the browser has stored, and files that a person
// opens. Each either opens or is refused with a sentence, and what is kept holds together. The modules run in Node, on
// thousands of random inputs (PATHLIGHT_INPUTS sets how many for each, PATHLIGHT_SEED draws others); a failure prints
// the smallest input that fails, and its seed.

import assert from "node:assert/strict";
import { before, test } from "node:test";
import fc from "fast-check";

const RUNS = Number(process.env.PATHLIGHT_INPUTS ?? 1000);
const SEED = Number(process.env.PATHLIGHT_SEED ?? 1);

/** Like localStorage, whose entries are its own properties. */
class MemoryStorage {
  constructor(entries = {}) {
    Object.assign(this, entries);
  }
}
for (const [name, method] of Object.entries({
  getItem(key) {
    return Object.hasOwn(this, key) ? this[key] : null;
  },
  setItem(key, value) {
    this[key] = String(value);
  },
  removeItem(key) {
    delete this[key];
  },
}))
  Object.defineProperty(MemoryStorage.prototype, name, { value: method });
/** A storage that refuses everything, and one that has no room. */
const refusing = new Proxy(
  {},
  {
    get: () => () => {
      throw new Error("denied");
    },
    ownKeys: () => {
      throw new Error("denied");
    },
  },
);
class FullStorage extends MemoryStorage {}
Object.defineProperty(FullStorage.prototype, "setItem", {
  value: () => {
    throw new Error("full");
  },
});

let page;
before(async () => {
  Object.assign(globalThis, { localStorage: new MemoryStorage(), addEventListener() {} });
  const { load } = await import("../../www/api/index.js");
  await load({ weights: null });
  page = {
    ...(await import("../../www/state/url-state.js")),
    ...(await import("../../www/state/links.js")),
    ...(await import("../../www/state/view.js")),
    ...(await import("../../www/storage/progress.js")),
    ...(await import("../../www/storage/progress-file.js")),
    ...(await import("../../www/storage/puzzle-store.js")),
    ...(await import("../../www/storage/sliced-work.js")),
    ...(await import("../../www/editor/scene-link.js")),
    ...(await import("../../www/editor/puzzle-file.js")),
    ...(await import("../../www/attempts/attempt-file.js")),
    ...(await import("../../www/shell/page-api.js")),
  };
});

/** Anything, or valid text with up to four pieces replaced. */
const damaged = (texts) => {
  const piece = fc.oneof(
    fc.constantFrom(
      "",
      '"',
      "{",
      "}",
      "[",
      "]",
      ",",
      ":",
      "null",
      "-1",
      "1e999",
      "__proto__",
      "%",
      "=",
      "&",
      "\n",
      "\\u0000",
    ),
    fc.string({ maxLength: 6 }),
  );
  const changes = fc.array(fc.tuple(fc.double({ min: 0, max: 1, noNaN: true }), fc.nat(8), piece), { maxLength: 4 });
  const changed = fc.tuple(fc.constantFrom(...texts), changes).map(([text, all]) =>
    all.reduce((now, [where, length, put]) => {
      const at = Math.floor(where * now.length);
      return now.slice(0, at) + put + now.slice(at + length);
    }, text),
  );
  return fc.oneof({ weight: 6, arbitrary: changed }, fc.string(), fc.json());
};

const isSentence = (text) =>
  typeof text === "string" && text.length > 20 && text.length < 1500 && /[.:!?”]$/.test(text.trim());
/** Resolves to the value, or null after asserting that the refusal is a sentence. */
async function orSentence(promise) {
  try {
    return await promise;
  } catch (error) {
    assert.ok(isSentence(/** @type {Error} */ (error).message), `refused with ${/** @type {Error} */ (error).stack}`);
    return null;
  }
}
const check = (property) => fc.assert(property, { numRuns: RUNS, seed: SEED });
const file = (text) => new File([text], "a file.json");

const SCENE = {
  version: 1,
  name: "Over",
  body1: 0,
  body2: 1,
  bodies: [
    { shape: "ball", radius: 12.5, x: 60, y: 200, angle: 0, dynamic: true },
    { shape: "bar", length: 80, thickness: 5.12, x: 200, y: 2.56, angle: 0, dynamic: false },
  ],
};
const ATTEMPT = {
  task: "00007:008",
  by: "player",
  ball: [128, 200, 12],
  status: "solved",
  steps: 312,
  longest_touch: 180,
  final_touch: 180,
  simulator: 3,
};
const PROGRESS = {
  tasks: { "00007:008": { attempts: 4, solved: 3 } },
  models: { "within-0": { "00000:001": { attempts: 1, solved: null } } },
  attempts: [
    ATTEMPT,
    { ...ATTEMPT, by: "within-0", ball: [1, 2, 3] },
    { ...ATTEMPT, task: undefined, scene: "a".repeat(64) },
  ],
};
const LINES = `${JSON.stringify(ATTEMPT)}\n${JSON.stringify({ ...ATTEMPT, task: "00000:001" })}\n${JSON.stringify({ ...ATTEMPT, task: undefined, scene: SCENE })}\n`;

test("any link is a state of the page that its own link leads back to", async () => {
  const links = [
    "task=00007:008&model=within-0&panel=imagine&step=target&view=presentation&layers=base,target&opacity=0.5",
    "scene=q1YqSy0qzszPU7Iy0lFKyk_JTC0GsgxqAQ&ball=100,200,10&challenge=7&hide=puzzles,imagine&forecast=on&proposal=3",
    "view=results",
    "view=learns&model=cross-0",
  ];
  check(
    fc.property(damaged(links), (hash) => {
      const { state, problem } = page.parseFragment(`#${hash}`);
      assert.ok(problem === null || isSentence(problem), problem ?? "");
      const again = page.parseFragment(`#${page.formatFragment(state)}`);
      assert.deepEqual(again, { state, problem: null });
      const { panel, layers, checkedLayers } = page.viewOf(state);
      if (state.layers) assert.deepEqual(checkedLayers, state.layers);
      assert.ok(
        page.visiblePanels(state).includes(panel) &&
          layers.every((one) => checkedLayers.includes(one) || one === state.step),
      );
      assert.ok(!page.showsPuzzle(state) || state.task === null || state.scene === null);
    }),
  );
  for (const long of [`scene=${"A".repeat(4e4)}`, "x=y&".repeat(1e4)])
    assert.ok(isSentence(page.parseFragment(`#${long}`).problem));
});

test("any text after scene= in a link is a scene that can be played, or refused", async () => {
  const text = await page.textOfScene(SCENE);
  await fc.assert(
    fc.asyncProperty(damaged([text, text, text.slice(0, 40)]), async (one) => {
      const scene = await orSentence(page.sceneOfText(one));
      if (scene) assert.deepEqual(page.pathlight.sceneProblems(scene), []);
    }),
    { numRuns: RUNS, seed: SEED },
  );
  const bomb = new Response(
    new Blob([`"${" ".repeat(3e7)}"`]).stream().pipeThrough(new CompressionStream("deflate-raw")),
  );
  const packed = Buffer.from(await bomb.arrayBuffer()).toString("base64url");
  assert.ok(packed.length < 50_000, "a link of some kB");
  assert.equal(await orSentence(page.sceneOfText(packed)), null);
});

test("any scene and any file of puzzles can be played, or is refused", async () => {
  await fc.assert(
    fc.asyncProperty(damaged([JSON.stringify(SCENE), JSON.stringify([SCENE, SCENE])]), async (text) => {
      for (const scene of (await orSentence(page.readPuzzles(file(text)))) ?? [])
        assert.deepEqual(page.pathlight.sceneProblems(scene), []);
    }),
    { numRuns: RUNS, seed: SEED },
  );
  check(
    fc.property(fc.anything({ withNullPrototype: true, withBigInt: true }), (value) => {
      assert.ok(page.pathlight.sceneProblems(value).every(({ sentence }) => isSentence(sentence)));
    }),
  );
  const deep = `${"[".repeat(1e6)}${"]".repeat(1e6)}`;
  assert.equal(await orSentence(page.readPuzzles(file(deep))), null);
  assert.equal(
    await orSentence(page.readPuzzles(file(`{"version":1,"body1":${deep},"body2":0,"bodies":[${deep}]}`))),
    null,
  );
});

test("any file of attempts is read line by line, and each line verified or refused", async () => {
  const line = page.pathlight.attemptLine("00007:008", [128, 200, 12]);
  await fc.assert(
    fc.asyncProperty(
      damaged([JSON.stringify(line), JSON.stringify({ ...line, task: undefined, scene: SCENE, ball: null })]),
      async (text) => {
        for (const one of (await orSentence(page.readAttempts(file(text))))?.attempts ?? []) {
          const { verdict, reason } = page.pathlight.verifyAttempt(one);
          assert.ok(verdict === "same" || isSentence(reason), `${verdict}: ${reason}`);
        }
      },
    ),
    { numRuns: RUNS, seed: SEED },
  );
});

test("any file of progress is taken over or refused, and what is kept is read back the same", () => {
  check(
    fc.property(damaged([JSON.stringify(PROGRESS), LINES]), (text) => {
      const progress = fresh(new MemoryStorage());
      const empty = page.progressJson(progress);
      let puzzles;
      try {
        puzzles = readBack(progress, text).puzzles;
      } catch (error) {
        assert.ok(error instanceof page.FileProblem, "it is a sentence for the person");
        assert.ok(
          isSentence(/** @type {Error} */ (error).message),
          `refused with ${/** @type {Error} */ (error).stack}`,
        );
        assert.equal(page.progressJson(progress), empty, "nothing has changed");
        return;
      }
      const saved = page.progressJson(progress);
      const { tasks, models, attempts } = JSON.parse(saved);
      const kept = new Set([
        ...[tasks, ...Object.values(models)].flatMap(Object.keys),
        ...attempts.map(({ task, scene }) => task ?? scene),
      ]);
      assert.equal(puzzles, kept.size, "as many puzzles as it says");
      const other = fresh(new MemoryStorage());
      readBack(other, saved);
      assert.deepEqual(JSON.parse(page.progressJson(other)), JSON.parse(saved));
    }),
  );

  /** The progress of a browser with this storage. */
  function fresh(storage) {
    globalThis.localStorage = /** @type {any} */ (storage);
    return new page.Progress(true);
  }

  function readBack(progress, text) {
    const digestOf = (scene) => page.pathlight.sceneDigest(scene);
    const { attempts, counts } = page.atOnce(page.progressOfText(text, digestOf));
    return page.atOnce(progress.merging(attempts, counts));
  }
});

test("whatever is stored, and whether or not it may be, the page has progress, attempts and puzzles", () => {
  const stored = fc.record(
    {
      "pathlight.progress": damaged([JSON.stringify({ tasks: PROGRESS.tasks })]),
      "pathlight.model.within-0": damaged([JSON.stringify({ tasks: PROGRESS.models["within-0"] })]),
      "pathlight.attempts.00007:008": damaged([LINES]),
      "pathlight.attempts.own": damaged([LINES]),
      "pathlight.own-puzzles": damaged([JSON.stringify([SCENE])]),
      __proto__: fc.string(),
    },
    { requiredKeys: [] },
  );
  /** @type {fc.Arbitrary<(entries: object) => any>} */
  const kinds = fc.constantFrom(
    (entries) => new MemoryStorage(entries),
    (entries) => new FullStorage(entries),
    () => refusing,
  );
  check(
    fc.property(stored, kinds, (entries, kind) => {
      globalThis.localStorage = kind(entries);
      const progress = new page.Progress(true);
      const before = progress.player.of("00007:008").attempts;
      const ending = { solved: true, steps: 1, longest_touch: 0, final_touch: 0 };
      progress.add("00007:008", "player", [{ ball: [1, 2, 3], ending }], { simulator: 3 });
      const { attempts, solved } = progress.player.of("00007:008");
      assert.ok(attempts === before + 1 && solved !== null && solved <= attempts);
      assert.ok(progress.attemptsAt("00007:008").some((one) => String(one.ball) === "1,2,3"));
      for (const one of progress.all) assert.match(one.puzzle, /^(\d{5}:\d{3}|[0-9a-f]{64})$/);
      assert.doesNotThrow(() => JSON.parse(page.progressJson(progress)));
      const custom = new page.PuzzleStore();
      const why = custom.add([SCENE]).failure;
      assert.ok(why === null || isSentence(why));
      for (const scene of custom.scenes) assert.doesNotThrow(() => page.pathlight.sceneProblems(scene));
    }),
  );
});
