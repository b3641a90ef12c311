// Clicks, keys and drags at random, from a seed: no error, nothing that contradicts itself, and a reload shows the
// same. PATHLIGHT_WALK_STEPS=2000 walks further, PATHLIGHT_WALK_SEED elsewhere.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { assertConsistent, assertSameAfterReload } from "./invariants.mjs";
import { openPuzzle } from "./page-actions.mjs";
import { RandomWalk } from "./random-walk.mjs";

const STEPS = Number(process.env.PATHLIGHT_WALK_STEPS ?? 150);
const SEED = Number(process.env.PATHLIGHT_WALK_SEED ?? 1);
/** Steps between two comparisons with a reloaded page. */
const RELOAD_EVERY = 25;
/** How many of the last steps a failure lists. */
const TOLD = 25;

let session;
before(async () => (session = await start()));
after(() => session.stop());

test(`${STEPS} steps from seed ${SEED}`, { timeout: 60_000 + STEPS * 3000 }, async () => {
  const page = await openPuzzle(session);
  const walk = new RandomWalk(page, SEED);
  for (let step = 1; step <= STEPS; step++) {
    try {
      await walk.step();
      await page.locator("main > #puzzle .puzzle #scene").waitFor({ state: "attached" });
      await assertConsistent(page);
      if (step % RELOAD_EVERY === 0) await assertSameAfterReload(page);
      assert.deepEqual(session.problems, []);
    } catch (error) {
      // The TAP reporter leaves out the cause.
      const why = /** @type {Error} */ (error).message;
      throw new Error(
        `After step ${step} from seed ${SEED}: ${why}\nThe last steps were\n${walk.log.slice(-TOLD).join("\n")}`,
        { cause: error },
      );
    }
  }
});
