// What a puzzle shows, in one sentence. Knows nothing of the document.

import { STEPS_PER_SECOND } from "../shell/constants.js";
import { sentence } from "../text/sentence.js";
import { text } from "../text/text.js";
import { endingWords } from "./ending-words.js";
import { invalidWords } from "./invalid-words.js";

/** @typedef {import("./session.js").Session} Session */
/** @typedef {import("./shown.js").ShownAttempt} ShownAttempt */

/**
 * The session in one sentence, and its kind for the eye.
 * @param {Session} session
 * @returns {{ kind: "hint" | "wrong" | "ready" | "running" | "trying" | "solved" | "missed", words: string }}
 */
export function statusOf(session) {
  const { state } = session;
  const words = text.play.status;
  switch (state.kind) {
    case "placing":
      return placingStatus(session, state);
    case "watch":
      return { kind: "hint", words: state.ended ? words.watched : words.watching };
    case "compare":
      return state.ended ? comparedStatus(state.pair) : { kind: "hint", words: comparingWords(state.pair) };
    case "attempt":
      return attemptStatus(state, session.playback.last);
  }
}

/**
 * @param {import("./shown.js").AttemptRun & { ended: boolean }} state
 * @param {number} last the last step at which anything moves
 * @returns {{ kind: "running" | "trying" | "solved" | "missed", words: string }}
 */
function attemptStatus({ attempt, ended, ghosts, approach }, last) {
  const { author, number, opened, preview, ending } = attempt;
  const words = text.play.status;
  if (ghosts) return { kind: "trying", words: words.tries(number) };
  const named = words.named(opened ? "file" : author, number, preview ?? false);
  if (!ended) return { kind: "running", words: words.running(named) };
  if (ending.solved) return { kind: "solved", words: words.solved(named, endingWords(ending)) };
  const near = approach ? words.closest(approach.gap, approach.step / STEPS_PER_SECOND) : endingWords(ending);
  return { kind: "missed", words: words.missed(named, near, last < ending.steps) };
}

/**
 * @param {Session} session
 * @param {import("./shown.js").Placing & import("./shown.js").Editing} state
 * @returns {{ kind: "hint" | "wrong" | "ready", words: string }}
 */
function placingStatus({ ball, invalidReason, about }, { refusal, tool }) {
  const words = text.play.status;
  if (refusal) return { kind: "wrong", words: refusal };
  if (tool === "line") return { kind: "hint", words: words.line };
  if (tool === "bodies") return { kind: "hint", words: words.bodies };
  if (!ball) return { kind: "hint", words: words.noBall };
  if (invalidReason) return { kind: "wrong", words: words.notHere(invalidWords(invalidReason, about.scene)) };
  return { kind: "ready", words: words.ready };
}

/**
 * What became of the attempts that were shown over each other. It is good news only if the player solved it.
 * @param {ShownAttempt[]} pair
 * @returns {{ kind: "solved" | "missed", words: string }}
 */
function comparedStatus(pair) {
  const results = pair.map(({ author, number, ending }, index) =>
    text.play.pair.result(author, number, index > 0, endingWords(ending)),
  );
  const solved = pair.some(({ author, ending }) => author === "player" && ending.solved);
  return { kind: solved ? "solved" : "missed", words: `${whoSolved(pair)} ${sentence(results.join("; "))}` };
}

/** @param {ShownAttempt[]} pair */
function whoSolved(pair) {
  const words = text.play.pair;
  const [first, second] = pair.map(({ ending }) => ending.solved);
  const [one, other] = pair.map(({ author }) => author);
  // Of one author, or alone.
  if (one === other || second === undefined) return first || second ? words.solved : words.missed;
  if (first === second) return first ? words.both : words.neither;
  return first ? words.player : words.model;
}

/** @param {ShownAttempt[]} pair */
function comparingWords([first, second]) {
  const { running, alone } = text.play.pair;
  return sentence(
    second ? running([first.author, first.number], [second.author, second.number]) : alone(first.author, first.number),
  );
}
