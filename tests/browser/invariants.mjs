// What holds on the page at every moment, whatever has been done to it, and what a reload shows again. Used by the
// random walk and by the tests of faults.

import assert from "node:assert/strict";

/** @typedef {import('playwright-core').Page} Page */

/** The address follows the state with this delay at most, ms. */
const URL_DELAY = 350;

/**
 * Returns the sentences about what on the page contradicts itself; none if all is well.
 * @param {Page} page
 * @returns {Promise<string[]>}
 */
export function contradictions(page) {
  return page.evaluate(contradictionsInPage);
}

/**
 * Fails if the page contradicts itself, once all its parts are there.
 * @param {Page} page
 */
export async function assertConsistent(page) {
  await page.locator("#puzzle [inert]").first().waitFor({ state: "detached" });
  assert.deepEqual(await contradictions(page), []);
}

/**
 * Reloads the page and fails if it shows another view, other attempts or another progress than before.
 * @param {Page} page
 */
export async function assertSameAfterReload(page) {
  const before = await settled(page);
  await page.reload();
  await page.waitForFunction(isLoaded, null, { timeout: 60_000 });
  // The model's attempts come back with the model.
  await page
    .waitForFunction(
      (count) =>
        /** @type {any} */ (document.getElementById("puzzle")).shadowRoot.querySelectorAll("#model-attempts li")
          .length >= count,
      before.attempts.model.length,
      { timeout: 60_000 },
    )
    .catch(() => {});
  const view = await page.evaluate(viewInPage);
  if (before.isRunning) {
    // The attempt counts when the page is left.
    assert.equal(view.attempts.player.length, before.attempts.player.length + 1);
    Object.assign(before, { attempts: view.attempts, progress: view.progress, isRunning: false });
  }
  assert.deepEqual(view, before);
}

/**
 * The view once the address has been written and no turn of the model's runs.
 * @param {Page} page
 */
async function settled(page) {
  await page.evaluate(() => {
    const { shadowRoot } = /** @type {any} */ (document.getElementById("puzzle"));
    const turn = /** @type {HTMLElement | null} */ (shadowRoot.getElementById("model-turn"));
    if (turn?.textContent.startsWith("Stop")) turn.click();
  });
  for (let view = await page.evaluate(viewInPage); ;) {
    await page.waitForTimeout(URL_DELAY);
    const later = await page.evaluate(viewInPage);
    if (JSON.stringify(later) === JSON.stringify(view)) return view;
    view = later;
  }
}

function isLoaded() {
  const puzzle = /** @type {any} */ (document.getElementById("puzzle"));
  const inside = puzzle.shadowRoot;
  return inside.getElementById("scene") !== null && inside.querySelector("[inert]") === null && puzzle.state !== null;
}

/** What a reload has to show again. */
function viewInPage() {
  const puzzle = /** @type {any} */ (document.getElementById("puzzle"));
  const inside = puzzle.shadowRoot;
  const rows = (list) =>
    [...inside.querySelectorAll(`#${list} li`)].map(
      (row) => row.querySelector("[data-act=replay]").getAttribute("title") + row.querySelector(".mark").textContent,
    );
  const attributes = Object.fromEntries(
    [...puzzle.attributes].filter(({ name }) => name !== "hidden").map(({ name, value }) => [name, value]),
  );
  const isSeen = (element) => element.checkVisibility();
  const picker = /** @type {HTMLSelectElement} */ (document.getElementById("task"));
  return {
    hash: location.hash.slice(1),
    title: document.title,
    attributes,
    seen: [
      document.getElementById("gallery"),
      document.getElementById("results"),
      document.getElementById("learns"),
      ...inside.querySelectorAll("[role=tabpanel], #presentation"),
    ]
      .filter(isSeen)
      .map(({ id }) => id),
    attempts: { player: rows("play-attempts"), model: rows("model-attempts") },
    isRunning:
      (puzzle.state.task ?? puzzle.state.scene) !== null &&
      inside.getElementById("race-player").textContent === "trying …",
    progress: isSeen(picker) ? picker.selectedOptions[0]?.textContent : null,
  };
}

