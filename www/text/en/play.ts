// Playing: placing and dropping the ball, the duel and its verdict, the list of attempts, maps and the check.

import { ATTEMPT_LIMIT } from "../../pkg/constants.ts";
import { GOAL_SECONDS, formatsOf, secondsOf } from "../formats.ts";
import { balls } from "./widths.ts";
import type { Outcome, Verdict } from "../../core/derived/duel.ts";

const { counted, percent, seconds } = formatsOf("en-GB");

const OUTCOMES: Record<Outcome, (round: number, modelAt: number | null) => string> = {
  won: (round) => (round === 1 ? "You beat the model with your first ball!" : `You beat the model with ball ${round}!`),
  draw: (round) => `A draw: both solve it with ball ${round}.`,
  late: (round, modelAt) => `Solved with ball ${round}! The model needed ${modelAt}.`,
  lost: (round) => `The model solves it with ball ${round}. Can you?`,
  behind: (_, modelAt) => `Not yet. The model needed ${counted(modelAt!, "ball", "balls")}.`,
  neither: () => "Neither of you, not yet.",
  solved: (round) => (round === 1 ? "Solved with your first ball!" : `Solved with ball ${round}!`),
  missed: () => "Not yet.",
  after: () => "A miss, but you have solved it already.",
};

export const play = {
  tab: "Play",
  step: {
    start: "Play against it",
    drop: "Drop it",
    run: "Let it run",
    pause: "Pause",
    play: "Go on",
    again: "Try again",
    back: "Your turn",
    next: "Next puzzle",
    try: "Play it",
    make: "Back to making",
  },
  placeFirst: "Click or tap the scene to place your red ball. Nobody touches anything after that.",
  /** Only for screen readers. */
  keys: "By keys: arrows place and move it, plus and minus change its size, Enter drops it.",
  ready: "Ready. Drop it!",
  choosing: "The model chooses its ball …",
  running: "Now nobody touches anything.",
  full: `You have used all ${ATTEMPT_LIMIT} balls of this puzzle.`,

  verdict: ({ outcome, round, modelAt }: Verdict) => OUTCOMES[outcome](round, modelAt),
  /** How a miss ended. */
  miss: ({ facts: { ending, nearest }, radius }: Verdict) =>
    ending.longest_touch > 0
      ? `Green touched the goal for ${seconds(secondsOf(ending.longest_touch))} of ${GOAL_SECONDS}.`
      : `Green missed the goal by ${balls(nearest.gap, radius)}.`,
  guessed: (chance: number, off: number, radius: number) =>
    `The model gave your ball a chance of ${chance < 0.01 ? "under 1%" : percent(chance)}; its guess was ${balls(off, radius)} off.`,
  luck: (solved: number, valid: number) =>
    solved > 0.6 * valid
      ? `A plan: ${solved} of the ${valid} balls beside yours solve it too.`
      : solved > 0.25 * valid
        ? `A plan with some luck: ${solved} of the ${valid} balls beside yours solve it too.`
        : `Mostly luck: ${solved} of the ${valid} balls beside yours solve it too.`,
  showModel: "Show the model’s ball",

  playback: "Playback",
  moment: "Moment",
  speed: "Speed",
  times: (speed: number) => (speed === 0.25 ? "¼×" : `${speed}×`),
  time: (steps: number) => seconds(secondsOf(steps)),
  replay: "Play it again",

  radius: "Radius",
  duel: "You against the model",
  you: "You",
  model: "Model",
  noAttempts: "Every ball you drop is a duel: the model drops one of its own.",
  /** The mark of an attempt, and its name for a screen reader. */
  solved: "solved",
  missed: "missed",
  waiting: "not yet",
  done: "done",
  round: (round: number) => `Ball ${round}: show it again`,
  guess: "The model’s guess",
  alone: "Play without the model",
};
