// The link to an own scene: every scene comes back as it was, the links of usual scenes are short, and damaged text is
// a sentence.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { initSync } from "../../www/pkg/pathlight.js";
import { pathlight } from "../../www/shell/page-api.js";
import { sceneOfText, textOfScene } from "../../www/workshop/scene-link.js";

initSync({ module: await readFile(new URL("../../www/pkg/pathlight_bg.wasm", import.meta.url)) });

/** A second copy of the module, which has read and written nothing. */
const fresh = () => import(`../../www/workshop/scene-link.js?${Math.random()}`);

test("a scene of each template comes back as it was", async () => {
  const reader = await fresh();
  for (const {
    tasks: [task],
  } of pathlight.templates()) {
    const scene = pathlight.ownScene(task);
    assert.deepEqual(await reader.sceneOfText(await textOfScene(scene)), scene, task);
  }
});

test("the link to a usual scene has a few hundred characters", async () => {
  const lengths = [];
  for (const { tasks } of pathlight.templates()) {
    for (const task of tasks.slice(0, 4)) lengths.push((await textOfScene(pathlight.ownScene(task))).length);
  }
  lengths.sort((one, other) => one - other);
  const [median, most] = [lengths[lengths.length / 2], lengths[lengths.length - 1]];
  console.log(`characters of a link: median ${median}, most ${most}`);
  assert.ok(median < 500 && most < 4000, `median ${median}, most ${most}`);
});

test("the scenes that were met lately are known, and not more", async () => {
  const { knownScene, sceneOfText: read, textOfScene: write } = await fresh();
  const scene = pathlight.ownScene("00007:008");
  const texts = [];
  for (let index = 0; index < 300; index += 1) {
    texts.push(await write({ ...scene, name: `Step ${index}` }));
    assert.equal(knownScene(texts[0])?.name, "Step 0", "what is asked for stays");
  }
  assert.equal(knownScene(texts[299])?.name, "Step 299");
  assert.equal(texts.filter((text) => knownScene(text)).length, 100);
  assert.equal((await read(texts[1])).name, "Step 1");
});

test("damaged text is a sentence, wherever it is damaged", async () => {
  const { sceneOfText: read } = await fresh();
  const text = await textOfScene(pathlight.ownScene("00007:008"));
  const damaged = ["", "x", "AAAA", text.slice(0, -7), text.slice(5), `${text.slice(0, 40)}!${text.slice(41)}`];
  for (let at = 0; at < text.length; at += 11)
    damaged.push(text.slice(0, at) + (text[at] === "A" ? "B" : "A") + text.slice(at + 1));
  let refused = 0;
  for (const one of damaged) {
    try {
      const scene = await read(one);
      assert.deepEqual(pathlight.sceneProblems(scene), [], one);
    } catch (error) {
      assert.match(/** @type {Error} */ (error).message, /^This link holds .*\.$/, one);
      refused += 1;
    }
  }
  assert.ok(refused > damaged.length * 0.8, `${refused} of ${damaged.length}`);
});

test("a link that unpacks to more than any scene is refused before it is unpacked whole", async () => {
  const bomb = new Response(
    new Blob([`"${" ".repeat(50_000_000)}"`]).stream().pipeThrough(new CompressionStream("deflate-raw")),
  );
  const text = Buffer.from(await bomb.arrayBuffer()).toString("base64url");
  await assert.rejects(sceneOfText(text), /This link holds/);
});

/** Numbers in 0..1 that are the same each time (Park and Miller's generator). */
function* numbers(seed) {
  for (let state = seed; ;) {
    state = (state * 48271) % 2147483647;
    yield state / 2147483647;
  }
}

/** A scene within the limits of the form; its bodies may overlap. */
function randomScene(random, limits) {
  const draw = ([least, most]) => least + (most - least) * random.next().value;
  const bodies = Array.from({ length: 2 + Math.floor(draw([0, 6])) }, (_, index) => {
    const place = {
      x: draw([0, 256]),
      y: draw([0, 256]),
      angle: draw([-6, 6]),
      dynamic: index === 0 || draw([0, 1]) < 0.3,
    };
    switch (Math.floor(draw([0, 4]))) {
      case 0:
        return { shape: "ball", radius: draw(limits.ball_radius) / 3 + 2, ...place };
      case 1:
        return {
          shape: "bar",
          length: draw(limits.bar_length) / 4 + 2,
          thickness: draw(limits.bar_thickness) / 16 + 2,
          ...place,
        };
      case 2:
        return { shape: "jar", height: draw(limits.jar_height) / 4 + 10, ...place };
      default:
        return { shape: "standing_sticks", length: draw(limits.stick_length) / 4 + 8, ...place };
    }
  });
  return {
    version: 1,
    name: `№ ${Math.floor(draw([0, 1e6]))} ✓`,
    body1: 0,
    body2: 1 + Math.floor(draw([0, bodies.length - 1])),
    bodies,
  };
}

test("a thousand random scenes come back the same through the link and through a file", async () => {
  const { readPuzzles } = await import("../../www/workshop/puzzle-file.js");
  const reader = await fresh();
  const random = numbers(15);
  const scenes = [];
  for (let drawn = 0; scenes.length < 1000; drawn += 1) {
    assert.ok(drawn < 100_000, `only ${scenes.length} of ${drawn} scenes may be played`);
    const scene = randomScene(random, pathlight.sceneLimits());
    if (pathlight.sceneProblems(scene).length === 0) scenes.push(scene);
  }
  for (const scene of scenes) assert.deepEqual(await reader.sceneOfText(await textOfScene(scene)), scene);
  assert.deepEqual(await readPuzzles(new File([JSON.stringify(scenes)], "thousand.json")), scenes);
});
