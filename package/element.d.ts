// What JSDoc cannot say; scripts/build-package.mjs adds it to the declarations of the element.

/** The events of the element, for `addEventListener`. */
export interface PathlightPuzzleEventMap extends HTMLElementEventMap {
  attempt: CustomEvent<PlayedAttempt>;
  modelchange: CustomEvent<{ name: string | null; status: "off" | "loading" | "ready" | "failed" }>;
  share: CustomEvent<Result>;
  statechange: CustomEvent<State>;
}

/** The attributes, as properties. */
export interface PathlightPuzzle {
  /** The puzzle, "00007:008"; null for none. */
  task: string | null;
  /** A custom scene, as the link to it holds it; null for a task. */
  scene: string | null;
  /** The name of the model; null for the first. */
  model: string | null;
  /** A tab, "play", "imagine" or "make", or a part: "compare", "predict" or "map"; null for "play". */
  panel: string | null;
  /** The step of the story: "base", "target", "action", "placement", "imagined" or "run"; null for all together. */
  step: string | null;
  /** @deprecated The old name of `step`. */
  stage: string | null;
  /** "presentation" for the scene and one sentence, in large type; null for all panels. */
  view: string | null;
  /** The number of the model's ball that is looked at, from 1; null for none. */
  proposal: string | null;
  /** The maps over the scene, with commas between them; null for those that the panel or the step lays there. */
  layers: string | null;
  /** How much the maps cover, 0 to 1. */
  opacity: string | null;
  /** "on" or "off": the model's guess for the ball being placed; null for what the person likes. */
  forecast: string | null;
  /** The ball that is being placed: "x,y,r" in px of the scene; null for none. */
  ball: string | null;
  /** The attempt at which somebody solved the puzzle, whom the player is to beat; null for none. */
  challenge: string | null;
  /** The names of the parts that are hidden, with commas between them. */
  hide: string | null;
  /** "light", "dark" or "auto"; null for "auto", which follows the system. */
  theme: string | null;

  addEventListener<Type extends keyof PathlightPuzzleEventMap>(
    type: Type,
    listener: (this: PathlightPuzzle, event: PathlightPuzzleEventMap[Type]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  removeEventListener<Type extends keyof PathlightPuzzleEventMap>(
    type: Type,
    listener: (this: PathlightPuzzle, event: PathlightPuzzleEventMap[Type]) => unknown,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
}

/** The attributes of the element in JSX. */
export interface PuzzleAttributes {
  task?: string | null;
  scene?: string | null;
  model?: string | null;
  panel?: Panel;
  step?: string | null;
  /** @deprecated The old name of `step`. */
  stage?: string | null;
  /** "stage" is the old name of "presentation". */
  view?: "presentation" | "stage" | null;
  layers?: string | null;
  opacity?: number | string;
  proposal?: number | string | null;
  forecast?: "on" | "off";
  ball?: string | null;
  challenge?: number | string | null;
  hide?: string;
  theme?: "auto" | "light" | "dark";
  fill?: boolean;
  remember?: boolean;
  class?: string;
  /** React 19 adds such listeners; in React 18 call `addEventListener`. */
  onattempt?: (event: PathlightPuzzleEventMap["attempt"]) => void;
  onmodelchange?: (event: PathlightPuzzleEventMap["modelchange"]) => void;
  onstatechange?: (event: PathlightPuzzleEventMap["statechange"]) => void;
}

declare global {
  interface HTMLElementTagNameMap {
    "pathlight-puzzle": PathlightPuzzle;
  }
}

// @ts-ignore: without React's types there is nothing to extend.
declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      // @ts-ignore
      "pathlight-puzzle": DetailedHTMLProps<HTMLAttributes<PathlightPuzzle>, PathlightPuzzle> & PuzzleAttributes;
    }
  }
}
