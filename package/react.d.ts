
// scripts/build-package.mjs appends this to the declarations of the element. Without React's types there is nothing to
// extend, and only a declaration file may ignore that.

/** The attributes of the element in JSX. */
export interface PuzzleAttributes extends Partial<
  Pick<
    PathlightPuzzle,
    "task" | "scene" | "panel" | "layers" | "step" | "view" | "challenge" | "lesson" | "hide" | "ball"
  >
> {
  theme?: "light" | "dark" | null;
  fill?: boolean;
  remember?: boolean;
  class?: string;
  /** React 19 adds these listeners; in React 18, call `addEventListener`. */
  onattempt?: (event: PathlightPuzzleEventMap["attempt"]) => void;
  onmodelchange?: (event: PathlightPuzzleEventMap["modelchange"]) => void;
  onstatechange?: (event: PathlightPuzzleEventMap["statechange"]) => void;
}

// @ts-ignore
declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      // @ts-ignore
      "pathlight-puzzle": DetailedHTMLProps<HTMLAttributes<PathlightPuzzle>, PathlightPuzzle> & PuzzleAttributes;
    }
  }
}
