// Sharing: a link, text and a picture. The link comes first; nothing waits for the picture.

import { setLesson, setShare } from "../core/change/dialog.ts";
import { START, panelsOf } from "../core/change/route.ts";
import { taskOfDay } from "../core/derived/home.ts";
import { isDark } from "../core/derived/preferences.ts";
import { taskOf } from "../core/derived/next.ts";
import { result } from "../core/derived/sharing.ts";
import { benchmark } from "../simulator.ts";
import { writeAddress } from "./address.ts";
import { cardOf } from "./card.ts";
import type { Link } from "../core/change/route.ts";
import type { State } from "../core/state.ts";
import type { Effect, Store } from "../core/store.ts";

export const cardEffect: Effect<State> = {
  needs: (state) =>
    state.dialog === "share"
      ? [state.puzzle, state.kept.attempts, state.answers.turn, state.text, isDark(state), state.share.withBall]
      : null,
  async run(store, signal) {
    const card = await cardOf(store.state);
    const forget = () => card.kind === "ready" && URL.revokeObjectURL(card.url);
    if (signal.aborted) return void forget();
    signal.addEventListener("abort", forget);
    store.change(setShare, { card });
  },
};

/** The puzzle as a challenge. The link reveals neither the ball nor what the model thinks. */
export function shareAddress(state: State): string {
  const { solvedAt } = result(state);
  const link = { ...ownLink(state), challenge: solvedAt };
  return new URL(writeAddress(link), location.href).href;
}

export function shareText(state: State): string {
  const { text, puzzle, device } = state;
  const found = result(state);
  const isDaily = puzzle.about.id === taskOfDay(benchmark(), device.day);
  return text.share.message(text.puzzle.name(puzzle.about), found, isDaily);
}

/** The tasks of a lesson as typed by a person, and the words that are not tasks. */
export function lessonTasks(state: State): { tasks: string[]; wrong: string[] } {
  const written = state.lesson.tasks.split(/[\s,;]+/).filter(Boolean);
  const known = new Set(benchmark().tasks);
  const read = written.map((word) => [word, taskOf(word)] as const);
  const isTask = (task: string | null): task is string => task !== null && known.has(task);
  return {
    tasks: read.map(([, task]) => task).filter(isTask),
    wrong: read.flatMap(([word, task]) => (isTask(task) ? [] : [word])),
  };
}

/** The address of the lesson; null if its puzzles cannot be read. */
export function lessonAddress(state: State): string | null {
  const { tasks, wrong } = lessonTasks(state);
  if (wrong.length) return null;
  const { hide, presentation } = state.lesson;
  const named = tasks.length > 0 ? { ...START, task: tasks[0]! } : ownLink(state);
  const panel = panelsOf(state.text).find((one) => String(one) === state.lesson.preset) ?? START.panel;
  const view = presentation ? "presentation" : null;
  const link: Link = { ...named, panel, view, hide, lesson: tasks.length > 1 ? tasks : [] };
  return new URL(writeAddress(link), location.href).href;
}

/** A link to the open puzzle, without the current view. */
function ownLink({ route, puzzle }: State): Link {
  return { ...START, task: puzzle.about.id, scene: route.scene };
}

export const qrEffect: Effect<State> = {
  needs: (state) => (state.dialog === "lesson" ? [lessonAddress(state)] : null),
  async run(store, signal) {
    const address = lessonAddress(store.state);
    // Loaded separately, because few people need it. If it does not load, the address works without a code.
    const qr = await import("lean-qr").catch(() => null);
    if (qr && address && !signal.aborted) store.change(setLesson, { code: codeOf(address, qr) });
  },
};

function codeOf(address: string, { generate }: typeof import("lean-qr")): string | null {
  try {
    return generate(address).toDataURL({ on: [0, 0, 0], off: [255, 255, 255], scale: 4 });
  } catch {
    // Too long for a code.
    return null;
  }
}

export async function copy(store: Store<State>, text: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    store.change(setShare, { done: "copied" });
  } catch {
    store.change(setShare, { done: "not_copied" });
  }
}

/** The data for the system's share sheet. */
function shared({ state }: Store<State>): ShareData {
  const { card } = state.share;
  const words = { text: shareText(state), url: shareAddress(state) };
  const withPicture = card.kind === "ready" ? { ...words, files: [card.file] } : words;
  return navigator.canShare?.(withPicture) ? withPicture : words;
}

export const canShare = (): boolean => typeof navigator.share === "function";

export async function share(store: Store<State>): Promise<void> {
  try {
    await navigator.share(shared(store));
  } catch (error) {
    if ((error as Error).name !== "AbortError") store.change(setShare, { done: "not_shared" });
  }
}
