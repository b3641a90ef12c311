// The installed package in Chromium: the README's pages from a plain server, and a bundle made by Vite under a sub-path.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { launch } from '../browser/harness.mjs';
import { examples, makeProject, root, serve } from './project.mjs';

const project = makeProject();
const [drawing] = examples(project, 'html');

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/** Opens an address in a new page, hands it to `look`, and throws if the page complained meanwhile. */
async function visit(address, look) {
  const page = await browser.newPage();
  const problems = [];
  page.on('console', (message) => message.type() === 'error' && !/favicon/.test(message.location().url) && problems.push(message.text()));
  page.on('pageerror', (error) => problems.push(error.message));
  await page.goto(address);
  await look(page);
  await page.close();
  assert.deepEqual(problems, []);
}

/** Waits until a canvas shows something. */
const drawn = (page, id) =>
  page.waitForFunction((id) => {
    const canvas = /** @type {any} */ (document.getElementById(id));
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    return new Set(new Uint32Array(data.buffer)).size > 3;
  }, id);

test('a plain page draws what the nets imagine', async () => {
  writeFileSync(join(project, 'imagine.html'), drawing);
  await visit(`${await serve(project)}imagine.html`, async (page) => {
    await drawn(page, 'scene');
    await drawn(page, 'map');
  });
});

test('a bundle works under a sub-path', async () => {
  const app = join(project, 'app');
  mkdirSync(app, { recursive: true });
  writeFileSync(join(app, 'index.html'), drawing.replaceAll('./node_modules/pathlight/api/pathlight.js', 'pathlight'));
  const vite = join(root, 'tests/package/node_modules/.bin/vite');
  execFileSync(vite, ['build', '--base', './', '--logLevel', 'warn'], { cwd: app, stdio: 'inherit' });
  await visit(await serve(join(app, 'dist'), '/a/b/'), async (page) => {
    await drawn(page, 'scene');
    await drawn(page, 'map');
  });
});
