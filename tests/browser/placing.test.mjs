// Placing the ball with the mouse, the wheel, the knob and the fields; where it may not be, the page says why.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { start } from './harness.mjs';
import { attempts, ball, click, known, openPuzzle, palette, pixels, says, spot, type } from './playing.mjs';

let session;
before(async () => (session = await start()));
after(() => session.stop());

test('a click places the ball there, in whole px', async () => {
  const page = await openPuzzle(session);
  await says(page, /place the red ball/);
  const { missing: [x, y] } = await known(page);
  await click(page, x, y);
  const [atX, atY, r] = await ball(page);
  assert.ok(Math.abs(atX - x) <= 1 && Math.abs(atY - y) <= 1, `${atX}, ${atY}`);
  assert.ok(Number.isInteger(atX) && Number.isInteger(atY) && r >= 2);
  await page.waitForTimeout(100);
  assert.ok((await pixels(page, (await palette(page)).red)) > 50);
});

test('a drag moves the ball, the knob and the wheel change its radius', async () => {
  const page = await openPuzzle(session);
  await type(page, [128, 200, 12]);
  await page.mouse.move(...(await spot(page, 130, 202)));
  await page.mouse.down();
  await page.mouse.move(...(await spot(page, 100, 220)), { steps: 8 });
  await page.mouse.up();
  const [x, y, r] = await ball(page);
  assert.ok(Math.abs(x - 98) <= 1 && Math.abs(y - 218) <= 1, `dragged to ${x}, ${y}`);
  assert.equal(r, 12);

  await page.mouse.move(...(await spot(page, x + r, y)));
  await page.mouse.down();
  await page.mouse.move(...(await spot(page, x + 25, y)), { steps: 5 });
  await page.mouse.up();
  assert.ok(Math.abs((await ball(page))[2] - 25) <= 1);

  const [, , before] = await ball(page);
  await page.mouse.wheel(0, -100);
  await page.mouse.wheel(0, -100);
  await page.mouse.wheel(0, 100);
  await page.waitForFunction((wanted) => document.querySelector('#ball-r').value === wanted, String(before + 1));
  await page.locator('#radius').fill('9');
  assert.deepEqual(await ball(page), [x, y, 9]);
});

test('an invalid ball is outlined, named and never counts', async () => {
  const page = await openPuzzle(session);
  const { invalid } = await known(page);
  await type(page, invalid);
  const words = await says(page, /^Not here: The ball (sticks out of the scene|overlaps the [\w ]+)\.$/);
  assert.equal(await page.locator('#status').getAttribute('role'), 'status');
  await page.locator('#run').click();
  await says(page, /does not count as an attempt/);
  assert.equal(await attempts(page), 0);
  assert.ok(words.length > 0);
});

test('without a ball, Run says what to do', async () => {
  const page = await openPuzzle(session);
  await page.locator('#run').click();
  await says(page, /Place the ball first/);
});
