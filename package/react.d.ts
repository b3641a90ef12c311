
// scripts/build-package.mjs adds this to the declarations of the element: without React's types there is nothing
// to extend, which TypeScript lets only a declaration file say.

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
  /** React 19 adds such listeners; in React 18 call `addEventListener`. */
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
