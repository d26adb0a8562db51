// Lints of the web page and of its tests; .ci/run starts them.

import js from "@eslint/js";
import globals from "globals";

export default [
  js.configs.recommended,
  {
    rules: {
      "array-callback-return": "error",
      "default-case-last": "error",
      eqeqeq: "error",
      "no-implicit-globals": "error",
      "no-self-compare": "error",
      "no-unmodified-loop-condition": "error",
      "no-unreachable-loop": "error",
      "no-use-before-define": ["error", { functions: false, variables: false }],
      "no-var": "error",
      "object-shorthand": "error",
      "prefer-const": "error",
      "require-atomic-updates": "error",
    },
  },
  { files: ["src/interfaces/web/page/*.js"], languageOptions: { globals: globals.browser } },
  { files: ["src/interfaces/web/page/worker.js"], languageOptions: { globals: globals.worker } },
  { files: ["src/interfaces/web/page/service.js"], languageOptions: { globals: globals.serviceworker } },
  { files: ["tests/web/*.mjs"], languageOptions: { globals: globals.node } },
];
