// What every view is: a function of the state to a template. It has the store for what its controls ask for.

import type { TemplateResult, nothing } from "lit-html";
import type { State } from "../core/state.ts";
import type { Store } from "../core/store.ts";

export type View = TemplateResult | typeof nothing;

/** A puzzle on the page: its state, and the canvas of its scene. */
export interface App {
  readonly store: Store<State>;
  readonly canvas: HTMLCanvasElement;
  /** Over it, while a finger drags. */
  readonly loupe: HTMLCanvasElement;
  /** In a page of somebody else. */
  readonly embedded: boolean;
  /** What is shown so far: the scene, what stands beside it, what lies below. A frame each, so that none takes long. */
  parts: 1 | 2 | 3;
}
