// The device, the language, and messages about errors.

import type { Theme } from "./kept.ts";
import type { NamedProblem } from "../derived/bodies.ts";
import type { State } from "../state.ts";
import type { Language, Text } from "../../text/languages.ts";

export interface Device {
  readonly language: Language;
  readonly theme: Theme;
  /** The theme that the embedding page asks for, also instead of the person's choice; null for none. */
  readonly asked: Theme | null;
  /** Whether the person prefers reduced motion. */
  readonly stillness: boolean;
  /** Date of the device, in days since 1970. */
  readonly day: number;
}

/** Why a scene may not be played; null if there is no scene. */
export interface BadScene {
  readonly problem: NamedProblem | null;
}

/** A message; the text has its words. */
export type Notice =
  | { readonly kind: "no_task"; readonly task: string }
  | { readonly kind: "unread_link"; readonly parts: readonly string[] }
  | ({ readonly kind: "bad_scene" | "bad_file" } & BadScene)
  | { readonly kind: "storage_full" | "no_picture" | "no_text" }
  /** A file of attempts is being read; `share` is done. */
  | { readonly kind: "opening"; readonly share: number }
  /** `added`: new attempts; `unread`: lines that are not attempts. */
  | { readonly kind: "opened"; readonly added: number; readonly found: number; readonly unread: number }
  | { readonly kind: "no_attempts"; readonly file: string };

export function setDevice(state: State, change: Partial<Device>): State {
  return { ...state, device: { ...state.device, ...change } };
}

export function setText(state: State, text: Text): State {
  return { ...state, text };
}

export function setNotice(state: State, notice: Notice | null): State {
  return { ...state, notice };
}