function contradictionsInPage() {
  const puzzle = /** @type {any} */ (document.getElementById("puzzle"));
  const inside = puzzle.shadowRoot;
  const found = [];
  const check = (holds, sentence) => holds || found.push(sentence);
  const text = (id) => inside.getElementById(id).textContent;
  const notice = /** @type {HTMLElement} */ (document.getElementById("notice-text")).textContent;
  check(!/broke/.test(notice), `the page says that it broke: ${notice}`);
  const { state } = puzzle;
  if (!state || !inside.getElementById("scene")) return [...found, "there is no puzzle"];
  const shown = state.task !== null || state.scene !== null;
  check(
    [...document.querySelectorAll("#gallery:not([hidden]), #results:not([hidden])")].length ===
      (shown || state.hide.includes("puzzles") ? 0 : 1),
    "the grid, the results and the puzzle are not one at a time",
  );
  const isUnread = inside.querySelector(".puzzle").hidden;
  check(!shown || !isUnread || text("problem") !== "", "there is no puzzle, and no sentence why");
  if (!shown || isUnread) return found;

  // Tabs, panels and the presentation.
  const panels = [...inside.querySelectorAll("[role=tabpanel]")]
    .filter((one) => !one.hidden)
    .map(({ id }) => id.slice("tabpanel-".length));
  const selected = [...inside.querySelectorAll("[role=tab][aria-selected=true]")].map(({ id }) =>
    id.slice("tab-".length),
  );
  check(
    panels.length === 1 && String(panels) === String(selected),
    `panels ${panels} are shown and tabs ${selected} are selected`,
  );
  check(
    state.view === "presentation" ||
      state.hide.includes(state.panel) ||
      (!inside.getElementById(state.panel).hidden &&
        inside.getElementById(`tabpanel-${panels[0]}`).contains(inside.getElementById(state.panel))),
    `tab ${panels} is shown, the state says ${state.panel}`,
  );
  check(
    inside.getElementById("presentation").hidden === (state.view !== "presentation"),
    "the presentation is not as the state says",
  );
  const dialogs = [...inside.querySelectorAll("dialog[open]"), ...document.querySelectorAll("dialog[open]")];
  check(dialogs.length <= 1, `dialogs ${dialogs.map(({ id }) => id)} are open together`);

  // The ball: state, attributes and fields.
  const fields = ["x", "y", "r"].map((name) => /** @type {HTMLInputElement} */ (inside.getElementById(`ball-${name}`)));
  // Numbers that are being typed are not the ball yet.
  const isTyped =
    fields.some((field) => inside.activeElement === field) || (!state.ball && fields.some(({ value }) => value === ""));
  check(
    isTyped || String(fields.map(({ value }) => value)) === String(state.ball ?? ["", "", ""]),
    `the fields hold ${fields.map(({ value }) => value)}, the state ${state.ball}`,
  );
  check(
    (puzzle.getAttribute("ball") ?? "") === String(state.ball ?? ""),
    `the attribute of the ball is ${puzzle.getAttribute("ball")}, the state's ${state.ball}`,
  );

  // The lists of attempts, their counts and marks.
  const lists = Object.fromEntries(
    ["play", "model"].map((name) => [
      name,
      [...inside.querySelectorAll(`#${name}-attempts li`)].map((row) => ({
        number: Number(row.querySelector("b").textContent),
        ball: (
          row
            .querySelector("[data-act=replay]")
            .getAttribute("title")
            .match(/[\d.]+/g) ?? []
        ).map(Number),
        solved: row.querySelector(".mark").textContent === "✓",
        current: row.querySelector("[aria-current=true]") !== null,
      })),
    ]),
  );
  for (const [name, rows] of Object.entries(lists)) {
    check(
      rows.every(({ number }, index) => number === index + 1) && rows.length <= 100,
      `the attempts of ${name} are numbered ${rows.map(({ number }) => number)}`,
    );
    const first = rows.find(({ solved }) => solved)?.number;
    const words = rows.length === 0 ? "" : first ? `solved on attempt ${first}` : `${rows.length} of 100, not solved`;
    check(text(`${name}-count`) === words, `the list of ${name} says “${text(`${name}-count`)}”, its rows “${words}”`);
  }
  check(
    lists.model.slice(0, -1).every(({ solved }) => !solved),
    "the model has gone on after it had solved",
  );

  // The verdict.
  const [you, it] = [lists.play, lists.model].map((rows) => rows.find(({ solved }) => solved)?.number);
  const verdict = text("race-verdict");
  const said = (pattern) => Number(verdict.match(pattern)?.[1] ?? Number.NaN);
  // Nothing is told before the model has played.
  if (lists.model.length > 0 && verdict !== "") {
    if (you && it && you < it) check(verdict.includes("You were quicker"), `${you} against ${it}: ${verdict}`);
    if (you && it && you > it) check(verdict.includes("The model was quicker"), `${you} against ${it}: ${verdict}`);
    if (you && it && you === it) check(verdict.includes("A draw"), `${you} against ${it}: ${verdict}`);
    if (you && !it) check(said(/^You solved it on attempt (\d+)/) === you, `you ${you}: ${verdict}`);
    if (!you && it) check(said(/^The model solved it on attempt (\d+)/) === it, `the model ${it}: ${verdict}`);
    if (!you && !it)
      check(
        verdict.includes(String(lists.play.length || "0")) || verdict.includes("no attempt"),
        `${lists.play.length} and ${lists.model.length}: ${verdict}`,
      );
  } else if (lists.model.length === 0 && lists.play.length === 0) {
    check(["", "You first: drop a ball."].includes(verdict), verdict);
  }

  // The status line, and the attempt that it speaks of.
  const [, outcome, whose, which] =
    text("status").match(/^(Solved!|Not solved\.) (Your|The model’s) attempt (\d+)/) ?? [];
  // Of two over each other it names the outcome of both.
  if (outcome && !text("status").includes("(dashed)")) {
    const row = lists[whose === "Your" ? "play" : "model"][Number(which) - 1];
    check(
      row?.solved === (outcome === "Solved!") && row?.current,
      `the status says “${text("status")}”, the row ${JSON.stringify(row)}`,
    );
  }

  // What is kept.
  if (state.task !== null) {
    const kept = (localStorage.getItem(`pathlight.attempts.${state.task}`) ?? "")
      .split("\n")
      .filter(Boolean)
      .map((line) => JSON.parse(line))
      .filter(({ by }) => by === "player")
      .sort((one, other) => one.number - other.number);
    const balls = (rows) => JSON.stringify(rows.map(({ ball }) => ball));
    check(balls(kept) === balls(lists.play), `kept are the player's balls ${balls(kept)}, listed ${balls(lists.play)}`);
    const picker = /** @type {HTMLSelectElement} */ (document.getElementById("task"));
    const progress = picker.selectedOptions[0]?.textContent ?? "";
    const tried = Number(progress.match(/missed, (\d+) tr/)?.[1] ?? 0);
    check(
      /solved at try \d/.test(progress) || (!you && tried >= lists.play.length),
      `the picker says “${progress}”, of ${lists.play.length} attempts the first to solve is ${you}`,
    );
  }
  return found;
}
