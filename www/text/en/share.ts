// Sharing a puzzle, and links for a lesson.

import { formatsOf } from "../formats.ts";
import type { Preset, Sheet } from "../../core/change/sheet.ts";

const { counted } = formatsOf("en-GB");

export interface Found {
  /** Number of the ball that solved, and of the model's ball that did; null if none has. */
  readonly solvedAt: number | null;
  readonly modelAt: number | null;
  /** Number of balls that the model has dropped. */
  readonly modelBalls: number;
}

/** More misses than these are counted, not drawn. */
const MOST_MARKS = 20;

const first = (at: number) => (at === 1 ? "with the first ball" : `with ball ${at}`);
const isWon = ({ solvedAt, modelAt, modelBalls }: Found) =>
  solvedAt !== null && modelBalls >= solvedAt && (modelAt === null || modelAt > solvedAt);

const model = ({ modelAt, modelBalls }: Found) =>
  modelAt !== null
    ? `The model needed ${counted(modelAt, "ball", "balls")}.`
    : modelBalls > 0
      ? `The model had ${counted(modelBalls, "ball", "balls")} and did not solve it.`
      : "";

export const share = {
  titles: {
    share: "Share",
    lesson: "Link for a lesson",
    about: "About Pathlight",
    forget: "Forget everything?",
  } satisfies Record<Sheet, string>,

  /** On the picture. */
  headline: (solvedAt: number | null) => (solvedAt === null ? "Can you solve it?" : `Solved ${first(solvedAt)}`),
  model,
  message: (puzzle: string, found: Found, day: number | null) => {
    const { solvedAt } = found;
    if (solvedAt === null) return `“${puzzle}” in Pathlight: can you solve it?`;
    const misses = solvedAt - 1;
    const marks = `${misses > MOST_MARKS ? `${misses} × 🔴 ` : "🔴".repeat(misses)}🟢`;
    const daily = day === null ? "" : `Pathlight’s puzzle of the day. ${marks} `;
    const result = isWon(found)
      ? `I beat the model at “${puzzle}” ${first(solvedAt)}.`
      : `I solved “${puzzle}” ${first(solvedAt)}.`;
    return `${daily}${result} ${model(found)} ${solvedAt === 1 ? "Can you match it?" : "Can you do better?"}`.replace(
      "  ",
      " ",
    );
  },
  link: "The link",
  noBall: "The link hides your ball, the model’s balls and its guess until the puzzle is solved.",
  copy: "Copy text and link",
  system: "Share…",
  save: "Save the picture",
  drawing: "The picture is being drawn …",
  noCard: {
    missing: "This browser gives no picture. The text and the link say it all.",
    noise:
      "This browser guards its pictures, so there would be stripes instead of one. The text and the link say it all.",
  },
  withBall: "Show my ball in the picture",
  done: {
    copied: "Copied.",
    not_copied: "This browser does not let the page copy. Select the link above and copy it.",
    not_shared: "This browser could not share it. Copy the text and the link.",
  },
  send: "Send it on",

  challenge: (at: number) =>
    `Somebody solved this ${first(at)}. Can you do better? The model keeps quiet until you have solved it.`,
  challenged: (at: number, theirs: number) =>
    at < theirs
      ? `You win: they needed ${theirs} balls.`
      : at === theirs
        ? "A draw: they needed as many."
        : `They needed ${counted(theirs, "ball", "balls")}.`,

  puzzles: "Puzzles, by number, one after another",
  /** In a lesson. */
  place: (number: number, of: number) => `${number} of ${of}`,
  noPuzzles: (wrong: string[]) =>
    `${wrong.join(", ")}: ${wrong.length === 1 ? "that is no puzzle" : "these are no puzzles"}. Their numbers look like 00007:008, or 7:8.`,
  shows: "What the class sees",
  presets: { everything: "Everything", play: "Play only", predict: "Predict: no guess of the model" } satisfies Record<
    Preset,
    string
  >,
  customise: "Customise",
  parts: { puzzles: "The ways to other puzzles", guess: "The model’s guess", model: "The model" },
  presentation: "As a presentation, for a projector",
  copyLink: "Copy the link",
  preview: "See it as the class does",
  code: "The link as a QR code",
  noCode: "The link is too long for a QR code. It works without one.",
  ownMachine: "This link works only on this computer: serve the page where others can reach it.",
  end: "The link holds everything: nothing is stored elsewhere.",
};
