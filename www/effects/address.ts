// The fragment of the address: #task=00007:008&panel=play&layers=base,target&ball=40,200,12

import { START, hideable, panelsOf } from "../core/change/route.ts";
import { STEPS } from "../core/change/walkthrough.ts";
import { PAGES, upToDate } from "./old-links.ts";
import { isHome } from "../core/derived/home.ts";
import { ATTEMPT_LIMIT, MAPS, MAX_RADIUS, MIN_RADIUS, SCENE_SIZE } from "../pkg/constants.ts";
import type { Link } from "../core/change/route.ts";
import type { State } from "../core/state.ts";
import type { Effect } from "../core/store.ts";
import type { Text } from "../text/languages.ts";

/** One part of a link as text. `read` returns undefined for text that it cannot parse; `words` name the panels. */
interface Codec<Value> {
  write(value: NonNullable<Value>): string;
  read(text: string, words: Text): Value | undefined;
}

const TASK = /^\d{5}:\d{3}$/;

const CODECS: { readonly [Key in keyof Link]: Codec<Link[Key]> } = {
  task: { write: String, read: (text) => (TASK.test(text) ? text : undefined) },
  scene: { write: String, read: (text) => (/^[\w-]+$/.test(text) ? text : undefined) },
  panel: { write: String, read: (text, words) => panelsOf(words).find((panel) => panel === text) },
  layers: someOf(() => MAPS),
  step: { write: String, read: (text) => STEPS.find((step) => step === text) },
  view: { write: String, read: (text) => (text === "presentation" ? text : undefined) },
  challenge: {
    write: String,
    read: (text) => (/^[1-9]\d{0,2}$/.test(text) && Number(text) <= ATTEMPT_LIMIT ? Number(text) : undefined),
  },
  lesson: {
    write: (tasks) => tasks.join(),
    read: (text) => {
      const tasks = text.split(",").filter(Boolean);
      return tasks.every((task) => TASK.test(task)) ? tasks : undefined;
    },
  },
  hide: someOf(hideable),
  ball: {
    write: (ball) => ball.join(),
    read: (text) => {
      if (!/^\d{1,3},\d{1,3},\d{1,2}$/.test(text)) return undefined;
      const [x, y, r] = text.split(",").map(Number) as [number, number, number];
      return x < SCENE_SIZE && y < SCENE_SIZE && r >= MIN_RADIUS && r <= MAX_RADIUS ? [x, y, r] : undefined;
    },
  },
};

/** A subset of the names, in order. */
function someOf<Name extends string>(all: (words: Text) => readonly Name[]): Codec<readonly Name[]> {
  return {
    write: (names) => names.join(),
    read: (text, words) => {
      const wanted = text.split(",").filter(Boolean);
      const names = all(words).filter((name) => wanted.includes(name));
      return names.length === wanted.length ? names : undefined;
    },
  };
}

/** The parts of a link, which are also the attributes of the element. */
export const LINK_PARTS = Object.keys(CODECS) as (keyof Link)[];

/** Returns a part of a link as text; null if it equals the default. */
export function writePart(link: Link, part: keyof Link): string | null {
  const value = link[part];
  if (value === null || String(value) === String(START[part])) return null;
  return (CODECS[part] as Codec<unknown>).write(value);
}

/** Reads parts of a link. `unread` lists those that cannot be parsed and change nothing. */
export function readParts(
  parts: Iterable<readonly [part: string, text: string]>,
  words: Text,
): { link: Link; unread: string[] } {
  const link: Record<string, unknown> = { ...START };
  const unread: string[] = [];
  for (const [part, text] of parts) {
    const value = Object.hasOwn(CODECS, part) ? CODECS[part as keyof Link].read(text, words) : undefined;
    if (value === undefined) unread.push(shortened(`${part}=${text}`));
    else link[part] = value;
  }
  return { link: link as unknown as Link, unread };
}

export function writeAddress(link: Link): string {
  const parts = LINK_PARTS.map((part) => [part, writePart(link, part)] as const);
  return `#${parts.flatMap(([part, text]) => (text === null ? [] : [`${part}=${text}`])).join("&")}`;
}

export function readAddress(hash: string, words: Text): { link: Link; unread: string[] } {
  return readParts(upToDate(partsOf(hash), words), words);
}

/**
 * The address as it was last read or written. If the browser shows another, the person has gone on, and the page is
 * about to follow.
 */
let known = "";

/** Reads the address of the browser. */
export function readLocation(words: Text): { link: Link; unread: string[] } {
  known = location.hash;
  return readAddress(known, words);
}

export function hasMovedOn(): boolean {
  return location.hash !== known;
}

/** The separate page that a link names; null if it names a puzzle or the home page. */
export function pageOf(hash: string): string | null {
  const parts = new Map(partsOf(hash));
  return parts.has("task") || parts.has("scene") ? null : (PAGES.get(parts.get("view") ?? "") ?? null);
}

function partsOf(hash: string): (readonly [part: string, text: string])[] {
  const parts = hash.replace(/^#/, "").split("&").filter(Boolean);
  return parts.map((part) => {
    const [key = "", ...text] = part.split("=");
    return [decoded(key), decoded(text.join("="))] as const;
  });
}

/** The open puzzle and its current view, as a link. */
export function linkOf(state: State): Link {
  // The puzzle in the picture on the home page is not named in the address.
  return { ...state.route, ball: isHome(state) ? null : state.placement.ball };
}

export function addressOf(state: State): string {
  return writeAddress(linkOf(state));
}

/** Delay before the address changes, ms: browsers refuse to change it with every move of a ball. */
const REST = 300;

/** Another puzzle or panel is a step for the back button; other changes are not. */
export const addressEffect: Effect<State> = {
  needs: (state) => [addressOf(state)],
  async run({ state }, signal) {
    const address = addressOf(state);
    if (hasMovedOn() || address === (location.hash || "#")) return;
    const { link } = readAddress(location.hash, state.text);
    const { task, scene, panel, view } = state.route;
    // A puzzle being changed stays one step.
    const isOther = link.task !== task || (link.scene !== scene && (link.scene === null || state.make === null));
    const isStep = isOther || link.panel !== panel || link.view !== view;
    if (!isStep) await rested(signal);
    if (signal.aborted || hasMovedOn()) return;
    if (isStep) history.pushState(null, "", address);
    else history.replaceState(null, "", address);
    known = location.hash;
  },
};

function rested(signal: AbortSignal): Promise<void> {
  return new Promise((resolve) => {
    const timer = setTimeout(resolve, REST);
    signal.addEventListener("abort", () => (clearTimeout(timer), resolve()), { once: true });
  });
}

/** Shortens a text for a message: a damaged link may have thousands of characters. */
function shortened(text: string): string {
  return text.length > 40 ? `${text.slice(0, 39)}…` : text;
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
