// The fragment of the address: #task=00007:008&panel=play&layers=base,target&ball=40,200,12

import { PANELS, START } from "../core/change/route.ts";
import { MAPS, MAX_RADIUS, MIN_RADIUS, SCENE_SIZE } from "../pkg/constants.ts";
import type { Link } from "../core/change/route.ts";
import type { State } from "../core/state.ts";
import type { Effect } from "../core/store.ts";

/** One part of a link as text. `read` returns undefined for text that it does not understand. */
interface Codec<Value> {
  write(value: NonNullable<Value>): string;
  read(text: string): Value | undefined;
}

const CODECS: { readonly [Key in keyof Link]: Codec<Link[Key]> } = {
  task: { write: String, read: (text) => (/^\d{5}:\d{3}$/.test(text) ? text : undefined) },
  panel: { write: String, read: (text) => PANELS.find((panel) => panel === text) },
  layers: {
    write: (layers) => MAPS.filter((map) => layers.includes(map)).join(),
    read: (text) => {
      const names = text.split(",").filter(Boolean);
      const layers = MAPS.filter((map) => names.includes(map));
      return layers.length === names.length ? layers : undefined;
    },
  },
  ball: {
    write: (ball) => ball.join(),
    read: (text) => {
      if (!/^\d{1,3},\d{1,3},\d{1,2}$/.test(text)) return undefined;
      const [x, y, r] = text.split(",").map(Number) as [number, number, number];
      return x < SCENE_SIZE && y < SCENE_SIZE && r >= MIN_RADIUS && r <= MAX_RADIUS ? [x, y, r] : undefined;
    },
  },
};

/** What equals the start is left out. */
export function writeAddress(link: Link): string {
  const parts = Object.entries(CODECS).map(([key, codec]) => {
    const value = link[key as keyof Link];
    if (value === null || String(value) === String(START[key as keyof Link])) return null;
    return `${key}=${(codec as Codec<unknown>).write(value as {})}`;
  });
  return `#${parts.filter((part) => part !== null).join("&")}`;
}

/** Reads a link; `unread`: its parts that are not understood, which change nothing. */
export function readAddress(hash: string): { link: Link; unread: string[] } {
  const link: Record<string, unknown> = { ...START };
  const unread: string[] = [];
  for (const part of hash.replace(/^#/, "").split("&").filter(Boolean)) {
    const [key, text] = [part.split("=", 1)[0]!, decoded(part.slice(part.indexOf("=") + 1))];
    const value = Object.hasOwn(CODECS, key) ? CODECS[key as keyof Link].read(text) : undefined;
    if (value === undefined) unread.push(part.length > 40 ? `${part.slice(0, 39)}…` : part);
    else link[key] = value;
  }
  return { link: link as unknown as Link, unread };
}

export function addressOf({ route, placement }: State): string {
  return writeAddress({ ...route, ball: placement.ball });
}

/** Browsers refuse an address that changes with every move of a ball, ms. */
const REST = 300;

/** Another puzzle or panel is a step that "back" leads from; other changes are not. */
export const addressEffect: Effect<State> = {
  needs: (state) => [addressOf(state)],
  async run({ state }, signal) {
    const address = addressOf(state);
    if (address === location.hash) return;
    const { link } = readAddress(location.hash);
    if (location.hash && (link.task !== state.route.task || link.panel !== state.route.panel))
      return history.pushState(null, "", address);
    await rested(signal);
    if (!signal.aborted) history.replaceState(null, "", address);
  },
};

function rested(signal: AbortSignal): Promise<void> {
  return new Promise((resolve) => {
    const timer = setTimeout(resolve, REST);
    signal.addEventListener("abort", () => (clearTimeout(timer), resolve()), { once: true });
  });
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
