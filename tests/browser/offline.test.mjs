// dist/ after one visit: everything works without a network, another version is offered and never forced, and whatever goes
// wrong with the service worker, the page plays on.

import AxeBuilder from '@axe-core/playwright';
import assert from 'node:assert/strict';
import { appendFile, cp } from 'node:fs/promises';
import { join } from 'node:path';
import { after, before, beforeEach, test } from 'node:test';
import { changedDist, plainDist, temporaryFolder } from './dist-versions.mjs';
import { start, startOn } from './harness.mjs';
import { EASY, known, modelLoaded, openPuzzle, playModelTurn, says, type } from './page-actions.mjs';
import { serveStatic } from './static-server.mjs';

/** A name of this machine that browsers do not trust as they trust 127.0.0.1. */
const UNTRUSTED = 'pathlight.test';

let first;
let second;
let server;
let session;
before(async () => {
  [first, second] = [await plainDist(), await changedDist()];
  server = await serveStatic(first.folder);
  session = await startOn(server, [`--host-resolver-rules=MAP ${UNTRUSTED} 127.0.0.1`]);
});
beforeEach(() => (server.folder = first.folder));
after(() => session.stop());

/** Waits until a version is kept for offline. */
const kept = (page) => page.evaluate(async () => void (await navigator.serviceWorker.ready));
/** The folder of the version that the page is from. */
const versionOf = (page) => page.locator('script[src$="/main.js"]').getAttribute('src').then((src) => src.split('/')[0]);
/** Makes the page look for another version, as it does when it comes back into sight. */
const comeBack = (page) => page.evaluate(() => void document.dispatchEvent(new Event('visibilitychange')));
const sentence = (page) => page.locator('#update').filter({ hasText: 'A new version is here.' });
const cachedVersions = (page) => page.evaluate(async () => (await caches.keys()).map((name) => name.split('/').at(-2)));

async function solve(page) {
  await page.locator('#tab-play').click();
  await type(page, (await known(page)).solving);
  await page.locator('#run').click();
  await says(page, /^Solved!/);
}

async function imagine(page) {
  await page.locator('#tab-imagine').click();
  await page.locator('#imagined-in').filter({ hasText: 'Imagined' }).waitFor();
}

/** Waits until something is as expected. */
async function eventually(actual, expected) {
  const end = Date.now() + 20_000;
  for (;;) {
    const now = await actual();
    if (JSON.stringify(now) === JSON.stringify(expected)) return;
    assert.ok(Date.now() < end, `it stays ${JSON.stringify(now)}`);
    await new Promise((resume) => setTimeout(resume, 50));
  }
}

test('after one visit everything works without a network', async () => {
  const visit = await session.open('/', { reducedMotion: 'reduce' });
  await kept(visit);
  const context = visit.context();
  await visit.close();
  await context.setOffline(true);
  await server.stop();

  const page = await session.openIn(context, `/#task=${EASY}`);
  await solve(page);
  await imagine(page);
  await page.locator('#tab-compare').click();
  await playModelTurn(page);
  await page.locator('#proposals:visible').waitFor();
  await page.locator('#tab-predict').click();
  for (const key of ['ArrowDown', 'ArrowLeft', 'ArrowDown']) await page.locator('#scene').press(`Shift+${key}`);
  await page.locator('#predict-watch').click();
  await page.locator('#predict-cards canvas').first().waitFor();
  await page.locator('#tab-map').click();
  await page.locator('#solve-map-search').click();
  await page.locator('#solve-map-words').filter({ hasText: 'Every place tried' }).waitFor({ timeout: 120_000 });
  await page.locator('#tab-imagine').click();
  await page.locator('#model-select').selectOption('cross-0');
  await modelLoaded(page, 'cross-0');
  await page.locator('#home').click();
  await page.locator('#templates canvas.drawn').first().waitFor();

  await context.close();
  await server.start();
});

test('weights are kept for later only once the page is there', async () => {
  const since = server.answers.length;
  const page = await session.open('/');
  await kept(page);
  const urls = server.answers.slice(since).map(({ url }) => url);
  const at = (end) => urls.findIndex((url) => url.endsWith(end));
  assert.ok(at('service-worker.js') > at('/main.js') && at('.safetensors') > at('service-worker.js'), urls.join('\n'));
  await page.context().close();
});

