// Times the nets against their peers and prints one table: node benches/nets/bench.mjs
//
// `run` has installed the peers. Contenders of a race take turns, so that whatever else the machine does falls on
// all of them; before, their results are compared with ours. A peer that is missing or fails is left out, and the table
// says so. All run the paper's four nets; the row "ours-five-maps" adds the judge.

import { existsSync, readFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { startChild } from './child.mjs';
import { contender } from './web/contender.mjs';
import { TASK } from './web/task.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
const ROUNDS = Number(process.env.ROUNDS || 15);
/** ms */
const WARM_UP = 2000;

// Built with the features of the tests, so that nothing is built twice.
const ours = (...args) => ['cargo', 'bench', '--quiet', '--features', 'ndarray', '--bench', 'nets', '--', ...args];
const python = (script, ...args) => ['target/bench/venv/bin/python', `benches/nets/${script}`, ...args];
const WEIGHTS = 'assets/within-0.safetensors';
const NETS = ['target/bench/nets.onnx', 'target/bench/scene.f32'];

// Ours comes first. Results may differ by `tolerance`; a contender is timed in blocks of `repetitions`.
const forward = { tolerance: 1e-4, repetitions: 20 };
const web = ['ours', 'ours-five-maps', 'onnxruntime-web', 'tract'];
const inNode = (name) => contender(name, (path) => new Uint8Array(readFileSync(join(root, path))));
const inChild = (command, threads) => startChild(root, command, { RAYON_NUM_THREADS: threads });
const torch = (...args) => python('torch_step.py', WEIGHTS, 'target/bench/batch.f32', '2', ...args);

const RACES = [
  {
    title: 'forward, batch 1, wasm in Node, one thread',
    ...forward,
    contenders: web.map((name) => [name, () => inNode(name)]),
  },
  {
    title: 'forward, batch 1, wasm in Chromium, one thread',
    ...forward,
    open: async () => (await import('./page.mjs')).openPage(root),
    contenders: web.map((name) => [name, (page) => page.contender(name)]),
  },
  {
    title: 'forward, batch 1, native, one thread',
    ...forward,
    contenders: [
      ['ours', () => inChild(ours('forward', TASK), 1)],
      ['onnxruntime', () => inChild(python('onnxruntime_forward.py', ...NETS), 1)],
      ['tract', () => inChild(['target/bench/tract/release/tract-nets', ...NETS], 1)],
    ],
  },
  {
    title: 'training step, batch 32, native, two threads',
    tolerance: 1e-3,
    repetitions: 2,
    contenders: [
      ['ours', () => inChild(ours('train'), 2)],
      ['PyTorch, Adam', () => inChild(torch(), 2)],
      ['PyTorch, fused Adam', () => inChild(torch('fused'), 2)],
    ],
  },
];

const [load] = loadavg();
if (load > 0.5) console.error(`warning: something else runs here (load ${load.toFixed(1)}): trust ratios, not times`);
const rows = [];
for (const race of RACES) rows.push([race.title], ...(await run(race)));
rows.push(['downloads, MB'], ...sizes());
console.log(table(rows));

/** The rows of a race. */
async function run({ title, tolerance, repetitions, open, contenders }) {
  console.error(`measuring: ${title}`);
  const stops = [];
  const there = [];
  const out = [];
  let place;
  try {
    place = await open?.();
    if (place) stops.push(() => place.stop());
    for (const [name, start] of contenders) {
      try {
        const one = await start(place);
        if (one.stop) stops.push(one.stop);
        const worst = there.length === 0 ? 0 : apart(one.result, there[0].result);
        if (!(worst <= tolerance)) throw new Error(`its results are ${worst} from ours`);
        there.push({ ...one, name, blocks: [] });
      } catch (error) {
        if (there.length === 0) throw error;
        out.push(leftOut(name, error));
      }
    }
    for (const one of there) await warmUp(one, repetitions);
    for (let round = 0; round < ROUNDS; round += 1) {
      for (const one of there) one.blocks.push(await one.times(repetitions));
    }
  } catch (error) {
    return [leftOut('all of it', error)];
  } finally {
    for (const stop of stops.reverse()) await stop();
  }
  const [mine] = there;
  return [...there.map((one) => timed(one, mine)), ...out];
}

/** Wasm is recompiled while it runs, and threads have to be started. */
async function warmUp(one, repetitions) {
  const start = performance.now();
  while (performance.now() - start < WARM_UP) await one.times(repetitions);
}

function timed({ name, blocks }, mine) {
  const all = blocks.flat();
  // Of adjacent blocks, so that a slow minute does not distort the ratio.
  const ratio = median(blocks.map((times, round) => median(mine.blocks[round]) / median(times)));
  const cells = [`${median(all).toFixed(2)} ms`, `${Math.min(...all).toFixed(2)} ms`];
  return [name, ...cells, name === 'ours' ? '' : `${ratio.toFixed(2)} x`];
}

function leftOut(name, error) {
  return [name, `left out: ${error.message.split('\n')[0]}`];
}

function sizes() {
  const files = { weights: WEIGHTS, wasm: 'www/pkg/pathlight_bg.wasm' };
  const megabytes = (bytes) => (bytes.length / 1e6).toFixed(2);
  return Object.entries(files).filter(([, file]) => existsSync(join(root, file))).map(([name, file]) => {
    const bytes = readFileSync(join(root, file));
    return [name, megabytes(bytes), `${megabytes(gzipSync(bytes, { level: 9 }))} gzip`, `${megabytes(brotliCompressSync(bytes))} brotli`];
  });
}

/** The largest difference; infinite if the lengths differ. */
function apart(these, those) {
  if (these.length !== those.length) return Infinity;
  return these.reduce((most, number, index) => Math.max(most, Math.abs(number - those[index])), 0);
}

function median(numbers) {
  const sorted = [...numbers].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

function table(rows) {
  const line = ([name, ...cells]) =>
    cells.length === 0 ? `\n${name}`
    : cells.length === 1 ? `  ${name.padEnd(22)} ${cells[0]}`
    : `  ${name.padEnd(22)}${cells.map((cell) => cell.padStart(14)).join('')}`;
  return [line(['', 'median', 'best', 'ours / it']), ...rows.map(line)].join('\n');
}
