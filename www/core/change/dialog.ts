// The dialogs over the page: sharing, a link for a lesson, about, and the confirmation before forgetting all attempts.

import { hideable, panelsOf } from "./route.ts";
import { attempts } from "../derived/duel.ts";
import type { Hideable, Panel } from "./route.ts";
import type { State } from "../state.ts";

export type Dialog = "share" | "lesson" | "about" | "forget";

/** The result as a picture. */
export type Card =
  | { readonly kind: "drawing" }
  | { readonly kind: "ready"; readonly url: string; readonly file: File }
  /** The browser made no picture in time, or noise instead. */
  | { readonly kind: "none"; readonly why: "missing" | "noise" };

export interface Share {
  /** Whether to show the ball of the solution. */
  readonly withBall: boolean;
  readonly card: Card;
  /** Result of the last copy or file. */
  readonly done: "copied" | "not_copied" | "not_shared" | null;
}

export const PRESETS = ["everything", "play", "predict"] as const;
export type Preset = (typeof PRESETS)[number];

export interface Lesson {
  /** Null if the parts are chosen individually. */
  readonly preset: Preset | null;
  readonly hide: readonly Hideable[];
  /** As typed by the person. */
  readonly tasks: string;
  readonly presentation: boolean;
  /** The address as a QR code, a data URL; null if it is too long for one, undefined while it is not known. */
  readonly code: string | null | undefined;
}

export const SHARE: Share = { withBall: false, card: { kind: "drawing" }, done: null };
export const LESSON: Lesson = { preset: "everything", hide: [], tasks: "", presentation: false, code: undefined };

export function openDialog(state: State, dialog: Dialog | null): State {
  const { id } = state.puzzle.about;
  const lesson = { ...LESSON, tasks: state.route.lesson.join(" ") || (id ?? "") };
  return { ...state, dialog, share: SHARE, lesson };
}

export function setShare(state: State, change: Partial<Share>): State {
  return { ...state, share: { ...state.share, ...change } };
}

export function setLesson(state: State, change: Partial<Lesson>): State {
  return { ...state, lesson: { ...state.lesson, ...change } };
}

/** Applies a preset of hidden parts. */
export function usePreset(state: State, preset: Preset): State {
  const panelsBut = (...kept: Panel[]) => panelsOf(state.text).filter((panel) => !kept.includes(panel));
  const hidden: Record<Preset, Hideable[]> = {
    everything: [],
    play: ["puzzles", ...panelsBut("play")],
    // The model's guess would give away what the class should predict.
    predict: ["puzzles", "guess", ...panelsBut("play", "predict")],
  };
  return setLesson(state, { preset, hide: hidden[preset] });
}

export function toggleHidden(state: State, part: Hideable): State {
  const isHidden = (one: Hideable) => state.lesson.hide.includes(one) !== (one === part);
  return setLesson(state, { preset: null, hide: hideable(state.text).filter(isHidden) });
}

/** Forgets all attempts. Other tabs compare the time with theirs (ms since 1970). */
export function forget(state: State, now: number): State {
  const kept = { ...state.kept, attempts: {}, forgotten: now };
  return { ...state, kept, run: attempts(state).length > 0 ? null : state.run, dialog: null };
}
