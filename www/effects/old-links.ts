// Links of earlier versions: each part opens what it named, or its closest successor.

import { hideable } from "../core/change/route.ts";
import type { Text } from "../text/languages.ts";

type Part = readonly [part: string, text: string];

const has = (names: readonly string[], name: string) => names.includes(name);

/** Current panels by their former names. */
const PANEL_NAMES = new Map([
  ["bend", "make"],
  ["compare", "play"],
  ["map", "imagine"],
]);
const MAP_NAMES = new Map([["judge", "success"]]);
/** Parts that a lesson hid, by their former names; other parts no longer exist. */
const HIDDEN_NAMES = new Map([...PANEL_NAMES, ["forecast", "guess"], ["compare", "model"]]);
/** Steps of a former, longer walkthrough, and the nearest current steps. */
const STEP_NAMES = new Map([
  ["judge", "placement"],
  ["success", "placement"],
  ["candidates", "imagined"],
  ["chosen", "run"],
  ["real", "run"],
]);
/** Parts that are now separate pages. */
export const PAGES = new Map([
  ["results", "results.html"],
  ["learns", "learns.html"],
]);

/** Updates the text of a part; parts not listed are unchanged. */
const SUCCESSORS: Record<string, (text: string, words: Text) => readonly Part[]> = {
  panel: (text) => [["panel", PANEL_NAMES.get(text) ?? text]],
  layers: (text) => [["layers", listOf(text, MAP_NAMES).join()]],
  hide: (text, words) => [
    ["hide", [...new Set(listOf(text, HIDDEN_NAMES))].filter((name) => has(hideable(words), name)).join()],
  ],
  // "stage" was the presentation, then a step of the walkthrough.
  view: (text) => {
    if (PAGES.has(text)) return [];
    return text === "predict" ? [["panel", text]] : [["view", text === "stage" ? "presentation" : text]];
  },
  step: (text) => [["step", STEP_NAMES.get(text) ?? text]],
  stage: (text) => [["step", STEP_NAMES.get(text) ?? text]],
  forecast: (text) => (text === "off" ? [["hide", "guess"]] : []),
  model: () => [],
  opacity: () => [],
  proposal: () => [],
};

/** Updates the parts of a link. Two lists for the same part are merged. */
export function upToDate(parts: Iterable<Part>, words: Text): Part[] {
  const found = new Map<string, string>();
  for (const [part, text] of parts) {
    const successors = Object.hasOwn(SUCCESSORS, part) ? SUCCESSORS[part]!(text, words) : [[part, text] as const];
    for (const [name, value] of successors) {
      const before = name === "hide" ? found.get(name) : undefined;
      found.set(name, before ? `${before},${value}` : value);
    }
  }
  // The presentation was the walkthrough in large type.
  if (found.get("view") === "presentation" && found.has("step") && !found.has("panel")) found.set("panel", "imagine");
  return [...found];
}

function listOf(text: string, names: ReadonlyMap<string, string>): string[] {
  return text.split(",").flatMap((name) => (name.trim() ? [names.get(name.trim()) ?? name.trim()] : []));
}
