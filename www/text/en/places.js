// Places in a scene, in words of the scene: "just above the left slope".

/** @typedef {import("../../pkg/pathlight.js").Role} Role */
/** @typedef {keyof typeof KINDS} Kind */
/** @typedef {keyof typeof SIDES} Side */
/**
 * What tells a body from the others of its scene: its kind, its colour where that counts, and which of those alike it
 * is, from 0, by x from the left or by y from below.
 * @typedef {{ kind: Kind, role: Role | null, among: { axis: "x" | "y", place: number, count: number } | null }} Named
 */

const KINDS = { ball: "ball", bar: "bar", upright: "upright bar", slope: "slope", jar: "jar", sticks: "sticks" };
const SIDES = { on: "on", above: "above", below: "below", right: "right of", left: "left of" };
const ORDER = { x: ["left", "middle", "right"], y: ["lower", "middle", "upper"] };

export const places = {
  /** @type {(side: Side, just: boolean, body: Named) => string} */
  beside: (side, just, body) => `${just ? "just " : ""}${SIDES[side]} the ${name(body)}`,
  /** @type {(across: 0 | 1 | 2, up: 0 | 1 | 2) => string} the third of the scene, from the left and from below */
  part(across, up) {
    if (across === 1 && up === 1) return "in the middle";
    return `${["low", "half way up", "high up"][up]} ${["on the left", "in the middle", "on the right"][across]}`;
  },
  /** @type {(first: string, second: string | null) => string} where a map is strongest, and where it is strong too */
  map: (first, second) => `most sure ${first}${second === null ? "" : `, also sure ${second}`}`,
};

/** @param {Named} body */
function name({ kind, role, among }) {
  const words = (role ? `${role} ` : "") + KINDS[kind];
  if (!among) return words;
  const { axis, place, count } = among;
  const [first, middle, last] = ORDER[axis];
  if (count === 2) return `${place ? last : first} ${words}`;
  if (count === 3) return `${[first, middle, last][place]} ${words}`;
  return `${ordinal(place + 1)} ${words} from ${axis === "x" ? "the left" : "below"}`;
}

/** @param {number} number from 1 */
function ordinal(number) {
  const suffix = number % 100 > 10 && number % 100 < 14 ? "th" : (["th", "st", "nd", "rd"][number % 10] ?? "th");
  return `${number}${suffix}`;
}
