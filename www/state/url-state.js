// The state of a puzzle as one object, and its two-way translation to texts: the attributes of its element, and the
// fragment of the page's address (what follows `#`). A link carries the task, the model, the panel, the layers and the
// ball, so that it opens the same view elsewhere; for teaching it may hide parts of the page. Knows nothing of the
// document.

import { NAME } from "../storage/attempt-lines.js";
import { ATTEMPT_LIMIT, MAPS, MAX_RADIUS, MIN_RADIUS, SCENE_SIZE } from "../shell/constants.js";
import { text as catalogue } from "../text/text.js";
import { PANELS } from "./panels.js";

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("../pkg/pathlight.js").MapName} MapName */

/** The steps of the story that show maps. */
export const MAP_STEPS = /** @type {const} */ (["base", "target", "action", "placement"]);
/** The steps that follow for a model that imagines balls: what each would do, and what comes of the one it tries. */
export const CHOICE_STEPS = /** @type {const} */ (["imagined", "run"]);
/** @typedef {typeof CHOICE_STEPS[number]} ChoiceStep */
/** @typedef {typeof MAP_STEPS[number] | ChoiceStep} Step */
const PANEL_NAMES = PANELS.map(({ name }) => name);
/** What a link can hide: the panels, of which one stays, and what the document marks with data-hideable. */
export const HIDEABLE = /** @type {const} */ ([
  "puzzles",
  "tools",
  "story",
  "hint",
  "fields",
  "watch",
  "attempts",
  "forecast",
  "transport",
  "speed",
  ...PANEL_NAMES,
  "save",
]);
/**
 * What the page can show instead of the home page: the results of the models, and the model as it learns from puzzle to
 * puzzle.
 */
export const PAGE_VIEWS = /** @type {const} */ (["results", "learns"]);
/** @typedef {typeof PAGE_VIEWS[number]} PageView */
/** @typedef {import("./panels.js").Panel} Panel */
/** @typedef {typeof HIDEABLE[number]} Hideable */

/**
 * @typedef {object} State
 * @property {string | null} task "00007:008", or null for the home page or a custom scene
 * @property {string | null} scene a custom scene as editor/scene-link.js packs it, or null
 * @property {string | null} model a name in assets/model.json, or null for the first
 * @property {Panel} panel as the address names it; it may be hidden, see `viewOf`
 * @property {Step | null} step the step that the walkthrough is at, or null for all together
 * @property {"presentation" | PageView | null} view "presentation" for the scene and one sentence, in large type; with
 *   no task, what is shown instead of the home page; null for all panels
 * @property {number | null} proposal the number of the model's ball that is looked at, from 1, or null
 * @property {MapName[] | null} layers the maps to lay over the scene, in the order of MAPS; null for those that the
 *   panel lays there by itself, see `viewOf`
 * @property {number} opacity how much the maps cover, 0..1
 * @property {boolean | null} forecast whether the model's guess for the ball being placed is shown; null if the link
 *   does not say, see `viewOf`
 * @property {Ball | null} ball the ball being placed
 * @property {number | null} challenge the attempt at which whoever sent the link solved the puzzle, or null
 * @property {Hideable[]} hide the parts of the page that are hidden, in the order of HIDEABLE
 */

/**
 * What is shown when the address says nothing: the home page.
 * @type {Readonly<State>}
 */
export const INITIAL_STATE = Object.freeze({
  task: null,
  scene: null,
  model: null,
  panel: "play",
  step: null,
  view: null,
  proposal: null,
  layers: null,
  opacity: 0.8,
  forecast: null,
  ball: null,
  challenge: null,
  hide: [],
});

/**
 * Returns a copy in which missing values are the initial ones: states that scripts have stored may lack some.
 * @param {Partial<State>} state
 * @returns {State}
 */
export function completed(state) {
  const given = Object.entries(state).filter(([, value]) => value !== undefined && value !== null);
  return { ...INITIAL_STATE, ...Object.fromEntries(given) };
}

/** @typedef {{ format: (value: any) => string, parse: (text: string) => any }} Codec */

/** What old links call otherwise. */
const RENAMED = new Map([
  ["bend", "make"],
  ["stage", "presentation"],
  ["judge", "success"],
]);

/** The steps of the longer story of old links, and the nearest of today's. */
const RENAMED_STEPS = new Map([
  ["judge", "placement"],
  ["success", "placement"],
  ["candidates", "imagined"],
  ["chosen", "run"],
  ["real", "run"],
]);

const INTEGER = /^\d{1,3}$/;
/** @type {Codec} */
const ATTEMPT = {
  format: String,
  parse: (text) =>
    INTEGER.test(text) && !text.startsWith("0") && Number(text) <= ATTEMPT_LIMIT ? Number(text) : undefined,
};
/** A packed scene; only unpacking it tells whether it is one. */
const PACKED = /^[\w-]{1,32000}$/;

/**
 * The keys of a link. `parse` returns undefined for text that it does not understand.
 * @type {Record<string, Codec>}
 */
