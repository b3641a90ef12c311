// The page in Firefox: open, place, solve, imagine, let the model play, without a word in the console.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { startFirefox } from './firefox.mjs';
import { start } from './harness.mjs';
import { EASY, known } from './page-actions.mjs';

/** For what takes longer than a moment, ms. */
const TIMEOUT = 120_000;

let session, firefox;
before(async () => {
  session = await start();
  firefox = await startFirefox();
});
after(async () => {
  await firefox.close();
  await session.stop();
});

test('a puzzle is solved, imagined, and played by the model', { timeout: 3 * TIMEOUT }, async () => {
  const page = await firefox.newPage();
  const problems = [];
  page.on('console', (message) => ['error', 'warn'].includes(message.type()) && problems.push(message.text()));
  page.on('pageerror', (error) => problems.push(error.message));
  await page.goto(`${session.origin}/#task=${EASY}`);
  /** Waits for an element whose text passes. */
  const says = (id, pattern) => page.waitForFunction((id, source) => {
    const element = /** @type {any} */ (document.getElementById('puzzle')).shadowRoot.getElementById(id);
    return element?.checkVisibility() && new RegExp(source).test(element.textContent);
  }, { timeout: TIMEOUT }, id, pattern.source);
  const press = async (id) => (await page.waitForSelector(`#puzzle >>> #${id}:enabled`, { visible: true, timeout: TIMEOUT })).click();

  await says('status', /place the red ball/);
  const { solving: [x, y, r] } = await known();
  const box = await (await page.waitForSelector('#puzzle >>> #scene')).boundingBox();
  await page.mouse.click(box.x + (x / 256) * box.width, box.y + box.height - (y / 256) * box.height);
  const field = await page.waitForSelector('#puzzle >>> #ball-r');
  await field.evaluate((input) => (input.focus(), input.select()));
  await page.keyboard.type(String(r));
  await page.keyboard.press('Tab');
  const ball = await page.evaluate(() => document.getElementById('puzzle')?.getAttribute('ball'));
  assert.match(ball ?? '', new RegExp(`^\\d+,\\d+,${r}$`));
  await page.evaluate((ball) => document.getElementById('puzzle')?.setAttribute('ball', ball), `${x},${y},${r}`);
  await press('run');
  await says('status', /^Solved!/);
  await press('tab-imagine');
  await says('imagined-in', /Imagined in \d+ ms/);
  await press('tab-compare');
  await press('model-turn');
  await says('model-turn', /The model has played/);
  await says('verdict', /solved it on attempt/);
  await page.reload();
  await says('verdict', /solved it on attempt/);
  assert.deepEqual(problems, []);
});
