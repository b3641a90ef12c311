// Times our nets and simulator beside their peers and prints one table in Markdown: node benches/bench.mjs [PART…]
//
// `run` has installed the peers. The implementations that are compared take turns, so that whatever else the machine
// does falls on all of them; before, their results are compared with ours. A peer that is missing or fails is left
// out, and the table says so; the exit code is 1 if ours fails or a peer computes something else. ROUNDS is how many
// turns each has.

import { execFileSync } from "node:child_process";
import { availableParallelism, cpus, loadavg } from "node:os";
import { parts } from "./comparisons.mjs";

const ROUNDS = Number(process.env.ROUNDS || 9);
/** ms */
const WARM_UP = 1000;

const wanted = process.argv.slice(2).length > 0 ? process.argv.slice(2) : Object.keys(parts);
const unknown = wanted.filter((part) => !parts[part]);
if (unknown.length > 0) {
  console.error(`error: there is no part ${unknown.join(", ")}: the parts are ${Object.keys(parts).join(", ")}`);
  process.exit(2);
}
const [load] = loadavg();
if (load > 0.5) console.error(`warning: something else runs here (load ${load.toFixed(1)}): trust ratios, not times`);
const rows = [];
for (const comparison of wanted.flatMap((part) => parts[part])) {
  console.error(`measuring: ${comparison.title}`);
  rows.push(await run(comparison));
}
const git = (...args) => execFileSync("git", args, { encoding: "utf8" }).trim();
const changed = git("status", "--porcelain", "--untracked-files=no") ? ", changed" : "";
console.log(
  ["| work | ours | peers: their time, and how many times as fast ours is |", "| --- | ---: | --- |", ...rows].join(
    "\n",
  ),
);
console.log(
  `\nMedians of ${ROUNDS} rounds at commit ${git("rev-parse", "--short", "HEAD")}${changed}, ${cpus()[0].model}, ` +
    `${availableParallelism()} cores, load ${load.toFixed(1)} before. Parts: ${wanted.join(", ")}.`,
);

/** The row of a comparison. */
async function run({ title, agree, repetitions, steps, open, implementations }) {
  const stops = [];
  const there = [];
  const out = [];
  let place;
  try {
    place = await open?.();
  } catch (error) {
    return `| ${title} | left out (${reason(error)}) | |`;
  }
  if (place) stops.push(() => place.stop());
  try {
    for (const [name, start] of implementations) {
      let one;
      try {
        one = await start(place);
      } catch (error) {
        if (there.length === 0) throw error;
        out.push(`${name}: left out (${reason(error)})`);
        continue;
      }
      if (one.stop) stops.push(one.stop);
      try {
        if (there.length > 0) agree(one.result, there[0].result);
        there.push({ ...one, name, blocks: [] });
      } catch (error) {
        process.exitCode = 1;
        out.push(`${name}: left out (${reason(error)})`);
      }
    }
    for (const one of there) await warmUp(one);
    for (let round = 0; round < ROUNDS; round += 1) {
      for (const one of there) one.blocks.push(await one.times(repetitions));
    }
  } catch (error) {
    process.exitCode = 1;
    return `| ${title} | failed (${reason(error)}) | |`;
  } finally {
    for (const stop of stops.reverse()) await stop();
  }
  const [ours, ...peers] = there;
  const speed = (one) => shown(one, steps);
  const beside = peers.map((one) => `${one.name} ${speed(one)} (${ratio(one, ours, steps).toFixed(2)}x)`);
  return `| ${title} | ${speed(ours)} | ${[...beside, ...out].join("; ")} |`;
}

/** Wasm is recompiled while it runs, and threads have to be started. */
async function warmUp(one) {
  const start = performance.now();
  while (performance.now() - start < WARM_UP) await one.times(1);
}

/** The median time, or the steps per second. */
function shown(one, steps) {
  const time = median(one.blocks.flat());
  if (steps) return `${(steps(one.result) / time / 1e3).toFixed(2)} M/s`;
  return `${time < 10 ? time.toFixed(2) : time.toFixed(1)} ms`;
}

/** How many times as fast ours is: of adjacent blocks, so that a slow minute does not distort it. */
function ratio(one, ours, steps) {
  const work = steps ? steps(ours.result) / steps(one.result) : 1;
  return work * median(one.blocks.map((times, round) => median(times) / median(ours.blocks[round])));
}

function reason(error) {
  return error.message.split("\n")[0].replaceAll("|", "/");
}

function median(numbers) {
  const sorted = [...numbers].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}
