// Prettier's options for the JavaScript of the page, its tests, the benches and these scripts. `scripts/lint-js` passes
// the file to Prettier.

export default { printWidth: 120, objectWrap: "collapse" };
