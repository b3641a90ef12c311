// An attempt at a puzzle, as it is kept and saved: JSON lines, an attempt a line. Two lists of attempts are merged
// without losing any.
//
// {"task":"00007:008","by":"player","number":2,"ball":[128,200,12],"status":"solved","steps":312,"longest_touch":180,
//  "final_touch":180,"simulator":3}
// A custom scene has its digest as "scene" instead of the "task"; in files it may be the scene itself. "by" is "player"
// or the name of a model; then "agents" is the version of the agents, and "weights" are the first digits of the SHA-256
// of its weights, if that is known. "number" counts the attempts of that author at that puzzle from 1; lengths are in
// px, times in steps; "simulator" is the version of the simulator.

/** @typedef {import("../pkg/pathlight.js").Attempt} Attempt */

/**
 * What an attempt depends on; a person's has neither agents nor weights.
 * @typedef {{ simulator: number, agents?: number, weights?: string }} Versions
 */

/**
 * An attempt at a puzzle: the id of a task, or the digest of a custom scene.
 * @typedef {Attempt & Versions & { puzzle: string, by: string, number: number }} KeptAttempt
 */

export const PLAYER = "player";
export const TASK = /^\d{5}:\d{3}$/;
/** The name of a model, or "player". */
export const NAME = /^[\w.-]+$/;
const DIGEST = /^[0-9a-f]{64}$/;
const WEIGHTS = /^[0-9a-f]{8}$/;
/** The attempts that each author has on a puzzle. */
export const ATTEMPT_LIMIT = 100;
/** More attempts than a person can make: a number above it is damage. */
export const MAX_NUMBER = 1e6;
/** More steps than this are damage. */
const MAX_STEPS = 1e5;
/** A longer line is no attempt, characters. */
const MAX_LINE = 65_536;

/**
 * The author at the puzzle. The turns of a model by other versions are turns of their own.
 * @param {KeptAttempt} attempt
 */
export function turnOf({ puzzle, by, simulator, agents, weights }) {
  return by === PLAYER ? `${puzzle} ${by}` : `${puzzle} ${by} ${simulator} ${agents} ${weights}`;
}

/** @param {KeptAttempt} attempt */
export function identityOf(attempt) {
  return `${turnOf(attempt)} ${attempt.ball}`;
}

/** @type {(attempt: KeptAttempt, puzzle: string, by: string) => boolean} */
export const isOf = (attempt, puzzle, by) => attempt.puzzle === puzzle && attempt.by === by;

/** @type {(a: Versions, b: Versions) => boolean} */
export const sameVersions = (a, b) => a.simulator === b.simulator && a.agents === b.agents && a.weights === b.weights;

/** @type {(a: Versions, b: Versions) => number} */
export const compareVersions = (a, b) => a.simulator - b.simulator || (a.agents ?? 0) - (b.agents ?? 0);

/**
 * Attempts by what they have in common.
 * @param {KeptAttempt[]} attempts
 * @param {(attempt: KeptAttempt) => string} keyOf
 */
export function grouped(attempts, keyOf) {
  /** @type {Map<string, KeptAttempt[]>} */
  const groups = new Map();
  for (const attempt of attempts) {
    const group = groups.get(keyOf(attempt));
    if (group) group.push(attempt);
    else groups.set(keyOf(attempt), [attempt]);
  }
  return groups;
}

/**
 * The order in which the attempts at a puzzle are listed. It does not depend on which were merged into which.
 * @param {KeptAttempt} a
 * @param {KeptAttempt} b
 */
export function compareAttempts(a, b) {
  return (
    a.number - b.number ||
    Number(b.ending.solved) - Number(a.ending.solved) ||
    compareTexts(identityOf(a), identityOf(b))
  );
}

/** @type {(a: string, b: string) => number} */
export const compareTexts = (a, b) => Number(a > b) - Number(a < b);

/**
 * Of two records of the same ball the one that tells more, with the earlier number.
 * @param {KeptAttempt} a
 * @param {KeptAttempt} b
 */
function unite(a, b) {
  const order =
    Number(b.ending.solved) - Number(a.ending.solved) ||
    b.simulator - a.simulator ||
    compareTexts(JSON.stringify(lineOf({ ...a, number: 1 })), JSON.stringify(lineOf({ ...b, number: 1 })));
  return { ...(order > 0 ? b : a), number: Math.min(a.number, b.number) };
}

/**
 * Merges attempts into those that are here, which all stay. Returns these, those that are new, and those that are left
 * out because there is no room.
 * @param {KeptAttempt[]} here
 * @param {KeptAttempt[]} added
 * @param {number} [room] for how many there is room
 */
export function mergeAttempts(here, added, room = Infinity) {
  const known = new Map(here.map((attempt) => [identityOf(attempt), attempt]));
  const counts = new Map([...grouped(here, turnOf)].map(([turn, { length }]) => [turn, length]));
  /** @type {typeof known} */
  const fresh = new Map();
  /** @type {KeptAttempt[]} */
  const left = [];
  for (const attempt of added) {
    const identity = identityOf(attempt);
    const group = known.has(identity) ? known : fresh;
    const before = group.get(identity);
    const count = counts.get(turnOf(attempt)) ?? 0;
    if (before) group.set(identity, unite(before, attempt));
    else if (fresh.size >= room || count >= ATTEMPT_LIMIT) left.push(attempt);
    else {
      fresh.set(identity, attempt);
      counts.set(turnOf(attempt), count + 1);
    }
  }
  return { here: [...known.values()], fresh: [...fresh.values()], left };
}

