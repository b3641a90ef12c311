// The whole state as one value that is never changed in place. Each part is described in the file of change/ that
// changes it. Derived values are not stored, but computed in derived/.

import { NO_ANSWERS, MODEL_OFF } from "./change/model.ts";
import { introOf } from "./change/home.ts";
import { NO_BALL, placeLinked } from "./change/placement.ts";
import { LESSON, SHARE } from "./change/dialog.ts";
import { NO_SKETCH } from "./change/sketch.ts";
import type { Check } from "./change/check.ts";
import type { Intro, Recorded } from "./change/home.ts";
import type { Making } from "./change/make.ts";
import type { Kept } from "./change/kept.ts";
import type { Answers, Model } from "./change/model.ts";
import type { Placement } from "./change/placement.ts";
import type { Route } from "./change/route.ts";
import type { Run } from "./change/run.ts";
import type { Device, Notice } from "./change/settings.ts";
import type { Dialog, Lesson, Share } from "./change/dialog.ts";
import type { Sketch } from "./change/sketch.ts";
import type { Puzzle } from "./puzzle.ts";
import type { Ball } from "../pkg/page/pathlight.js";
import type { Text } from "../text/languages.ts";

export interface State {
  /** The content of the address: a puzzle, a panel, the maps over the scene. */
  readonly route: Route;
  readonly puzzle: Puzzle;
  readonly placement: Placement;
  /** The run that the scene plays; null while the ball is being placed. */
  readonly run: Run | null;
  readonly speed: number;
  readonly model: Model;
  /** The worker's answers about this puzzle so far. */
  readonly answers: Answers;
  /** The search for all solutions of one radius; null while it is not shown. */
  readonly check: Check | null;
  /** The path of the green object as the person predicts it. */
  readonly sketch: Sketch;
  /** Whether the walkthrough advances automatically. */
  readonly touring: boolean;
  /** The puzzle as the person changes it; null until something is changed. */
  readonly make: Making | null;
  /** The show on the home page; null once the person plays. */
  readonly intro: Intro | null;
  /** The recording for the home page; null until it is loaded. */
  readonly recorded: Recorded | null;
  /** The dialog over the page. */
  readonly dialog: Dialog | null;
  readonly share: Share;
  readonly lesson: Lesson;
  /** The document that the browser keeps. */
  readonly kept: Kept;
  /** Settings of the device, which apply unless the person has chosen otherwise. */
  readonly device: Device;
  /** A message to the person about an error. */
  readonly notice: Notice | null;
  /** The texts of the current language. */
  readonly text: Text;
}

export function start(
  route: Route,
  puzzle: Puzzle,
  kept: Kept,
  device: Device,
  text: Text,
  ball: Ball | null = null,
): State {
  const first = {
    route,
    puzzle,
    placement: NO_BALL,
    run: null,
    speed: 1,
    model: MODEL_OFF,
    answers: NO_ANSWERS,
    check: null,
    sketch: NO_SKETCH,
    touring: false,
    make: null,
    intro: introOf(route, puzzle),
    recorded: null,
    dialog: null,
    share: SHARE,
    lesson: LESSON,
    kept,
    device,
    notice: null,
    text,
  };
  return placeLinked(first, ball);
}
