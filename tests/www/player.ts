// A puzzle without wasm, for the tests of the pure state: a ball at the right solves it; one at the left edge may not
// be placed, and has room beside it.

import { NOTHING_KEPT } from "../../www/core/change/kept.ts";
import { answered } from "../../www/core/change/model.ts";
import { place } from "../../www/core/change/placement.ts";
import { START } from "../../www/core/change/route.ts";
import { advance, again, drop } from "../../www/core/change/run.ts";
import { start } from "../../www/core/state.ts";
import * as en from "../../www/text/en.ts";
import type { Puzzle } from "../../www/core/puzzle.ts";
import type { State } from "../../www/core/state.ts";
import type {
  AttemptLine,
  Ball,
  Body,
  CustomScene,
  RolloutFacts,
  TriedProposal,
} from "../../www/pkg/page/pathlight.js";

export const SOLVING: Ball = [220, 100, 12];
export const MISSING: Ball = [100, 100, 12];
/** How long a rollout plays, steps. */
export const LAST = 60;

const BODY: Body = { x: 50, y: 50, angle: 0, dynamic: true, shape: "ball", role: "green", parts: [{ circle: 10 }] };

/** A ball, a floor as its goal, and a bar. */
export const CUSTOM: CustomScene = {
  version: 1,
  body1: 0,
  body2: 1,
  bodies: [
    { shape: "ball", radius: 12, x: 60, y: 180, angle: 0, dynamic: true },
    { shape: "bar", length: 200, thickness: 6, x: 128, y: 3, angle: 0, dynamic: false },
    { shape: "bar", length: 64, thickness: 6, x: 160, y: 100, angle: 0, dynamic: true },
  ],
};

const solves = ([x]: Ball) => x > 200;

export function line(ball: Ball, task = "00000:000"): AttemptLine {
  const status = solves(ball) ? "solved" : "not_solved";
  return { task, ball, simulator: 1, status, steps: LAST, digest: "0".repeat(64) };
}

export function puzzle(task = "00000:000"): Puzzle {
  const scene = { body1: 0, body2: 1, bodies: [BODY, { ...BODY, role: "purple" as const, dynamic: false }] };
  /** `object` is the path of the green object; it is another one without a ball. */
  const facts = (ball: Ball, object = Float32Array.of(0, 0)): RolloutFacts => ({
    line: line(ball, task),
    ending: { solved: solves(ball), steps: LAST, longest_touch: solves(ball) ? 180 : 30, final_touch: 0 },
    last: LAST,
    nearest: {
      step: 3,
      gap: 6,
      points: [
        [0, 0],
        [6, 0],
      ],
    },
    contact: null,
    paths: { object, ball: Float32Array.of(0, 0) },
  });
  return {
    source: task,
    key: task,
    about: { id: task, digest: null, name: null, scene },
    scene,
    custom: CUSTOM,
    whyInvalid: ([x]) => (x < 20 ? { kind: "outside" } : null),
    nearestPlace: ([, y, r]) => [20, y, r],
    rollout: (ball) => (ball ? facts(ball) : facts(MISSING, Float32Array.of(0, 9))),
    pathMasks: () => ({ object: Float32Array.of(1, 1, 0, 0) }),
    sketchMask: (path) => Float32Array.of(1, path.length > 4 ? 1 : 0, 0, 0),
  };
}

export const fresh: State = start(
  { ...START, task: "00000:000" },
  puzzle(),
  NOTHING_KEPT,
  { language: "en", theme: "light", asked: null, stillness: false, day: 20_000 },
  en,
);

/** The model's turn, as the worker answers: it tries these balls. */
export function withTurn(state: State, ...balls: Ball[]): State {
  const turn = balls.map((ball) => ({ ball, ending: { solved: solves(ball) } }) as TriedProposal);
  return answered(state, state.puzzle.key, { turn });
}

export const dropAt = (state: State, ball: Ball) => drop(place(again(state), ball, null));

/** Drops a ball and lets it play to its end. */
export const playAt = (state: State, ball: Ball) => advance(dropAt(state, ball), 1e6);
