// The installed package in Node: the example, errors, memory.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { once } from "node:events";
import { cpSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { test } from "node:test";
import { entryOf, example, makeProject, readmeCode, root } from "./project.mjs";

const project = makeProject();
const installed = join(project, "node_modules/pathlight");
const { load } = await import(entryOf(project));
const TASK = "00007:008";

test("it brings no other packages and one model", () => {
  assert.deepEqual(
    readdirSync(join(project, "node_modules")).filter((name) => !name.startsWith(".")),
    ["pathlight"],
  );
  assert.deepEqual(readdirSync(join(installed, "assets")).sort(), ["attempts.jsonl", "within-0.safetensors"]);
});

/** Runs a script in the project. Returns what it prints. */
function run(script) {
  writeFileSync(join(project, "script.mjs"), script);
  return execFileSync(process.execPath, ["script.mjs"], { cwd: project, encoding: "utf8" });
}

test("the README's script prints an attempt", () => {
  assert.match(run(readmeCode(project, "js")), /^\[ \d+, \d+, \d+ \] (true|false) \d+\n$/);
});

test("the example prints the auccess that was measured natively", async (context) => {
  const words = run(example(project, "auccess.mjs"));
  context.diagnostic(words);
  const [, printed, count] = /^auccess (\S+) on (\d+) tasks\n$/.exec(words) ?? [];
  assert.equal(count, "50");

  const { agents } = JSON.parse(readFileSync(join(root, "results/shipped/within-0.json"), "utf8"));
  const measured = agents.find(({ agent }) => agent === "dynamics").first_solved;
  const firstSolved = measured.filter((_, index) => index % 10 === 0);
  const expected = (await load({ weights: null })).auccess(firstSolved);
  assert.equal(printed, expected.toFixed(1));
});

test("100 tasks in a row leave nothing behind in the memory", async () => {
  const pathlight = await load();
  const wasm = await import(join(installed, "pkg/worker/pathlight.js"));
  const { memory } = await wasm.default();
  // A handle that is not freed at once stays until a collector finds it, if one does.
  const freed = { OpenPuzzle: 0, Model: 0, SolveMap: 0, Turn: 0 };
  for (const [name, { prototype }] of Object.keys(freed).map((name) => [name, wasm[name]])) {
    const { free } = prototype;
    prototype.free = function () {
      freed[name]++;
      free.call(this);
    };
  }
  const tasks = pathlight.templates().flatMap((template) => template.tasks.slice(0, 2));
  const useAll = () =>
    tasks.forEach((task) => {
      const maps = pathlight.imagine(task);
      assert.equal(pathlight.softIou(maps.base, maps.base), 1);
      const [{ ball }] = pathlight.propose(task, { count: 1 });
      assert.equal(pathlight.whyInvalid(task, ball), undefined);
      const imagined = pathlight.imagineBall(task, ball);
      assert.equal(pathlight.candidates(task) !== null, imagined !== null);
      assert.equal(imagined !== null, pathlight.card?.dynamics !== undefined);
      if (imagined)
        assert.deepEqual(
          [imagined.steps.length, imagined.object.length, imagined.ball.length, imagined.errors.length],
          [16, 32, 32, 32],
        );
      const [attempt] = pathlight.turn(task);
      assert.deepEqual(attempt.ball, ball);
      assert.equal(pathlight.simulate(task, ball).steps, attempt.ending.steps);
      const [{ progress }] = pathlight.solveMap(task, 32);
      assert.ok(progress > 0);
      assert.equal(pathlight.about(task).id, task);
    });
  const loadThrice = async () => {
    for (let time = 0; time < 3; time++) await pathlight.loadModel();
  };
  assert.equal(tasks.length, 50);
  for (const act of [useAll, loadThrice]) {
    // The first time takes what is needed at most at once, the second time again.
    await act();
    const before = memory.buffer.byteLength;
    await act();
    assert.ok(
      memory.buffer.byteLength - before <= 1 << 20,
      `${act.name}: ${before} bytes became ${memory.buffer.byteLength}`,
    );
  }
  assert.deepEqual(freed, { OpenPuzzle: 100, Model: 6, SolveMap: 100, Turn: 100 });
});

test("a scene, its raster and a rollout fit together", async () => {
  const pathlight = await load({ weights: null });
  const { bodies } = pathlight.scene(TASK);
  const dynamic = bodies.flatMap((body, index) => (body.dynamic ? [index] : []));
  const { bodies: columns, poses, steps, touching } = pathlight.simulate(TASK);
  assert.deepEqual([...columns], dynamic);
  assert.equal(poses.length, (steps + 1) * columns.length * 3);
  assert.equal(touching.length, steps + 1);
  assert.deepEqual([poses[0], poses[1]], [bodies[dynamic[0]].x, bodies[dynamic[0]].y].map(Math.fround));

  const raster = pathlight.raster(TASK);
  assert.equal(raster.length, 5 * 64 * 64);
  const { x, y } = bodies[0];
  assert.equal(raster[Math.floor(y / 4) * 64 + Math.floor(x / 4)], 1, "the green object is in the first channel");
});

/** Wasm, but not Pathlight's. */
const EMPTY = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]);

