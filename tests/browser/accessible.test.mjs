// axe finds nothing serious or critical on any view, light or dark.

import AxeBuilder from '@axe-core/playwright';
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { start } from './harness.mjs';
import { EASY, known, says, type } from './playing.mjs';

let session;
before(async () => (session = await start()));
after(() => session.stop());

const VIEWS = {
  grid: '/',
  play: `/#task=${EASY}`,
  imagine: `/#task=${EASY}&panel=imagine&layers=base,placement`,
  compare: `/#task=${EASY}&panel=compare`,
  'bad link': '/#task=00007:999',
};

async function check(page, view) {
  const { violations } = await new AxeBuilder({ page }).analyze();
  const bad = violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
  const told = bad.map(({ id, help, nodes }) => `${id}: ${help}\n  ${nodes.map(({ html }) => html).join('\n  ')}`);
  assert.equal(bad.length, 0, `${view}:\n${told.join('\n')}`);
}

for (const colorScheme of ['light', 'dark']) {
  test(`every view, ${colorScheme}`, async () => {
    for (const [view, path] of Object.entries(VIEWS)) {
      const page = await session.open(path, { colorScheme });
      await page.locator(path === '/' || view === 'bad link' ? '#templates canvas.drawn' : '#scene').first().waitFor();
      if (view === 'imagine') await page.locator('#imagined-in').filter({ hasText: 'Imagined' }).waitFor();
      await check(page, view);
      await page.context().close();
    }
  });

  test(`solved, not solved and the sheet of keys, ${colorScheme}`, async () => {
    const page = await session.open(`/#task=${EASY}`, { colorScheme, reducedMotion: 'reduce' });
    await page.locator('#scene').waitFor();
    const { solving, missing, invalid } = await known(page);
    for (const [one, words] of [[missing, /^Not solved/], [solving, /^Solved/], [invalid, /does not count/]]) {
      await type(page, one);
      await page.locator('#run').click();
      await says(page, words);
      await check(page, String(words));
    }
    await page.locator('#help').click();
    await check(page, 'keys');
  });
}
