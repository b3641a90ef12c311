// The scene on its canvas: paints a state by the wasm, at the resolution of the screen.

import { fault, guess, solutions } from "../core/derived/placing.ts";
import { isDark } from "../core/derived/looks.ts";
import { ended, lastStep, rollouts } from "../core/derived/run.ts";
import { SCENE_SIZE } from "../pkg/constants.ts";
import { mapPicture, outcomesPicture, paint } from "../simulator.ts";
import type { View } from "../pkg/page/pathlight.js";
import type { State } from "../core/state.ts";

/** Radius of the knob, CSS px. */
const KNOB = 7;
const MAP_OPACITY = 0.8;

export class Stage {
  readonly canvas = document.createElement("canvas");
  /** CSS px per px of the scene. */
  scale = 1;
  #context = this.canvas.getContext("2d")!;
  #observer: ResizeObserver;
  #painted: readonly unknown[] = [];

  constructor(onResize: () => void) {
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    // What was painted is gone then.
    this.canvas.addEventListener("contextrestored", () => this.#forget(onResize));
    this.#observer = new ResizeObserver(() => {
      const side = this.canvas.clientWidth;
      const pixels = Math.max(1, Math.round(side * devicePixelRatio));
      this.scale = side / SCENE_SIZE || 1;
      if (pixels === this.canvas.width) return;
      this.canvas.width = this.canvas.height = pixels;
      this.#forget(onResize);
    });
    this.#observer.observe(this.canvas);
  }

  /** Paints a state, unless all that is seen of it has been painted. */
  paint(state: State): void {
    const { puzzle, run, placement, answers, route, check, text } = state;
    const seen = [puzzle, run, placement, answers, route, check, text, state.kept, state.device];
    if (seen.every((part, index) => part === this.#painted[index])) return;
    this.#painted = seen;
    const view = viewOf(state, KNOB / this.scale);
    paint(this.#context, puzzle, run?.balls ?? [], view, pictures(state));
  }

  stop(): void {
    this.#observer.disconnect();
  }

  #forget(onResize: () => void): void {
    this.#painted = [];
    onResize();
  }
}

function viewOf(state: State, knob: number): View {
  const { run, placement, text } = state;
  const [first] = rollouts(state);
  const isOver = ended(state);
  const imagined = guess(state);
  return {
    step: run?.step ?? 0,
    ball: run ? null : placement.ball,
    valid: fault(state) === null,
    knob,
    whole: isOver && run !== null && lastStep(state) > 0,
    opacity: MAP_OPACITY,
    dark: isDark(state),
    imagined: imagined && { of: imagined.of, ...imagined.imagined },
    approach: isOver && first?.ending.longest_touch === 0 ? first.nearest : null,
    spark: first?.contact ?? null,
    names: run && run.balls.length > 1 ? [text.play.you, text.play.model] : [],
  };
}

function pictures(state: State): HTMLCanvasElement[] {
  const { maps } = state.answers;
  const dark = isDark(state);
  const found = solutions(state);
  const layers = state.route.layers.flatMap((name) => {
    const values = maps?.[name];
    return values ? [mapPicture(name, values, dark)] : [];
  });
  return found ? [...layers, outcomesPicture(found.outcomes, dark)] : layers;
}
