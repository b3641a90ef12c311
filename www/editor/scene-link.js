// A scene as the text of a link, and back: its JSON, deflated, in base64url. Damaged or foreign text is refused with a
// sentence, and nothing larger than a scene may be is unpacked. Knows nothing of the document.

import { failure } from "../api/failure.js";
import { pathlight } from "../shell/page-api.js";
import { text as catalogue } from "../text/text.js";
import { plainScene } from "./plain-scene.js";
import { problemWords } from "./problem-words.js";

/** @typedef {import("../pkg/pathlight.js").CustomScene} CustomScene */

/** More than the JSON of a scene of the most bodies, bytes. */
const MAX_JSON = 256_000;

/** The most texts to remember: every change of a puzzle makes another. */
const MOST_KNOWN = 100;

/**
 * The scenes whose text is known, because they were read or written lately; that of the latest is the last.
 * @type {Map<string, CustomScene>}
 */
const known = new Map();

/**
 * Returns the scene of a text that was read or written lately, or null.
 * @param {string} text
 */
export function knownScene(text) {
  const scene = known.get(text);
  if (scene) remember(text, scene);
  return scene ?? null;
}

/**
 * @param {string} text
 * @param {CustomScene} scene
 */
function remember(text, scene) {
  known.delete(text);
  known.set(text, scene);
  if (known.size > MOST_KNOWN) known.delete(known.keys().next().value ?? "");
}

/**
 * Returns the text of a scene.
 * @param {CustomScene} scene
 * @returns {Promise<string>}
 */
export async function textOfScene(scene) {
  const json = new Blob([JSON.stringify(scene)]).stream();
  const deflated = new Uint8Array(
    await new Response(json.pipeThrough(new CompressionStream("deflate-raw"))).arrayBuffer(),
  );
  const text = btoa(String.fromCharCode(...deflated))
    .replaceAll("+", "-")
    .replaceAll("/", "_")
    .replaceAll("=", "");
  remember(text, scene);
  return text;
}

/**
 * Returns the scene of a text. Rejects with a sentence if the text is damaged or the scene may not be played.
 * @param {string} text
 * @returns {Promise<CustomScene>}
 */
export async function sceneOfText(text) {
  const before = knownScene(text);
  if (before) return before;
  /** @type {CustomScene} */
  let scene;
  try {
    const bytes = Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (character) =>
      character.charCodeAt(0),
    );
    scene = JSON.parse(await inflated(new Blob([bytes])));
  } catch {
    throw failure("bad_data", catalogue.editor.link.damaged);
  }
  const [problem] = pathlight.sceneProblems(scene);
  if (problem) throw failure("bad_data", catalogue.editor.link.unplayable(problemWords(problem, scene)));
  const plain = plainScene(scene);
  remember(text, plain);
  return plain;
}

/** @param {Blob} deflated */
async function inflated(deflated) {
  const reader = deflated
    .stream()
    .pipeThrough(new DecompressionStream("deflate-raw"))
    .pipeThrough(new TextDecoderStream("utf-8", { fatal: true }))
    .getReader();
  let json = "";
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return json;
    json += value;
    // More than a scene.
    if (json.length > MAX_JSON) throw new RangeError();
  }
}
