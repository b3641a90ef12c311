// What axe finds on a page. Knows nothing of what is on it.

import AxeBuilder from "@axe-core/playwright";
import assert from "node:assert/strict";

/**
 * Fails if axe finds something serious or critical, or with `all` anything.
 * @param {import('playwright-core').Page} page
 * @param {string} [view] what the page shows, for the message
 * @param {{ within?: string, all?: boolean }} [options] `within`: the selector of the part to look at
 */
export async function axeFindsNothing(page, view = "", { within, all = false } = {}) {
  const axe = new AxeBuilder({ page });
  const { violations } = await (within ? axe.include(within) : axe).analyze();
  const found = violations.filter(({ impact }) => all || impact === "serious" || impact === "critical");
  const told = found.map(({ id, help, nodes }) => `${id}: ${help}\n  ${nodes.map(({ html }) => html).join("\n  ")}`);
  assert.equal(found.length, 0, `${view}\n${told.join("\n")}`);
}