test("of weights that are loaded at once, those asked for last stay, and none after free", async () => {
  const pathlight = await load({ weights: null });
  const bytes = readFileSync(join(root, "assets/cross-0.safetensors"));
  const first = pathlight.loadModel();
  await pathlight.loadWeights(bytes);
  await first;
  assert.equal(pathlight.card.setup, "cross");
  const late = pathlight.loadModel();
  pathlight.free();
  await late;
  assert.equal(pathlight.card, null);
});

test("what a getter of an argument frees or calls leaves the object usable", async () => {
  const pathlight = await load();
  const scene = pathlight.customScene(TASK);
  /** Returns the scene; `act` is called while it is read. */
  const meddling = (act) => ({
    ...scene,
    get name() {
      act();
      return "meddling";
    },
  });
  const propose = (puzzle) => pathlight.propose(puzzle, { count: 1 });
  const freeing = meddling(() => pathlight.free());
  assert.equal(propose(freeing).length, 1);
  assert.throws(() => propose(TASK), { code: "no_weights" });
  await pathlight.loadModel();
  const [{ ball }] = propose(TASK);

  const memory = pathlight.memory();
  const forgetting = meddling(() => memory.forget());
  memory.remember(forgetting, ball, false);
  assert.equal(memory.attempts(), 1);
  const freeingMemory = meddling(() => memory.free());
  memory.remember(freeingMemory, ball, false);
  assert.throws(() => memory.attempts(), { code: "bad_data" });
});

test("a server imports the element as nothing", () => {
  assert.equal(run('console.log(Object.keys(await import("pathlight/element")).length)'), "0\n");
});

test("bad input is refused in a sentence with a code", async () => {
  const pathlight = await load({ weights: null });
  const calls = {
    bad_task: [() => pathlight.scene("7:8"), () => pathlight.scene(undefined), () => pathlight.raster(7)],
    bad_scene: [() => pathlight.simulate({}, null)],
    bad_data: [
      () => pathlight.simulate(TASK, [1, 2]),
      () => pathlight.simulate(TASK, "ball"),
      () => pathlight.fold("within", 10),
      () => pathlight.fold("both", 0),
      () => pathlight.auccess("all"),
      () => load("within-0"),
      () => load({ weights: "http://" }),
    ],
    bad_map: [
      () => pathlight.softIou(new Float32Array(3), new Float32Array(3)),
      () => pathlight.softIou("0".repeat(4096), new Float32Array(4096)),
      () => pathlight.softIou(new Float32Array(4096), undefined),
      () => pathlight.paintMap({}, "target", { length: -1 }),
    ],
    invalid_ball: [() => pathlight.solveMap(TASK, 1000).next()],
    no_weights: [
      () => pathlight.imagine(TASK),
      () => load({ weights: "./nowhere.safetensors" }),
      () => load({ weights: "http://127.0.0.1:1/" }),
    ],
    no_model: [() => load({ model: "within-9" })],
    bad_weights: [() => load({ weights: new Uint8Array(8) })],
    no_wasm: [
      () => load({ wasm: "./nowhere.wasm" }),
      () => load({ wasm: new Uint8Array(8) }),
      () => load({ wasm: EMPTY }),
    ],
  };
  for (const [code, refused] of Object.entries(calls)) {
    for (const call of refused) {
      await assert.rejects(
        async () => call(),
        (/** @type {any} */ error) => error.code === code && error.message.length > 20,
        `${code}: ${call}`,
      );
    }
  }
  assert.equal(pathlight.card, null);
  const { status, reason, steps } = pathlight.simulate(TASK, [1, 1, 30]);
  assert.deepEqual([status, reason, steps], ["invalid", "the ball sticks out of the scene", 0]);
});

