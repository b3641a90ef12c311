// The scene on its canvas: paints a state with the wasm, at the resolution of the screen.

import { introPaths, introShown } from "../core/derived/home.ts";
import { isHidden, shownPanel } from "../core/derived/hidden.ts";
import { hints, shownGuess, shownLayers } from "../core/derived/imagined.ts";
import { fault, solutions } from "../core/derived/placing.ts";
import { isDark } from "../core/derived/preferences.ts";
import { ended, lastStep, rollouts } from "../core/derived/run.ts";
import { isSettled, making, selectedBody } from "../core/change/make.ts";
import { SCENE_SIZE } from "../pkg/constants.ts";
import { mapPicture, outcomesPicture, paint, paintMaking, problemsOf } from "../simulator.ts";
import { KNOB, paintKnobs } from "./knobs.ts";
import { magnify } from "./loupe.ts";
import { heldPoint } from "./tools.ts";
import type { View } from "../pkg/page/pathlight.js";
import type { State } from "../core/state.ts";

const MAP_OPACITY = 0.8;
/** Maps shown while the scene is being changed, unless others are selected. */
const LIVE = ["base"] as const;

export class Stage {
  readonly canvas = document.createElement("canvas");
  /** The magnifier for what a dragging finger covers. */
  readonly loupe = document.createElement("canvas");
  /** Whether a finger drags. */
  isTouched = false;
  /** CSS px per px of the scene. */
  scale = 1;
  #context = this.canvas.getContext("2d")!;
  #observer: ResizeObserver;
  #painted: readonly unknown[] = [];

  constructor(state: () => State) {
    const repaint = (): void => {
      this.#painted = [];
      this.paint(state());
    };
    this.loupe.className = "loupe";
    this.loupe.ariaHidden = "true";
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    // The painted content is lost then.
    this.canvas.addEventListener("contextrestored", repaint);
    this.#observer = new ResizeObserver(() => {
      const side = this.canvas.clientWidth;
      const pixels = Math.max(1, Math.round(side * devicePixelRatio));
      this.scale = side / SCENE_SIZE || 1;
      if (pixels === this.canvas.width) return;
      this.canvas.width = this.canvas.height = pixels;
      // At once: by the next frame, an empty canvas would have been seen.
      repaint();
    });
    this.#observer.observe(this.canvas);
  }

  /** Paints a state, unless all visible parts have been painted. */
  paint(state: State): void {
    const { puzzle, run, placement, answers, route, check, make, sketch, text, intro } = state;
    const seen = [puzzle, run, placement, answers, route, check, make, sketch, text, intro, state.kept, state.device];
    if (seen.every((part, index) => part === this.#painted[index])) return;
    this.#painted = seen;
    if (isMade(state)) this.#paintMaking(state);
    else paint(this.#context, puzzle, run?.balls ?? [], viewOf(state, KNOB / this.scale), pictures(state));
    magnify(this.loupe, this.canvas, this.isTouched ? heldPoint(state) : null);
  }

  #paintMaking(state: State): void {
    const { scene } = making(state);
    const problems = problemsOf(scene);
    const troubled = new Set(problems.flatMap(({ body, other }) => [body, other]).filter((index) => index !== null));
    const settled = viewOf(state, 0);
    const view = isSettled(state) ? settled : { ...settled, imagined: null };
    paintMaking(this.#context, scene, view, problems.length ? [] : pictures(state));
    const bodies = [...troubled].flatMap((index) => scene.bodies[index] ?? []);
    paintKnobs(this.#context, selectedBody(state), bodies, 1 / this.scale, isDark(state));
  }

  stop(): void {
    this.#observer.disconnect();
  }
}

/** Whether the scene is shown as it is being made. */
function isMade(state: State): boolean {
  return shownPanel(state) === "make" && state.run === null;
}

function viewOf(state: State, knob: number): View {
  const { run, placement, text } = state;
  const [first] = rollouts(state);
  const isOver = ended(state);
  const isPredicted = shownPanel(state) === "predict";
  const imagined = shownGuess(state);
  const show = introShown(state) ? introPaths(state) : null;
  return {
    step: run?.step ?? 0,
    ball: run ? null : (placement.ball ?? show?.imagined?.of ?? null),
    valid: fault(state) === null,
    knob: show ? 0 : knob,
    hints: show ? show.hints : hints(state),
    whole: isOver && run !== null && lastStep(state) > 0,
    opacity: MAP_OPACITY,
    dark: isDark(state),
    sketch: isPredicted ? state.sketch.line.map(([x, y]) => [x, y]) : [],
    imagined: show ? show.imagined : imagined && { of: imagined.of, ...imagined.imagined },
    approach:
      isOver && (show || run!.round !== null) && !isPredicted && first?.ending.longest_touch === 0
        ? first.nearest
        : null,
    spark: first?.contact ?? null,
    names: run && run.balls.length > 1 ? [text.play.you, text.play.model] : [],
  };
}

function pictures(state: State): HTMLCanvasElement[] {
  const { maps } = state.answers;
  const chosen = shownLayers(state);
  const layers = isMade(state) && state.kept.live && !chosen.length && !state.check ? LIVE : chosen;
  const dark = isDark(state);
  if (isHidden(state, "model")) return [];
  const found = isSettled(state) ? solutions(state) : null;
  const shown = layers.flatMap((name) => {
    const values = maps?.[name];
    return values ? [mapPicture(name, values, dark)] : [];
  });
  return found ? [...shown, outcomesPicture(found.outcomes, dark)] : shown;
}
