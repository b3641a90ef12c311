// What axe finds on a page. Knows nothing of what is on it.

import AxeBuilder from "@axe-core/playwright";
import assert from "node:assert/strict";
import { painted } from "./harness.mjs";

/**
 * Fails if axe finds something serious or critical, or with `all` anything.
 * @param {import('playwright-core').Page} page
 * @param {string} [view] what the page shows, for the message
 * @param {{ within?: string, all?: boolean, rules?: string[] }} [options] `within`: the selector of the part to look
 *   at; `rules`: the only rules to check
 */
export async function axeFindsNothing(page, view = "", { within, all = false, rules } = {}) {
  // The legacy mode asks the page itself, which is several times as fast; only frames of another origin need more.
  const axe = new AxeBuilder({ page }).setLegacyMode(true).options({ resultTypes: ["violations"] });
  if (rules) axe.withRules(rules);
  const { violations } = await (within ? axe.include(within) : axe).analyze();
  const found = violations.filter(({ impact }) => all || impact === "serious" || impact === "critical");
  const told = found.map(({ id, help, nodes }) => `${id}: ${help}\n  ${nodes.map(({ html }) => html).join("\n  ")}`);
  assert.equal(found.length, 0, `${view}\n${told.join("\n")}`);
}

/** Looks at a page in light colours, and again at the contrasts in dark ones. */
export async function axeFindsNothingInLightAndDark(page, view = "") {
  await axeFindsNothing(page, view);
  await page.emulateMedia({ colorScheme: "dark" });
  // The page sets its own colours when it hears of the change, before the next frame.
  await painted(page);
  await axeFindsNothing(page, `${view}, dark`, { rules: ["color-contrast"] });
  await page.emulateMedia({ colorScheme: "light" });
}
