// A view: a function from the state to a template. It gets the store for the actions of its controls.

import type { TemplateResult, nothing } from "lit-html";
import type { State } from "../core/state.ts";
import type { Store } from "../core/store.ts";

export type View = TemplateResult | typeof nothing;

/** A puzzle on the page: its state, and the canvas of its scene. */
export interface App {
  readonly store: Store<State>;
  readonly canvas: HTMLCanvasElement;
  /** The magnifier over the canvas, while a finger drags. */
  readonly loupe: HTMLCanvasElement;
  /** Whether the puzzle is embedded in another page. */
  readonly embedded: boolean;
  /** Parts shown so far: the scene, then those next to it, then those below. A frame each, so that none takes long. */
  parts: 1 | 2 | 3;
}
