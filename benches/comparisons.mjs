// What `make bench` times: the parts, their comparisons, and the implementations of each; ours comes first.
//
// An implementation is started by `start(place, checkout)`: `place` is what `open` returned, and the checkout is this
// one by default. It returns `{ result, times(repetitions), stop? }`. `agree` throws if a result is not ours. Each is
// timed in blocks of `repetitions`. With `steps` the row shows simulated steps per second.

import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { startChild } from "./child.mjs";
import { OTHER_TASK, TASK } from "./nets/web/task.mjs";
import { implementation } from "./web/implementation.mjs";

export const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const WEIGHTS = "target/bench/weights.safetensors";
const onnx = (what) => `target/bench/${what}.onnx`;
/** What each graph reads. */
const images = { nets: ["scene"], "all-nets": ["scene", "coverage"] };
const ROLLOUTS = "target/bench/rollouts.txt";

// All of ours is built as it is released; Box2D is built with link-time optimisation too.
const ourSimulator = (work) => [
  ..."cargo bench --quiet --profile dist --no-default-features --bench simulator --".split(" "),
  work,
];
const ourNets = (...args) => [
  ..."cargo bench --quiet --profile dist --package pathlight-lab --bench nets --".split(" "),
  ...args,
];
const python = (script, ...args) => ["target/bench/venv/bin/python", `benches/nets/${script}`, ...args];
const torch = (...args) => python("torch_step.py", WEIGHTS, "target/bench/batches.f32", "2", ...args);
const child =
  (command, threads = 1) =>
  (_, at = root) =>
    startChild(at, command, { RAYON_NUM_THREADS: threads });
const inNode =
  (module, what) =>
  (_, at = root) =>
    implementation([module, what], (path) => new Uint8Array(readFileSync(join(at, path))), `${at}/benches`);
const inPage = (module, what) => (page) => page.implementation([module, what]);
const openPage = async () => (await import("./web/page.mjs")).openPage(root);

/** Numbers that differ by at most `tolerance`. */
const within = (tolerance) => (these, those) => {
  if (these.length !== those.length) throw new Error(`it has ${these.length} results, and ours ${those.length}`);
  const apart = these.reduce((most, number, index) => Math.max(most, Math.abs(number - those[index])), 0);
  if (!(apart <= tolerance)) throw new Error(`its results are ${apart} from ours`);
};

/**
 * Rollouts `[solved, steps, x, y, x, y…]` of which every one ends as ours does. A collision multiplies a difference in
 * the last bit, so not every body has to come to rest at the same place.
 */
const sameRollouts = (these, those) => {
  if (these.length !== those.length) throw new Error(`it has ${these.length} rollouts, and ours ${those.length}`);
  const different = these.filter(([solved], index) => solved !== those[index][0]).length;
  const near = these.flatMap((end, index) =>
    end.slice(2).map((at, coordinate) => Math.abs(at - those[index][coordinate + 2]) < 1),
  );
  const share = near.filter(Boolean).length / near.length;
  if (different > 0 || !(share >= 0.95)) {
    throw new Error(
      `${different} rollouts end otherwise, and ${(100 * share).toFixed(1)} % of the positions are within 1 px of ours`,
    );
  }
};
const steps = (result) => result.reduce((sum, [, number]) => sum + number, 0);

const simulator = { agree: sameRollouts, repetitions: 1 };
const nets = { agree: within(1e-4), repetitions: 20 };
/** In wasm ours shows no logits; those of the peers' file are compared natively. */
const fourMaps = (these, those) => nets.agree(...[these, those].map((maps) => maps.slice(0, 4 * 64 * 64)));
/** Logits are larger than the values of maps. */
const allNets = { agree: within(1e-3), repetitions: 10 };
const web = (where, what) => [
  ["ours", where("nets/web/ours.mjs", what)],
  ["onnxruntime-web", where("nets/web/onnxruntime-web.mjs", what)],
  ["tract", where("nets/web/tract.mjs", what)],
];
const native = (what, bench) => [
  ["ours", child(ourNets(bench, TASK))],
  ["onnxruntime", child(python("onnxruntime_forward.py", onnx(what), "target/bench"))],
  [
    "tract",
    child([
      "target/bench/tract/release/tract-nets",
      onnx(what),
      ...images[what].map((image) => `target/bench/${image}.f32`),
    ]),
  ],
];

// In wasm ours also finds out which balls fit, as the page needs it; the peers run the nets alone.
const FIVE_MAPS = "five maps of a scene";

export const parts = {
  simulator: [
    {
      title: "steps of 500 rollouts, native, one core",
      ...simulator,
      steps,
      implementations: [
        ["ours", child(ourSimulator("rollouts"))],
        ["Box2D 2.3 (-O2)", child(["target/bench/box2d", "rollouts", ROLLOUTS])],
        ["Box2D 2.3 (-O3 -flto, without its timers)", child(["target/bench/box2d-fastest", "rollouts", ROLLOUTS])],
      ],
    },
    {
      title: "worlds of these rollouts, native",
      ...simulator,
      implementations: [
        ["ours", child(ourSimulator("worlds"))],
        ["Box2D 2.3 (-O2)", child(["target/bench/box2d", "worlds", ROLLOUTS])],
      ],
    },
    {
      title: "steps of these rollouts, wasm in Node",
      ...simulator,
      steps,
      implementations: [
        ["ours", inNode("simulator/web/ours.mjs")],
        ["Box2D 2.4 by box2d-wasm", inNode("simulator/web/box2d.mjs")],
        ["ours natively", child(ourSimulator("rollouts"))],
      ],
    },
  ],
  nets: [
    { title: "four nets of a scene, wasm in Node", ...nets, implementations: web(inNode, "nets") },
    { title: "four nets of a scene, wasm in Chromium", ...nets, open: openPage, implementations: web(inPage, "nets") },
    { title: "four nets of a scene, native, one thread", ...nets, implementations: native("nets", "forward") },
    { title: `${FIVE_MAPS}, wasm in Node`, ...allNets, agree: fourMaps, implementations: web(inNode, "all-nets") },
    {
      title: `${FIVE_MAPS}, wasm in Chromium`,
      ...allNets,
      agree: fourMaps,
      open: openPage,
      implementations: web(inPage, "all-nets"),
    },
    { title: `${FIVE_MAPS}, native, one thread`, ...allNets, implementations: native("all-nets", "maps") },
    {
      title: "a hundred proposed balls, wasm in Node",
      agree: within(1e-9),
      repetitions: 5,
      implementations: [
        ["ours", inNode("nets/web/ours.mjs", "propose")],
        ["ours natively", child(ourNets("propose", TASK, OTHER_TASK))],
      ],
    },
  ],
  training: [
    {
      title: "training step on 32 samples, native, two threads",
      agree: within(1e-3),
      repetitions: 2,
      implementations: [
        ["ours", child(ourNets("train"), 2)],
        ["PyTorch", child(torch(), 2)],
        ["PyTorch with fused Adam", child(torch("fused"), 2)],
      ],
    },
  ],
};
