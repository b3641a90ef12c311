// How Prettier formats the JavaScript of the page, its tests, the benches and these scripts; `scripts/lint-js` names
// it.

export default { printWidth: 120, objectWrap: "collapse" };