const CODECS = {
  task: { format: String, parse: (text) => (/^\d{5}:\d{3}$/.test(text) ? text : undefined) },
  scene: { format: String, parse: (text) => (PACKED.test(text) ? text : undefined) },
  model: { format: String, parse: (text) => (NAME.test(text) ? text : undefined) },
  panel: oneOf(PANEL_NAMES),
  step: oneOf([...MAP_STEPS, ...CHOICE_STEPS], RENAMED_STEPS),
  view: oneOf(["presentation", ...PAGE_VIEWS]),
  proposal: ATTEMPT,
  layers: someOf(MAPS),
  opacity: { format: String, parse: (text) => (/^(0(\.0+)?|1(\.0+)?|0?\.\d+)$/.test(text) ? Number(text) : undefined) },
  forecast: {
    format: (on) => (on ? "on" : "off"),
    parse: (text) => (text === "on" ? true : text === "off" ? false : undefined),
  },
  ball: {
    format: (ball) => ball.join(","),
    parse: (text) => {
      const parts = text.split(",");
      if (parts.length !== 3 || !parts.every((part) => INTEGER.test(part))) return undefined;
      const [x, y, r] = parts.map(Number);
      return x < SCENE_SIZE && y < SCENE_SIZE && r >= MIN_RADIUS && r <= MAX_RADIUS ? [x, y, r] : undefined;
    },
  },
  challenge: ATTEMPT,
  hide: someOf(HIDEABLE),
};

/** The keys of old links that have another name now. */
const RENAMED_KEYS = new Map([["stage", "step"]]);

/**
 * @param {readonly string[]} names
 * @param {Map<string, string>} [renamed] old names
 * @returns {Codec}
 */
function oneOf(names, renamed = RENAMED) {
  return { format: String, parse: (text) => names.find((name) => name === (renamed.get(text) ?? text)) };
}

/**
 * @param {readonly string[]} names
 * @returns {Codec}
 */
function someOf(names) {
  return {
    format: (chosen) => chosen.join(","),
    parse: (text) => {
      const chosen = text
        .split(",")
        .map((name) => RENAMED.get(name.trim()) ?? name.trim())
        .filter(Boolean);
      return chosen.every((name) => names.includes(name)) ? names.filter((name) => chosen.includes(name)) : undefined;
    },
  };
}

/**
 * The fragment for a state, without `#`; what equals the initial state is left out.
 * @param {State} state
 */
export function formatFragment(state) {
  const texts = Object.entries(formatState(state)).filter(([, text]) => text !== null);
  return texts.map(([key, text]) => `${key}=${text}`).join("&");
}

/**
 * Each part of a state as text; null where it equals the initial state.
 * @param {State} state
 * @returns {Record<string, string | null>}
 */
export function formatState(state) {
  /** @type {Record<string, unknown>} */
  const values = { ...state };
  /** @type {Record<string, unknown>} */
  const initial = { ...INITIAL_STATE };
  const isInitial = (/** @type {string} */ key) => JSON.stringify(values[key]) === JSON.stringify(initial[key]);
  return Object.fromEntries(
    Object.entries(CODECS).map(([key, { format }]) => [key, isInitial(key) ? null : format(values[key])]),
  );
}

/**
 * The state that texts by key ask for, and those that cannot be read.
 * @param {[key: string, text: string][]} texts
 * @returns {{ state: State, unread: [key: string, text: string][] }}
 */
export function parseState(texts) {
  /** @type {Record<string, unknown>} */
  const parsed = {};
  /** @type {[key: string, text: string][]} */
  const unread = [];
  for (const [name, text] of texts) {
    const key = RENAMED_KEYS.get(name) ?? name;
    const value = Object.hasOwn(CODECS, key) ? CODECS[key].parse(text) : undefined;
    if (value === undefined) unread.push([name, text]);
    else parsed[key] = value;
  }
  const state = { ...INITIAL_STATE, ...parsed };
  // A custom scene takes the place of a task.
  if (state.scene !== null) state.task = null;
  // A puzzle takes the place of a view of the page.
  if ((state.task ?? state.scene) !== null && state.view !== "presentation") state.view = null;
  return { state, unread };
}

/**
 * The state that a link asks for, and a sentence about what in it cannot be read (or null).
 * @param {string} hash
 * @returns {{ state: State, problem: string | null }}
 */
export function parseFragment(hash) {
  const parts = hash.replace(/^#/, "").split("&").filter(Boolean);
  const { state, unread } = parseState(
    parts.map((part) => {
      const [key, ...rest] = part.split("=");
      return [decoded(key), decoded(rest.join("="))];
    }),
  );
  const named = unread.slice(0, NAMED).map(([key, text]) => shortened(text ? `${key}=${text}` : key));
  return { state, problem: named.length ? catalogue.reading.link.unread(named, unread.length > NAMED) : null };
}

/** How many parts of a link that cannot be read are named. */
const NAMED = 3;

/**
 * A text for a sentence: a damaged scene alone may have thousands of characters.
 * @param {string} text
 */
function shortened(text) {
  return text.length > 40 ? `${text.slice(0, 39)}…` : text;
}

/** @param {string} text */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
