// What the scene of a puzzle shows, as one state: the ball being placed, or a run of an attempt, of the scene without a
// ball, or of attempts over each other. Each function takes a state and returns the next one; none is changed in place.
// Pure: no wasm, no document, no clock.

/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("../pkg/pathlight.js").Author} Author */
/** @typedef {import("../pkg/pathlight.js").ListedAttempt} ListedAttempt */

/**
 * An attempt that is shown. `preview`: it is a proposal of the model's that is only looked at, and `tried` says whether
 * the model has tried it too; or, if `opened`, somebody's attempt from a file.
 * @typedef {ListedAttempt & { author: Author, preview?: boolean, tried?: boolean, opened?: boolean }}
 *   ShownAttempt
 */

/**
 * What stays in sight of a miss: its ball, and the path of the green object as in `ImaginedBall`.
 * @typedef {{ ball: Ball, object: Float32Array }} Ghost
 */

/** @typedef {"ball" | "line" | "bodies"} Tool what a pointer does in the scene: places the ball, draws a line, edits */

/**
 * What every state keeps. `edited`: the scene is being edited and differs from the puzzle, which cannot be run until
 * the edited scene has become the puzzle.
 * @typedef {{ tool: Tool, edited: boolean }} Editing
 */

/** @typedef {{ kind: "placing", refusal: string | null }} Placing `refusal`: why the last request was refused */

/**
 * `hidden`: whose new attempt plays for the first time, so that its result is not told before its end; null if none
 * does. `ghosts`: the misses before it, if it is a miss in the show of the model's turn. `approach`: when it came
 * nearest to the goal, once it has ended as a miss that never touched.
 * @typedef {object} AttemptRun
 * @property {"attempt"} kind
 * @property {ShownAttempt} attempt
 * @property {Author | null} hidden
 * @property {Ghost[] | null} ghosts
 * @property {import("../pkg/pathlight.js").ClosestApproach | null} approach
 */

/** @typedef {{ kind: "watch" }} Watch */
/**
 * One or two attempts, the player's first.
 * @typedef {{ kind: "compare", pair: ShownAttempt[], hidden: Author | null }} Comparison
 */
/** @typedef {Watch | AttemptRun | Comparison} Run */
/** @typedef {Readonly<Editing & (Placing | (Run & { ended: boolean }))>} Shown */

/** @type {Shown} */
export const START = Object.freeze({ kind: "placing", refusal: null, tool: "ball", edited: false });

/**
 * The ball is being placed; what was shown is left.
 * @param {Shown} shown
 * @returns {Shown}
 */
export function placing({ tool, edited }) {
  return { kind: "placing", refusal: null, tool, edited };
}

/**
 * A run begins.
 * @param {Shown} shown
 * @param {Run} run
 * @returns {Shown}
 */
export function running({ tool, edited }, run) {
  return { ...run, ended: false, tool, edited };
}

/**
 * An attempt as a run.
 * @param {ShownAttempt} attempt
 * @param {{ hidden?: Author | null, ghosts?: Ghost[] | null }} [how]
 * @returns {AttemptRun}
 */
export function attemptRun(attempt, { hidden = null, ghosts = null } = {}) {
  return { kind: "attempt", attempt, hidden, ghosts, approach: null };
}

/**
 * The run has played to its end. It may be played again from there; that changes nothing here.
 * @param {Shown} shown
 * @param {AttemptRun["approach"]} approach of an attempt
 * @returns {Shown}
 */
export function ended(shown, approach) {
  if (shown.kind === "placing") return shown;
  return shown.kind === "attempt" ? { ...shown, ended: true, approach } : { ...shown, ended: true };
}

/**
 * Is the run a miss that never touched its goal, of which the nearest moment is worth showing?
 * @param {Shown} shown
 */
export function neverTouched(shown) {
  if (shown.kind !== "attempt" || shown.ghosts) return false;
  const { solved, longest_touch } = shown.attempt.ending;
  return !solved && longest_touch === 0;
}

/**
 * Whose new attempt plays for the first time; null if none does.
 * @param {Shown} shown
 */
export function hiddenAuthor(shown) {
  return shown.kind === "attempt" || shown.kind === "compare" ? shown.hidden : null;
}

/**
 * The result of a new attempt may be told.
 * @param {Shown} shown
 * @returns {Shown}
 */
export function revealed(shown) {
  return hiddenAuthor(shown) === null ? shown : /** @type {Shown} */ ({ ...shown, hidden: null });
}

/**
 * What was asked for does not happen, and why; null takes that back. A run that is shown says nothing of it.
 * @param {Shown} shown
 * @param {string | null} refusal
 * @returns {Shown}
 */
export function refused(shown, refusal) {
  return shown.kind === "placing" ? { ...shown, refusal } : shown;
}

/**
 * The person takes up another tool, or the scene being edited departs from the puzzle or becomes it.
 * @param {Shown} shown
 * @param {Partial<Editing>} editing
 * @returns {Shown}
 */
export function editing(shown, editing) {
  return { ...shown, ...editing };
}

/**
 * The attempts of player and model that are shown; a preview is none.
 * @param {Shown} shown
 * @returns {ShownAttempt[]}
 */
export function visibleAttempts(shown) {
  if (shown.kind === "compare") return shown.pair;
  return shown.kind === "attempt" && !shown.attempt.preview ? [shown.attempt] : [];
}

/** @typedef {{ author: Author, number: number }} AttemptId */

/**
 * The attempts to show over each other if one is chosen, the player's first: it and the only one that is shown, else
 * the other author's last, else its neighbour. Only itself if there is no other.
 * @param {AttemptId} chosen
 * @param {Shown} shown
 * @param {Record<Author, number>} used how many attempts each author has made
 * @returns {AttemptId[]}
 */
export function overlaid(chosen, shown, used) {
  const { author, number } = chosen;
  const visible = visibleAttempts(shown);
  const opponent = author === "player" ? "model" : "player";
  const neighbour = number > 1 ? number - 1 : 2;
  /** @type {AttemptId | null} */
  let partner = null;
  if (visible.length === 1 && (visible[0].author !== author || visible[0].number !== number)) [partner] = visible;
  else if (used[opponent] > 0) partner = { author: opponent, number: used[opponent] };
  else if (neighbour <= used[author]) partner = { author, number: neighbour };
  if (!partner) return [chosen];
  return author === "model" && partner.author === "player" ? [partner, chosen] : [chosen, partner];
}
