// ESLint's rules for the page, its tests and the benches' pages: the recommended rules, and others that have found
// bugs. The file is next to the packages that it imports; `scripts/lint-js` passes it to ESLint.

import js from "@eslint/js";
import globals from "globals";

export default [
  { ignores: ["www/pkg/", "**/node_modules/", "target/", "dist/"] },
  js.configs.recommended,
  {
    rules: {
      eqeqeq: "error",
      "no-constructor-return": "error",
      "no-implicit-globals": "error",
      "no-self-compare": "error",
      "no-unmodified-loop-condition": "error",
      "no-unreachable-loop": "error",
      "no-use-before-define": ["error", { functions: false, classes: false, variables: false }],
      "no-var": "error",
      "object-shorthand": "error",
      "prefer-const": "error",
    },
  },
  { files: ["www/*.js"], languageOptions: { globals: globals.browser } },
  { files: ["**/*.mjs"], languageOptions: { globals: { ...globals.node, ...globals.browser } } },
];
