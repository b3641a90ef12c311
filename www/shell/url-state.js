// What the page shows, as one object, and its two-way translation to the part of the address after `#`.
// A link carries the task, the model, the panel, the layers and the ball, so it opens the same view elsewhere; for
// teaching it may hide parts of the page.
// Knows nothing of the document.

/** What the nets imagine, in their order: the paper's four maps, and the judge's. */
export const STAGES = ["base", "target", "action", "placement", "judge"];
export const PANELS = ["play", "imagine", "compare", "predict", "map"];
/** What a link can hide: the panels but Play, and what the document marks with data-part. */
export const PARTS = ["puzzles", "story", "fields", "watch", "attempts", "imagine", "compare", "predict", "map"];

/** What is shown when the address says nothing: the grid of templates. */
export const START = Object.freeze({
  /** "00007:008", or null for the grid. */
  task: null,
  /** A name in assets/model.json, or null for the first. */
  model: null,
  panel: "play",
  /** The stage that the story of the model is at, or null for all together. */
  stage: null,
  /** The number of the model's ball that is looked at, from 1, or null. */
  proposal: null,
  /** The maps laid over the scene, in the order of STAGES. */
  layers: [],
  /** How much the maps cover, 0..1. */
  opacity: 0.8,
  /** [x, y, r] in whole px, or null. */
  ball: null,
  /** The parts of the page that are hidden, in the order of PARTS. */
  hide: [],
});

const WHOLE = /^\d{1,3}$/;

/** Each key of a link: its text for a value, and the value of a text; undefined says that it is none. */
const KEYS = {
  task: { text: (id) => id, value: (text) => (/^\d{5}:\d{3}$/.test(text) ? text : undefined) },
  model: { text: (name) => name, value: (text) => (/^[\w.-]+$/.test(text) ? text : undefined) },
  panel: { text: (name) => name, value: (text) => (PANELS.includes(text) ? text : undefined) },
  stage: { text: (name) => name, value: (text) => (STAGES.includes(text) ? text : undefined) },
  proposal: { text: String, value: (text) => (/^([1-9]\d?|100)$/.test(text) ? Number(text) : undefined) },
  layers: some(STAGES),
  opacity: {
    text: String,
    value: (text) => (/^(0|1|0?\.\d+)$/.test(text) ? Number(text) : undefined),
  },
  ball: {
    text: (ball) => ball.join(","),
    value: (text) => {
      const parts = text.split(",");
      if (parts.length !== 3 || !parts.every((part) => WHOLE.test(part))) return undefined;
      const [x, y, r] = parts.map(Number);
      return x <= 255 && y <= 255 && r >= 2 && r <= 32 ? [x, y, r] : undefined;
    },
  },
  hide: some(PARTS),
};

/** A key whose value is some of these names. */
function some(all) {
  return {
    text: (names) => names.join(","),
    value: (text) => {
      const names = text.split(",").filter(Boolean);
      return names.every((name) => all.includes(name)) ? all.filter((name) => names.includes(name)) : undefined;
    },
  };
}

/** The part of the address after `#` for a state; what is as at the start is left out. */
export function write(state) {
  const parts = Object.entries(KEYS)
    .filter(([key]) => JSON.stringify(state[key]) !== JSON.stringify(START[key]))
    .map(([key, { text }]) => `${key}=${text(state[key])}`);
  return parts.join("&");
}

/** The state that a link asks for, and a sentence about what in it cannot be read (or null). */
export function read(hash) {
  const state = { ...START };
  const problems = [];
  for (const part of hash.replace(/^#/, "").split("&").filter(Boolean)) {
    const [key, ...rest] = part.split("=");
    const text = decoded(rest.join("="));
    const value = Object.hasOwn(KEYS, key) ? KEYS[key].value(text) : undefined;
    if (value === undefined) problems.push(`“${decoded(part)}”`);
    else state[key] = value;
  }
  const problem = problems.length ? `This link says ${problems.join(" and ")}, which Pathlight does not understand.` : null;
  return { state, problem };
}

function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