test("numbers that a script gets wrong are refused by name", async () => {
  const pathlight = await load();
  for (const first of [0, -1, 1.5, "1"])
    assert.throws(() => pathlight.auccess([1, /** @type {any} */ (first)]), {
      code: "bad_data",
      message: /^item 1 must be the number of the first attempt .*, counted from 1, or null, not /,
    });
  for (const seed of /** @type {any[]} */ ([-1, 1.5, "a", 2 ** 32])) {
    const refused = { code: "bad_data", message: /^a seed is a whole number from 0 to 2\^32 - 1, not / };
    assert.throws(() => pathlight.propose(TASK, { seed }), refused);
    assert.throws(() => pathlight.turn(TASK, { seed }).next(), refused);
  }
  for (const count of /** @type {any[]} */ ([0, 1001, "7"]))
    assert.throws(() => pathlight.propose(TASK, { count }), {
      code: "bad_data",
      message: /proposes 1 to 1000 balls, not /,
    });
  const digest = `X${pathlight.attemptLine(TASK).digest.slice(1)}`;
  assert.equal(pathlight.verifyAttempt({ ...pathlight.attemptLine(TASK), digest }).verdict, "not_valid");
});

test("a transfer that breaks off is refused with a code and the address", async (context) => {
  const server = createServer((request, response) => {
    const { pathname, searchParams } = new URL(request.url ?? "", "http://127.0.0.1");
    const content = readFileSync(join(installed, pathname));
    response.writeHead(200, { "content-type": searchParams.get("type") ?? "", "content-length": content.length });
    response.write(content.subarray(0, content.length / 2), () => response.destroy());
  });
  server.listen(0, "127.0.0.1");
  await once(server, "listening");
  context.after(() => server.close());
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  const cut = (path, type) => `http://127.0.0.1:${port}/${path}?type=${type}`;
  const wasm = "pkg/worker/pathlight_bg.wasm";
  for (const [code, options] of /** @type {const} */ ([
    ["no_wasm", { wasm: cut(wasm, "application/wasm"), weights: null }],
    ["no_wasm", { wasm: cut(wasm, "application/octet-stream"), weights: null }],
    ["no_weights", { weights: cut("assets/within-0.safetensors", "application/octet-stream") }],
  ])) {
    const address = String("wasm" in options ? options.wasm : options.weights);
    await assert.rejects(
      load(options),
      (/** @type {any} */ error) =>
        error.code === code && error.message.includes(`could not be loaded: `) && error.message.includes(address),
    );
  }
});

test("missing weights are named by their address", async () => {
  const copy = join(project, "copy");
  cpSync(installed, copy, { recursive: true });
  rmSync(join(copy, "assets/within-0.safetensors"));
  const { load } = await import(join(copy, "pathlight.js"));
  await assert.rejects(load(), {
    code: "no_weights",
    message: /^The model’s weights could not be loaded: ENOENT.* for file:.*\/copy\/assets\/within-0\.safetensors\./,
  });
});

test("a page in place of a file, as servers of single-page apps send it, is called so", async (context) => {
  const server = createServer(({ url }, response) =>
    response
      .writeHead(200, { "content-type": url === "/page" ? "text/html" : "application/wasm" })
      .end("<!doctype html>"),
  );
  server.listen(0, "127.0.0.1");
  await once(server, "listening");
  context.after(() => server.close());
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  for (const file of ["page", "file"]) {
    const address = `http://127.0.0.1:${port}/${file}`;
    await assert.rejects(load({ wasm: address, weights: null }), {
      code: "no_wasm",
      message: /the server answered with a page.* for .*\. Build or install Pathlight again\./,
    });
    await assert.rejects(load({ weights: address }), { code: "no_weights", message: /answered with a page/ });
  }
});

test("a map of outcomes can be read while it grows, and afterwards", async () => {
  const pathlight = await load({ weights: null });
  let during;
  for (const { progress, outcomes } of pathlight.solveMap(TASK, 32)) if (progress === 1) during = outcomes();
  const last = [...pathlight.solveMap(TASK, 32)].at(-1);
  assert.equal(last.progress, 1);
  assert.deepEqual(last.outcomes(), during);
  assert.ok([1, 2, 3].every((outcome) => during.includes(outcome)) && !during.includes(0));
  // Each call returns a copy.
  last.outcomes().fill(0);
  assert.deepEqual(last.outcomes(), during);
  const [first] = pathlight.solveMap(TASK, 32);
  assert.ok(
    first.outcomes().some((outcome) => outcome > 0) && first.outcomes().includes(0),
    "a map that was left can be read too",
  );
});
