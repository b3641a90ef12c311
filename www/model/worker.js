// The worker: fetches the weights, imagines, plays the model's turn, and searches for all solutions, off the page's
// thread.
//
// In:   { id, call: "start", module }           the compiled WebAssembly.Module
//       { id, call: "load", name }              weights by their name in assets/model.json; null for the first
//       { id, call: "imagine", task }
//       { id, call: "propose", task, seed }     the balls of a turn, without trying them
//       { id, call: "turn", task, seed }        one turn at a time
//       { id, call: "solve", task, radius }     one map of all solutions at a time
//       { call: "stop", what }                  ends the "turn" or the "solve" that is on
// Out:  { id, value } or { id, error: { code, message } }; on the way { id, progress }, { id, attempt } and { id, map }
//
// assets/model.json lists the weights beside it: { "models": [{ "name", "file", "sha256" }, …] }.

import { initSync, Model, SolveMap } from "../pkg/pathlight.js";

/** Where the weights and their list are. */
const ASSETS = new URL("../assets/", import.meta.url);

const calls = { start, load, imagine, propose, turn, solve };

/** How long a search goes on before it tells what it has found and lets messages in, ms. */
const SLICE = 100;

let model = null;
/** A token for the turn and for the search that is on; who finds that it is no longer theirs ends. */
const on = { turn: null, solve: null };

self.addEventListener("message", async ({ data: { id, call, ...rest } }) => {
  if (call === "stop") {
    on[rest.what] = null;
    return;
  }
  try {
    const value = await calls[call](rest, (news) => self.postMessage({ id, ...news }));
    self.postMessage({ id, value });
  } catch (error) {
    self.postMessage({ id, error: { code: error.code ?? "broken", message: error.message ?? String(error) } });
  }
});

function start({ module }) {
  initSync({ module });
}

async function load({ name }, tell) {
  const list = await models();
  const entry = name === null ? list[0] : list.find((one) => one.name === name);
  const names = list.map((one) => one.name);
  if (!entry) throw failure("no_model", `There is no model “${name}” here. There is: ${names.join(", ")}.`);
  const bytes = await fetched(entry.file, tell);
  await check(bytes, entry);
  const fresh = new Model(bytes);
  model?.free();
  model = fresh;
  return { name: entry.name, names, card: model.card() };
}

function imagine({ task }) {
  const saw = model.saw(task);
  const start = performance.now();
  const maps = model.imagine(task);
  return { maps, saw, milliseconds: performance.now() - start };
}

/** Tries the model's balls in order, and tells each attempt. Says whether it came to its end. */
async function turn({ task, seed }, tell) {
  const token = (on.turn = {});
  const turn = model.turn(task, seed);
  try {
    for (let attempt = turn.attempt(); attempt; attempt = turn.attempt()) {
      tell({ attempt });
      await breath();
      if (on.turn !== token) return { finished: false };
    }
    return { finished: true };
  } finally {
    turn.free();
  }
}

function propose({ task, seed }) {
  return model.propose(task, seed);
}

/** Maps where a ball of a radius solves a task, and tells the map as it grows. Says whether it came to its end. */
async function solve({ task, radius }, tell) {
  const token = (on.solve = {});
  const map = new SolveMap(task, radius);
  try {
    for (let more = true; more; ) {
      const end = performance.now() + SLICE;
      while (more && performance.now() < end) more = map.advance();
      tell({ map: { picture: map.picture(), progress: map.progress() } });
      await breath();
      if (on.solve !== token) return { finished: false };
    }
    return { finished: true };
  } finally {
    map.free();
  }
}

/** Lets waiting messages in. */
function breath() {
  return new Promise((resume) => setTimeout(resume));
}

async function models() {
  const answer = await fetch(new URL("model.json", ASSETS));
  if (answer.status === 404) {
    throw failure("no_weights", "The model’s weights are missing here: there is no assets/model.json. It can neither imagine nor play; you can.");
  }
  if (!answer.ok) throw failure("no_weights", `The list of models did not come: the server answered ${answer.status}.`);
  const list = await answer.json().then((text) => text.models, () => null);
  if (!Array.isArray(list) || list.length === 0) {
    throw failure("no_weights", "The list of models, assets/model.json, names none. It has to be written again.");
  }
  return list;
}

/** The bytes of a file in assets, with their share of the whole on the way. */
async function fetched(file, tell) {
  const answer = await fetch(new URL(file, ASSETS));
  if (!answer.ok) throw failure("no_weights", `The model’s weights are missing here: assets/${file} did not come (${answer.status}).`);
  const size = Number(answer.headers.get("content-length")) || null;
  const chunks = [];
  let length = 0;
  for (const reader = answer.body.getReader(); ; ) {
    const { done, value } = await reader.read();
    if (done) break;
    chunks.push(value);
    length += value.length;
    // A compressed file may come out longer than the server said.
    tell({ progress: size && Math.min(length / size, 1) });
  }
  const bytes = new Uint8Array(length);
  let end = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, end);
    end += chunk.length;
  }
  return bytes;
}

/** Refuses weights that are not those that the list names. Browsers hash only on secure and local addresses. */
async function check(bytes, { file, sha256 }) {
  if (!sha256 || !self.crypto.subtle) return;
  const digest = new Uint8Array(await self.crypto.subtle.digest("SHA-256", bytes));
  const hex = Array.from(digest, (byte) => byte.toString(16).padStart(2, "0")).join("");
  if (hex !== sha256) throw failure("bad_weights", `assets/${file} is not the file that assets/model.json names: it is damaged or old.`);
}

function failure(code, message) {
  return Object.assign(new Error(message), { code });
}
