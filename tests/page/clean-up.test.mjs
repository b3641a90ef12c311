// After a panic the wasm frees nothing, and refuses that with errors of its own: the panic's has to come through.

import assert from "node:assert/strict";
import { test } from "node:test";
import { cleanUp } from "../../www/api/clean-up.js";

test("an error of cleaning up does not hide the error before it", () => {
  const panic = Object.assign(new Error("Pathlight has a defect"), { code: "panic" });
  const used = () => {
    try {
      throw panic;
    } finally {
      cleanUp(() => {
        throw new Error("attempted to take ownership of Rust value while it was borrowed");
      });
    }
  };
  assert.throws(used, panic);
});