/**
 * Attempts as JSON lines.
 * @param {KeptAttempt[]} attempts
 */
export function formatAttempts(attempts) {
  return attempts.map((attempt) => `${JSON.stringify(lineOf(attempt))}\n`).join("");
}

/** @param {KeptAttempt} attempt */
export function lineOf({ puzzle, by, number, ball, ending: { solved, ...times }, simulator, agents, weights }) {
  return {
    ...(TASK.test(puzzle) ? { task: puzzle } : { scene: puzzle }),
    by,
    number,
    ball,
    status: solved ? "solved" : "not_solved",
    ...times,
    simulator,
    agents,
    weights,
  };
}

/** Collects attempts from lines, and counts the lines that are none. */
export class AttemptReader {
  /** @type {KeptAttempt[]} */
  attempts = [];
  unread = 0;
  #digestOf;
  #solvedAt;
  /** @type {Map<string, { count: number, number: number, isSolved: boolean }>} */
  #turns = new Map();

  /**
   * @param {(by: string, task: string) => number | null} [solvedAt] the number of the first attempt that solved it, as
   *   older versions counted, whose lines have no numbers
   * @param {(scene: any) => string} [digestOf] throws if it is no scene
   */
  constructor(solvedAt = () => null, digestOf = () => "") {
    this.#solvedAt = solvedAt;
    this.#digestOf = digestOf;
  }

  /** @param {string} line */
  addLine(line) {
    try {
      this.add(line.length > MAX_LINE ? null : JSON.parse(line));
    } catch {
      this.unread += 1;
    }
  }

  /** @param {any} parsed may hold more than is read */
  add(parsed) {
    const attempt = attemptOf(parsed, this.#digestOf);
    const turn = attempt && this.#turnOf(attempt);
    if (!attempt || !turn || turn.count >= ATTEMPT_LIMIT) {
      this.unread += 1;
      return;
    }
    turn.count += 1;
    const { puzzle, by, ending } = attempt;
    if (attempt.number === 0) {
      // The attempts before it may have been deleted.
      const counted = ending.solved && !turn.isSolved ? (this.#solvedAt(by, puzzle) ?? 0) : 0;
      attempt.number = Math.max(turn.number + 1, counted);
    }
    turn.number = Math.max(turn.number, attempt.number);
    turn.isSolved ||= ending.solved;
    this.attempts.push(attempt);
  }

  /** @param {KeptAttempt} attempt */
  #turnOf(attempt) {
    const name = turnOf(attempt);
    const turn = this.#turns.get(name) ?? { count: 0, number: 0, isSolved: false };
    this.#turns.set(name, turn);
    return turn;
  }
}

/**
 * @param {any} parsed
 * @param {(scene: any) => string} digestOf
 * @returns {KeptAttempt | null} with the number 0 if it has none
 */
function attemptOf(parsed, digestOf) {
  // A line with a digest names who made it: it may be the model's.
  const {
    task,
    scene,
    digest,
    by = digest === undefined ? PLAYER : null,
    number = 0,
    ball,
    status,
    steps,
    longest_touch = 0,
    final_touch = 0,
    simulator = 0,
    agents,
    weights,
  } = parsed ?? {};
  const isBall = Array.isArray(ball) && ball.length === 3 && ball.every((value) => Number.isFinite(value));
  // A person's ball has whole numbers, also in the links that replay it.
  const isPlaced = by !== PLAYER || (isBall && ball.every(Number.isInteger));
  const isNamed = typeof by === "string" && NAME.test(by) && isCount(number, MAX_NUMBER);
  const times = [steps, longest_touch, final_touch, simulator, agents ?? 0];
  if (!isBall || !isPlaced || !isNamed || !["solved", "not_solved"].includes(status)) return null;
  if (!times.every((value) => isCount(value, MAX_STEPS))) return null;
  if (weights !== undefined && !WEIGHTS.test(weights)) return null;
  const puzzle = scene === undefined ? taskOf(task) : digestOfScene(scene, digestOf);
  if (puzzle === null) return null;
  return {
    puzzle,
    by,
    number,
    ball: /** @type {import("../pkg/pathlight.js").Ball} */ (ball),
    ending: { solved: status === "solved", steps, longest_touch, final_touch },
    simulator,
    agents,
    weights,
  };
}

/** @type {(value: unknown, most: number) => boolean} */
const isCount = (value, most) => Number.isSafeInteger(value) && Number(value) >= 0 && Number(value) <= most;

/** @param {unknown} task */
function taskOf(task) {
  return typeof task === "string" && TASK.test(task) ? task : null;
}

/**
 * The digest of a custom scene, which is there itself or by its digest; null if it is neither.
 * @param {any} scene
 * @param {(scene: any) => string} digestOf
 */
function digestOfScene(scene, digestOf) {
  try {
    const digest = typeof scene === "string" ? scene : digestOf(scene);
    return DIGEST.test(digest) ? digest : null;
  } catch {
    return null;
  }
}
