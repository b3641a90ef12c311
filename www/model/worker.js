// The worker: fetches the weights, imagines, plays the model's turn, and searches for all solutions, off the page's
// thread. messages.js describes what it is sent and what it answers.
//
// assets/model.json lists the weights beside it: { "models": [{ "name", "file", "sha256" }, …] }.

import { initSync, Model, SolveMap } from "../pkg/pathlight.js";

/** @typedef {import("./messages.js").Calls} Calls */
/** @typedef {{ name: string, file: string, sha256?: string }} ModelEntry */
/** @typedef {(update: import("./messages.js").Update) => void} SendUpdate */
/** @typedef {() => boolean} IsCancelled */

/** Where the weights and their list are. */
const ASSETS = new URL("../assets/", import.meta.url);
/** How long a search runs before it sends what it has found and lets messages in, ms. */
const SLICE = 100;

/** @type {{ [Name in keyof Calls]: (args: Calls[Name]["args"], sendUpdate: SendUpdate, isCancelled: IsCancelled) => Calls[Name]["value"] | Promise<Calls[Name]["value"]> }} */
const calls = { start, load, imagine, propose, turn, solve };

/** @type {Model | null} */
let model = null;
/** The requests that run and have not been cancelled. */
const running = new Set();

addEventListener("message", async ({ data }) => {
  const { id, call, args, cancel } = /** @type {import("./messages.js").Request & import("./messages.js").Cancel} */ (data);
  if (cancel !== undefined) {
    running.delete(cancel);
    return;
  }
  running.add(id);
  try {
    const value = await calls[call](args, (update) => postMessage({ id, update }), () => !running.has(id));
    postMessage({ id, value });
  } catch (error) {
    postMessage({ id, error: failureOf(error) });
  } finally {
    running.delete(id);
  }
});

/**
 * @param {any} error
 * @returns {import("./messages.js").Failure}
 */
function failureOf(error) {
  // After a panic in Rust or a trap the memory of the instance is in no known state.
  const crashed = error?.code === "panic" || error instanceof WebAssembly.RuntimeError;
  const code = crashed ? "crashed" : (error?.code ?? "broken");
  return { code, message: error?.message ?? String(error) };
}

/** @param {Calls["start"]["args"]} args */
function start({ module }) {
  initSync({ module });
  return undefined;
}

/**
 * @param {Calls["load"]["args"]} args
 * @param {SendUpdate} sendUpdate
 */
async function load({ name }, sendUpdate) {
  const list = await fetchModelList();
  const entry = name === null ? list[0] : list.find((one) => one.name === name);
  const names = list.map((one) => one.name);
  if (!entry) throw failure("no_model", `There is no model “${name}” here. There is: ${names.join(", ")}.`);
  const bytes = await fetchWeights(entry.file, sendUpdate);
  await checkHash(bytes, entry);
  const fresh = new Model(bytes);
  model?.free();
  model = fresh;
  return { name: entry.name, names, card: model.card() };
}

function loadedModel() {
  if (!model) throw failure("no_weights", "No model is loaded.");
  return model;
}

/** @param {Calls["imagine"]["args"]} args */
function imagine({ task }) {
  const seen = loadedModel().hasSeen(task);
  const begin = performance.now();
  const maps = loadedModel().imagine(task);
  return { maps, seen, milliseconds: performance.now() - begin };
}

/** @param {Calls["propose"]["args"]} args */
function propose({ task, seed }) {
  return loadedModel().propose(task, seed);
}

/**
 * Tries the model's balls in order, and sends each attempt.
 * @param {Calls["turn"]["args"]} args
 * @param {SendUpdate} sendUpdate
 * @param {IsCancelled} isCancelled
 */
async function turn({ task, seed }, sendUpdate, isCancelled) {
  const turn = loadedModel().turn(task, seed);
  try {
    for (let attempt = turn.attempt(); attempt; attempt = turn.attempt()) {
      sendUpdate({ attempt });
      await yieldToMessages();
      if (isCancelled()) return { finished: false };
    }
    return { finished: true };
  } finally {
    turn.free();
  }
}

/**
 * Maps where a ball of a radius solves a task, and sends the map as it grows.
 * @param {Calls["solve"]["args"]} args
 * @param {SendUpdate} sendUpdate
 * @param {IsCancelled} isCancelled
 */
async function solve({ task, radius }, sendUpdate, isCancelled) {
  const map = new SolveMap(task, radius);
  try {
    for (let more = true; more; ) {
      const end = performance.now() + SLICE;
      while (more && performance.now() < end) more = map.advance();
      sendUpdate({ map: { outcomes: map.outcomes(), progress: map.progress() } });
      await yieldToMessages();
      if (isCancelled()) return { finished: false };
    }
    return { finished: true };
  } finally {
    map.free();
  }
}

const channel = new MessageChannel();
/** @type {(() => void)[]} Those that wait for a message to the channel, in order. */
const waiting = [];
channel.port1.onmessage = () => waiting.shift()?.();

/** Lets waiting messages in. Sends a message to itself, because browsers delay nested timeouts by 4 ms. */
function yieldToMessages() {
  return new Promise((/** @type {(value: void) => void} */ resolve) => {
    waiting.push(resolve);
    channel.port2.postMessage(null);
  });
}

/** @returns {Promise<ModelEntry[]>} */
async function fetchModelList() {
  const response = await fetch(new URL("model.json", ASSETS));
  if (response.status === 404) {
    throw failure("no_weights", "The model’s weights are missing here: there is no assets/model.json. It can neither imagine nor play; you can.");
  }
  if (!response.ok) throw failure("no_weights", `The list of models could not be loaded: the server answered ${response.status}.`);
  const list = await response.json().then((json) => json.models, () => null);
  if (!Array.isArray(list) || list.length === 0) {
    throw failure("no_weights", "The list of models, assets/model.json, names none. Write it again by “pathlight publish”.");
  }
  return list;
}

/**
 * The bytes of a file in assets; sends the fraction that has arrived.
 * @param {string} file
 * @param {SendUpdate} sendUpdate
 */
async function fetchWeights(file, sendUpdate) {
  const response = await fetch(new URL(file, ASSETS));
  if (!response.ok || !response.body) throw failure("no_weights", `The model’s weights are missing here: the server answered ${response.status} for assets/${file}.`);
  const size = Number(response.headers.get("content-length")) || null;
  const chunks = [];
  let length = 0;
  for (const reader = response.body.getReader(); ; ) {
    const { done, value } = await reader.read();
    if (done) break;
    chunks.push(value);
    length += value.length;
    // A compressed file may become longer than the server said.
    sendUpdate({ progress: size && Math.min(length / size, 1) });
  }
  const bytes = new Uint8Array(length);
  let end = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, end);
    end += chunk.length;
  }
  return bytes;
}

/**
 * Refuses weights that are not those that the list names. Browsers hash only on secure and local addresses.
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {ModelEntry} entry
 */
async function checkHash(bytes, { file, sha256 }) {
  if (!sha256 || !crypto.subtle) return;
  const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  const hex = Array.from(digest, (byte) => byte.toString(16).padStart(2, "0")).join("");
  if (hex !== sha256) throw failure("bad_weights", `assets/${file} is not the file that assets/model.json names: it is damaged or old.`);
}

/**
 * @param {string} code
 * @param {string} message
 */
function failure(code, message) {
  return Object.assign(new Error(message), { code });
}
