// How the player is doing: attempts that were deleted still count.

import assert from "node:assert/strict";
import { test } from "node:test";
import { Attempts } from "../../www/play/attempts.js";

/** Attempts of which these are here, and these counted. */
function attempts(standing, counted) {
  const made = new Attempts(/** @type {any} */ ({ standing: () => standing }));
  made.counted = () => counted;
  return made;
}

for (const [what, standing, counted, total] of /** @type {const} */ ([
  ["nothing is known beside them", [2, 2], null, [2, 2]],
  ["misses were deleted", [1, 1], [10, 10], [10, 10]],
  ["an earlier solution was deleted", [1, 1], [10, 9], [10, 9]],
  ["a solution was deleted", [1, null], [10, 9], [1, null]],
  ["all were deleted", [0, null], [9, 9], [0, null]],
  ["another tab has forgotten them", [2, 2], [0, null], [2, 2]],
])) {
  test(`the player's attempts when ${what}`, () => {
    const [used, solved_at] = total;
    const made = attempts(
      { used: standing[0], solved_at: standing[1] },
      counted && { attempts: counted[0], solved: counted[1] },
    );
    assert.deepEqual(made.playerTotal, { used, solved_at });
  });
}
