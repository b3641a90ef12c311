// Runs a comparison: its implementations take turns, so that whatever else the machine does falls on all of them. Used
// by `bench.mjs` and `compare.mjs`.

import { execFileSync } from "node:child_process";
import { availableParallelism, cpus, loadavg } from "node:os";

/** How many turns each implementation has. */
export const ROUNDS = Number(process.env.ROUNDS || 9);
/** ms */
const WARM_UP = 1000;

/**
 * Returns `{ title, timed, out }`. Of each implementation that was timed it has the name, the median time of each
 * round, ms, and, of all but the first, how many times as fast the first is: the median over the rounds and its
 * quartiles. `out` says why the others are left out. With `steps` it also has the millions of simulated steps per
 * second.
 *
 * Before anything is timed, results are compared with the first implementation's. The exit code is 1 if that fails or
 * another computes something else.
 */
export async function measure({ title, agree, repetitions, steps, open, implementations }) {
  const stops = [];
  const there = [];
  const out = [];
  let place;
  try {
    place = await open?.();
  } catch (error) {
    return { title, timed: [], out: [{ name: "all", reason: reason(error) }] };
  }
  if (place) stops.push(() => place.stop());
  try {
    for (const [name, start] of implementations) {
      let one;
      try {
        one = await start(place);
      } catch (error) {
        if (there.length === 0) throw error;
        out.push({ name, reason: reason(error) });
        continue;
      }
      if (one.stop) stops.push(one.stop);
      try {
        if (there.length > 0) agree(one.result, there[0].result);
        there.push({ ...one, name, rounds: [] });
      } catch (error) {
        process.exitCode = 1;
        out.push({ name, reason: reason(error) });
      }
    }
    for (const one of there) await warmUp(one);
    for (let round = 0; round < ROUNDS; round += 1) {
      for (const one of there) one.rounds.push(median(await one.times(repetitions)));
    }
  } catch (error) {
    process.exitCode = 1;
    return { title, timed: [], out: [{ name: implementations[0][0], reason: reason(error) }] };
  } finally {
    for (const stop of stops.reverse()) await stop();
  }
  const [first] = there;
  const timed = there.map((one) => {
    const work = steps ? steps(first.result) / steps(one.result) : 1;
    // Of adjacent blocks, so that a slow minute does not distort them.
    const ratios = one.rounds.map((time, round) => (work * time) / first.rounds[round]);
    return {
      name: one.name,
      rounds: one.rounds,
      ...(steps && { millionSteps: steps(one.result) / median(one.rounds) / 1e3 }),
      ...(one !== first && { timesAsFast: quartiles(ratios) }),
    };
  });
  return { title, timed, out };
}

/** Wasm is recompiled while it runs, and threads have to be started. */
async function warmUp(one) {
  const start = performance.now();
  while (performance.now() - start < WARM_UP) await one.times(1);
}

/** A row of the table in Markdown. */
export function row({ title, timed: [first, ...others], out }) {
  const left = out.map(({ name, reason }) => `${name}: left out (${reason})`);
  if (!first) return `| ${title} | | ${left.join("; ")} |`;
  const beside = others.map((one) => {
    const { median, low, high } = one.timesAsFast;
    return `${one.name} ${speed(one)} (${median.toFixed(2)}x, ${low.toFixed(2)} to ${high.toFixed(2)})`;
  });
  return `| ${title} | ${speed(first)} | ${[...beside, ...left].join("; ")} |`;
}

function speed({ rounds, millionSteps }) {
  if (millionSteps) return `${millionSteps.toFixed(2)} M/s`;
  const time = median(rounds);
  return `${time < 10 ? time.toFixed(2) : time.toFixed(1)} ms`;
}

/** The commit, whether files have changed since, and the machine. Warns if it is busy. */
export function circumstances(root) {
  const git = (...args) => execFileSync("git", args, { cwd: root, encoding: "utf8" }).trim();
  const [load] = loadavg();
  if (load > 0.5) console.error(`warning: something else runs here (load ${load.toFixed(1)}): trust ratios, not times`);
  return {
    commit: git("rev-parse", "--short", "HEAD"),
    changed: git("status", "--porcelain", "--untracked-files=no") !== "",
    cpu: cpus()[0].model,
    cores: availableParallelism(),
    load,
    rounds: ROUNDS,
  };
}

/** The parts that the arguments name, or all; exits if there is no such part. */
export function wantedParts(parts, names) {
  const wanted = names.length > 0 ? names : Object.keys(parts);
  const unknown = wanted.filter((part) => !parts[part]);
  if (unknown.length > 0) {
    console.error(`error: there is no part ${unknown.join(", ")}: the parts are ${Object.keys(parts).join(", ")}`);
    process.exit(2);
  }
  return wanted;
}

function reason(error) {
  return error.message.split("\n")[0].replaceAll("|", "/");
}

function median(numbers) {
  return quantile(numbers, 0.5);
}

function quartiles(numbers) {
  return { low: quantile(numbers, 0.25), median: median(numbers), high: quantile(numbers, 0.75) };
}

/** Between the two nearest numbers. */
function quantile(numbers, share) {
  const sorted = [...numbers].sort((a, b) => a - b);
  const at = share * (sorted.length - 1);
  const [low, high] = [sorted[Math.floor(at)], sorted[Math.ceil(at)]];
  return low + (at - Math.floor(at)) * (high - low);
}
