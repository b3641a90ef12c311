// Puzzles that ask for the same model share its worker, and each sees a model that it takes as loading first.

import assert from "node:assert/strict";
import { test } from "node:test";
import { LOADED, MODULE, settled, workers } from "./fake-worker.mjs";
import { SharedClient } from "../../www/model/shared-client.js";

/** A client of a puzzle, and what it says at each change. */
function client() {
  const shared = new SharedClient(MODULE);
  const seen = [];
  shared.addEventListener("change", () => seen.push(`${shared.status} ${shared.loaded?.name ?? "-"}`));
  return { shared, seen };
}

test("a model that another puzzle has loaded is loading for a moment, then ready, in the same worker", async () => {
  const [first, second] = [client(), client()];
  first.shared.start(null);
  workers[0].answer("load", { value: LOADED });
  await settled();
  second.shared.start("within-0");
  assert.deepEqual([second.shared.status, second.shared.loaded], ["loading", null]);
  await settled();
  for (const { seen } of [first, second]) assert.deepEqual(seen, ["loading -", "ready within-0"]);
  assert.equal(workers.length, 1);

  first.shared.stop();
  assert.equal(workers[0].terminated, false, "the second puzzle uses it");
  second.shared.start("cross-0");
  assert.ok(workers[0].terminated);
  workers[1].answer("load", { value: { ...LOADED, name: "cross-0" } });
  await settled();
  assert.deepEqual(second.seen.slice(2), ["loading -", "ready cross-0"]);

  second.shared.start("cross-0");
  second.shared.stop();
  assert.equal(second.shared.status, "off", "it may be left in that moment");
  await settled();
  assert.equal(second.shared.status, "off");
});
