// Two models side by side on one puzzle: what each has seen, imagines and tries, and which needs fewer attempts.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { axeFindsNothing } from './axe.mjs';
import { start } from './harness.mjs';
import { openPuzzle, says } from './page-actions.mjs';

let session;
before(async () => (session = await start()));
after(() => session.stop());

/** A puzzle of the second model's test tasks, and when that solves it. */
async function measured() {
  const { agents } = JSON.parse(await readFile(new URL('../../results/shipped/cross-0.json', import.meta.url), 'utf8'));
  return agents.find(({ agent }) => agent === 'online').first_solved.find(([, first]) => first > 1 && first < 20);
}

const column = (page, index) => page.locator('#pair-columns > div').nth(index);

async function sideBySide(options) {
  const [task, first] = await measured();
  const page = await openPuzzle(session, { task, fragment: '&panel=compare', ...options });
  await page.locator('#model-pair:visible').waitFor();
  await page.locator('#pair-run').press('Enter');
  await column(page, 1).waitFor();
  return { page, task, first };
}

test('each is named with what it has seen, its map, its balls and when it solves, as it was measured', async () => {
  const { page, first } = await sideBySide();
  assert.equal(await page.locator('#pair-columns h3').allTextContents().then(String), 'within-0,cross-0');
  assert.equal(await column(page, 1).locator('.model-badge').innerText(), 'never seen');
  assert.equal(await column(page, 1).locator('.outcome-strip span').count(), first);
  assert.match(await column(page, 1).locator('.pair-outcome').textContent(), new RegExp(`^Solved on attempt ${first}\\. Its own guess of its first ball: .+ \\(.+ %\\)\\.$`));
  await page.locator('#pair-words').filter({ hasText: /^((within|cross)-0 needs fewer attempts: \d+ instead of \d+|Only (within|cross)-0 solves this puzzle|Both solve it on attempt \d+)\.$/ }).waitFor();
  const place = await column(page, 0).locator('.pair-place').textContent();
  assert.match(place, /^Most sure .+\.$/);
  await page.locator('#pair-stage').selectOption('action');
  assert.match(await column(page, 0).locator('canvas[role=img]').getAttribute('aria-label'), /^Action path: /);

  await column(page, 1).locator('button').click();
  await says(page, new RegExp(`The model’s ball ${first} is running`));
  assert.equal(await page.locator('#model-attempts li').count(), 0, 'looking is no attempt');
  await page.locator('#next').click();
  assert.equal(await page.locator('#pair-columns > div').count(), 0, 'they are not told of the next puzzle');
});

test('another model in the place of the first clears them', async () => {
  const { page } = await sideBySide();
  await page.locator('#tab-imagine').click();
  await page.locator('#model-select').selectOption('cross-0');
  await page.locator('#tab-compare').click();
  assert.equal(await page.locator('#pair-columns > div').count(), 0);
  await page.locator('#pair-model option', { hasText: 'within-0' }).waitFor({ state: 'attached' });
});

test('a second model that cannot be loaded is a sentence', async () => {
  const [task] = await measured();
  const page = await openPuzzle(session, { task, fragment: '&panel=compare' });
  await page.context().route('**/cross-0.safetensors', (route) => route.fulfill({ status: 404 }));
  await page.locator('#pair-run').click();
  await page.locator('#pair-words').filter({ hasText: 'weights are missing here' }).waitFor();
  session.takeProblems();
});

for (const [screen, options] of Object.entries({ 'a desktop, dark': { viewport: { width: 1280, height: 800 }, colorScheme: 'dark' }, 'a phone': { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } })) {
  test(`axe finds nothing on ${screen}`, async () => {
    const { page } = await sideBySide(options);
    await axeFindsNothing(page);
  });
}
