// The German words for en/places.js.

/** @typedef {import("../en/places.js").Named} Named */

/** The article in the dative, and the noun. */
const KINDS = {
  ball: ["der", "Kugel"],
  bar: ["dem", "Balken"],
  upright: ["dem", "senkrechten Balken"],
  slope: ["der", "Schräge"],
  jar: ["dem", "Glas"],
  sticks: ["den", "Stäben"],
};
const COLOURS = { green: "grünen", blue: "blauen", purple: "violetten", gray: "grauen", black: "schwarzen" };
const SIDES = { on: "auf", above: "über", below: "unter", right: "rechts neben", left: "links neben" };
const ORDER = { x: ["linken", "mittleren", "rechten"], y: ["unteren", "mittleren", "oberen"] };

/** @type {typeof import("../en/places.js").places} */
export const places = {
  beside: (side, just, body) => `${just ? "knapp " : ""}${SIDES[side]} ${theBody(body)}`,
  part(across, up) {
    const [height, side] = [["unten", "auf halber Höhe", "oben"][up], ["links", "in der Mitte", "rechts"][across]];
    if (up !== 1) return `${height} ${side}`;
    return across === 1 ? side : `${side} ${height}`;
  },
  map: (first, second) => `vor allem ${first}${second === null ? "" : `, aber auch ${second}`}`,
};

/**
 * „der linken Schräge“, „dem 2. grauen Balken von unten“.
 * @param {Named} body
 */
function theBody({ kind, role, among }) {
  const [article, noun] = KINDS[kind];
  const words = (role ? `${COLOURS[role]} ` : "") + noun;
  if (!among) return `${article} ${words}`;
  const { axis, place, count } = among;
  const [first, middle, last] = ORDER[axis];
  if (count === 2) return `${article} ${place ? last : first} ${words}`;
  if (count === 3) return `${article} ${[first, middle, last][place]} ${words}`;
  return `${article} ${place + 1}. ${words} von ${axis === "x" ? "links" : "unten"}`;
}
