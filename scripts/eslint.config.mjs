// What ESLint holds the page, its tests and the benches' pages to: its recommended rules, and what else has found
// defects. It stands beside the packages that it imports; `scripts/lint-js` names it.

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
