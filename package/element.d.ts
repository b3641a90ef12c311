// What JSDoc cannot say; scripts/build-package.mjs adds it to the declarations of the element.

/** The events of the element, for `addEventListener`. */
export interface PathlightPuzzleEventMap extends HTMLElementEventMap {
  attempt: CustomEvent<PlayedAttempt>;
  modelchange: CustomEvent<{ name: string | null; status: "off" | "loading" | "ready" | "failed" }>;
  share: CustomEvent<Result>;
  statechange: CustomEvent<State>;
}

export interface PathlightPuzzle {
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
