// What tests do on the page as a person would: open a puzzle, point at px of the scene, read the status line.
// It also finds a solving ball by simulation, through the page's own wasm, so that no solution is written down.

import assert from 'node:assert/strict';

/** A puzzle that many balls solve. */
export const EASY = '00000:000';

/** Opens a puzzle by its link. `still` asks for reduced motion: a run then shows its end at once. */
export async function openPuzzle(session, { task = EASY, more = '', still = false, ...options } = {}) {
  const page = await session.open(`/#task=${task}${more}`, { reducedMotion: still ? 'reduce' : 'no-preference', ...options });
  await page.locator('#scene').waitFor();
  return page;
}

/** The place on the screen of a point of the scene, px. */
export async function spot(page, x, y) {
  const box = await page.locator('#scene').boundingBox();
  return [box.x + (x / 256) * box.width, box.y + box.height - (y / 256) * box.height];
}

export async function click(page, x, y) {
  await page.mouse.click(...(await spot(page, x, y)));
}

/** Waits until the status line says so, and returns it. */
export async function says(page, pattern, timeout = 30_000) {
  const status = page.locator('#status');
  await status.filter({ hasText: pattern }).waitFor({ timeout }).catch(async () => {
    assert.match(await status.textContent(), pattern);
  });
  return status.textContent();
}

/** The ball in the fields: [x, y, r]. */
export async function ball(page) {
  return Promise.all(['x', 'y', 'r'].map(async (name) => Number(await page.locator(`#ball-${name}`).inputValue())));
}

/** How many attempts the player has made. */
export function attempts(page) {
  return page.locator('#play-attempts li').count();
}

/** Balls of a puzzle, found by simulation: one that solves it, one that does not, one that may not be placed. */
export async function known(page, task = EASY) {
  return page.evaluate(async (task) => {
    const { Puzzle } = await import('/pkg/pathlight.js');
    const puzzle = new Puzzle(task);
    const found = { solving: null, missing: null, invalid: null };
    for (let r = 8; r <= 24; r += 8) {
      for (let y = 250; y > 0; y -= 12) {
        for (let x = 4; x < 256; x += 8) {
          if (puzzle.whyInvalid(x, y, r)) {
            found.invalid ??= [x, y, r];
            continue;
          }
          const { number, ending } = puzzle.attempt(x, y, r);
          found[ending.solved ? 'solving' : 'missing'] ??= [x, y, r];
          if (number === 100) puzzle.clear('player');
          if (found.solving && found.missing && found.invalid) return found;
        }
      }
    }
    throw new Error(`no ball of the grid solves ${task}`);
  }, task);
}

/** Places a ball of any radius by the fields, as it lies. */
export async function type(page, [x, y, r]) {
  for (const [name, value] of Object.entries({ x, y, r })) {
    await page.locator(`#ball-${name}`).fill(String(value));
    await page.locator(`#ball-${name}`).press('Tab');
  }
  // The first number alone makes no ball: all three have to be there.
  assert.deepEqual(await ball(page), [x, y, r]);
}

/** How many pixels of the scene are nearly of this colour, "#rrggbb". */
export async function pixels(page, colour, selector = '#scene') {
  return page.locator(selector).evaluate((canvas, colour) => {
    const wanted = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let at = 0; at < data.length; at += 4) {
      if (data[at + 3] > 200 && wanted.every((value, channel) => Math.abs(data[at + channel] - value) < 12)) count += 1;
    }
    return count;
  }, colour);
}

/** The colours of the roles, as the wasm draws them on light paper. */
export async function palette(page) {
  return page.evaluate(async () => (await import('/pkg/pathlight.js')).palette(false));
}

/** A picture of the scene, to see whether it has changed. */
export async function picture(page, selector = '#scene') {
  return page.locator(selector).evaluate((canvas) => canvas.toDataURL());
}