test('an update while the page is open is offered, and taken when the person says so', async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await kept(page);
  const old = await versionOf(page);
  server.folder = second.folder;
  await comeBack(page);
  await sentence(page).waitFor();

  // The server has no file of the old version any more; the worker and the weights are loaded only now.
  await page.locator('#next').click();
  await imagine(page);
  await page.locator('#model-select').selectOption('cross-0');
  await modelLoaded(page, 'cross-0');
  await page.locator('#previous').click();
  await solve(page);
  assert.equal(await versionOf(page), old);
  await sentence(page).waitFor();

  const address = page.url();
  await sentence(page).getByRole('button', { name: 'Load it' }).click();
  await page.waitForFunction((old) => document.querySelector('script[src$="/main.js"]')?.getAttribute('src')?.startsWith(old) === false, old);
  assert.equal(page.url(), address);
  await solve(page);
  assert.equal(await sentence(page).count(), 0);
  // The old version is not kept any longer.
  await eventually(() => cachedVersions(page), [await versionOf(page)]);
  await page.context().close();
});

for (const [screen, size] of Object.entries({ 'a desktop': { viewport: { width: 1280, height: 800 } }, 'a phone': { viewport: { width: 360, height: 740 } } })) {
  for (const colorScheme of /** @type {const} */ (['light', 'dark'])) {
    test(`the sentence is in nobody's way on ${screen}, ${colorScheme}`, async () => {
      const page = await openPuzzle(session, { ...size, colorScheme });
      await kept(page);
      const scene = await page.locator('#scene').boundingBox();
      server.folder = second.folder;
      await comeBack(page);
      await sentence(page).waitFor();
      assert.deepEqual(await page.locator('#scene').boundingBox(), scene);
      const bar = await page.locator('#update').boundingBox();
      assert.ok(bar.height < 60, 'it takes one line');
      for (const id of ['scene', 'run', 'status', 'tab-play', 'radius']) {
        await page.locator(`#${id}`).scrollIntoViewIfNeeded();
        const box = await page.locator(`#${id}`).boundingBox();
        assert.ok(box.x + box.width <= bar.x + 1 || box.y + box.height <= bar.y + 1, `it covers #${id}`);
      }
      assert.deepEqual((await new AxeBuilder({ page }).include('#update').analyze()).violations.map(({ help }) => help), []);
      await page.context().close();
    });
  }
}

test('“Later” puts the new version off until no page is open', async () => {
  const page = await openPuzzle(session);
  await kept(page);
  const old = await versionOf(page);
  server.folder = second.folder;
  await comeBack(page);
  await sentence(page).getByRole('button', { name: 'Later' }).click();
  assert.equal(await sentence(page).count(), 0);
  await page.reload();
  assert.equal(await versionOf(page), old);
  const context = page.context();
  await page.close();
  const visit = async () => {
    // The browser replaces the service worker some time after the last page was closed.
    await new Promise((resume) => setTimeout(resume, 500));
    const next = await session.openIn(context);
    await next.locator('#templates canvas.drawn').first().waitFor();
    const version = await versionOf(next);
    await next.close();
    return version !== old;
  };
  await eventually(visit, true);
  await context.close();
});

test('of two open pages one takes the new version, and the other goes on in the old one', async () => {
  const one = await openPuzzle(session, { reducedMotion: true });
  await kept(one);
  const context = one.context();
  const other = await session.openIn(context, `/#task=${EASY}`);
  const old = await versionOf(one);
  server.folder = second.folder;
  await comeBack(one);
  await sentence(one).getByRole('button', { name: 'Load it' }).click();
  await one.waitForFunction((old) => document.querySelector('script[src$="/main.js"]')?.getAttribute('src')?.startsWith(old) === false, old);
  const renewed = await versionOf(one);

  // Its worker is started anew, and fetches the weights of the other model.
  await sentence(other).waitFor();
  await imagine(other);
  await other.locator('#model-select').selectOption('cross-0');
  await modelLoaded(other, 'cross-0');
  assert.equal(await versionOf(other), old);
  assert.deepEqual((await cachedVersions(other)).sort(), [old, renewed].sort());

  await other.locator('#home').click();
  await sentence(other).getByRole('button', { name: 'Load it' }).click();
  await other.waitForFunction((old) => document.querySelector('script[src$="/main.js"]')?.getAttribute('src')?.startsWith(old) === false, old);
  await eventually(() => cachedVersions(other), [renewed]);
  await context.close();
});

test('a version that arrives damaged is not taken', async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await kept(page);
  const old = await versionOf(page);
  const damaged = await temporaryFolder();
  await cp(second.folder, damaged, { recursive: true });
  await appendFile(join(damaged, [...second.files.keys()].find((path) => path.endsWith('/page.js')) ?? ''), '// half of another version\n');
  server.folder = damaged;
  const context = page.context();
  const failed = page.evaluate(async () => {
    const registration = await navigator.serviceWorker.ready;
    return new Promise((resolve) => registration.addEventListener('updatefound', () => {
      const { installing } = registration;
      installing?.addEventListener('statechange', () => resolve(installing.state));
    }));
  });
  await comeBack(page);
  assert.equal(await failed, 'redundant');
  assert.equal(await sentence(page).count(), 0);
  await context.setOffline(true);
  await page.reload();
  assert.equal(await versionOf(page), old);
  await solve(page);
  await context.close();
});

test('another page at the same address ends the service worker', async () => {
  const page = await session.open('/', { reducedMotion: 'reduce' });
  await kept(page);
  const context = page.context();
  await page.close();
  // As if the sources were served here, by `pathlight serve`: they have no service worker.
  const folder = await temporaryFolder();
  await cp(first.folder, folder, { recursive: true, filter: (path) => !path.endsWith('service-worker.js') });
  server.folder = folder;
  const stale = await session.openIn(context);
  await sentence(stale).waitFor();
  await sentence(stale).getByRole('button', { name: 'Load it' }).click();
  await eventually(() => stale.evaluate(() => navigator.serviceWorker.controller), null);
  await context.close();
  session.takeProblems();
});

for (const { what, script } of [
  { what: 'has no service workers', script: () => Object.defineProperty(Navigator.prototype, 'serviceWorker', { get: () => undefined }) },
  { what: 'refuses them', script: () => (navigator.serviceWorker.register = () => Promise.reject(new DOMException('denied', 'SecurityError'))) },
]) {
  test(`a browser that ${what} shows the page as ever`, async () => {
    const page = await session.open('', { reducedMotion: 'reduce' });
    await page.addInitScript(script);
    await page.goto(`${server.origin}/#task=${EASY}`);
    await solve(page);
    await imagine(page);
    await page.context().close();
  });
}

test('where storage is full the page is shown as ever', async () => {
  const page = await session.open('', { reducedMotion: 'reduce' });
  const devtools = await page.context().newCDPSession(page);
  await devtools.send('Storage.overrideQuotaForOrigin', { origin: new URL(server.origin).origin, quotaSize: 1_000_000 });
  await page.goto(`${server.origin}/#task=${EASY}`);
  const ended = await page.evaluate(async () => {
    for (;;) {
      const registration = await navigator.serviceWorker.getRegistration();
      const installing = registration?.installing;
      if (installing) return new Promise((resolve) => installing.addEventListener('statechange', () => resolve(installing.state)));
      await new Promise((resume) => setTimeout(resume, 10));
    }
  });
  assert.equal(ended, 'redundant');
  await solve(page);
  await imagine(page);
  await page.context().close();
});

test('by plain http from another machine the page is shown as ever', async () => {
  const page = await session.open('', { reducedMotion: 'reduce' });
  await page.goto(`${server.origin.replace('127.0.0.1', UNTRUSTED)}/#task=${EASY}`);
  assert.equal(await page.evaluate(() => isSecureContext), false);
  await solve(page);
  await imagine(page);
  await page.context().close();
});

test('a browser can install the page', async () => {
  const page = await session.open('/');
  await kept(page);
  const devtools = await page.context().newCDPSession(page);
  const { errors, url } = await devtools.send('Page.getAppManifest');
  assert.deepEqual(errors, []);
  assert.equal(url, `${server.origin}/manifest.webmanifest`);
  const { installabilityErrors } = await devtools.send('Page.getInstallabilityErrors');
  assert.deepEqual(installabilityErrors.filter(({ errorId }) => errorId !== 'in-incognito'), []);
  await page.context().close();
});

test('the sources are shown without a service worker', async () => {
  const sources = await start();
  const page = await sources.open('/');
  await page.locator('#templates canvas.drawn').first().waitFor();
  assert.deepEqual(await page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length), 0);
  assert.equal((await fetch(`${sources.origin}/service-worker.js`)).status, 404);
  await sources.stop();
});
