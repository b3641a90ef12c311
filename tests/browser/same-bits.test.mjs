// Natively, in Node, in Chromium and in Firefox the same rollouts to the bit, and the same proposals.
// PATHLIGHT_BITS=40 compares 1,000 rollouts, 40 of each template, and the proposals of 100 tasks.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { startFirefox } from './firefox.mjs';
import { start } from './harness.mjs';
import { computeInNode, computeInPage, computeNatively, digestOf, joined, pieces, sampleOf } from './same-bits.mjs';

const PER_TEMPLATE = Number(process.env.PATHLIGHT_BITS ?? 2);
const PROPOSED = process.env.PATHLIGHT_BITS ? 100 : 3;

test(`${PER_TEMPLATE * 25} rollouts and the proposals of ${PROPOSED} tasks`, { timeout: 1_800_000 }, async (context) => {
  const sample = await sampleOf(PER_TEMPLATE, PROPOSED);
  const native = computeNatively(sample);
  assert.ok(native.digests.length === PER_TEMPLATE * 25 && native.digests.every((digest) => /^[0-9a-f]{64}$/.test(digest)));
  assert.ok(native.proposals.length === PROPOSED && native.proposals.every((balls) => balls.split(',').length > 200));
  context.diagnostic(`natively: ${digestOf(native)}`);
  const node = await computeInNode(sample);
  context.diagnostic(`Node: ${digestOf(node)}`);
  assert.deepEqual(node, native, 'Node');
  const session = await start();
  const firefox = await startFirefox();
  try {
    const pages = { Chromium: await session.open('/'), Firefox: await firefox.newPage() };
    await pages.Firefox.goto(`${session.origin}/`);
    for (const [name, page] of Object.entries(pages)) {
      const computed = [];
      for (const piece of pieces(sample)) computed.push(await page.evaluate(computeInPage, piece));
      context.diagnostic(`${name}: ${digestOf(joined(computed))}`);
      assert.deepEqual(joined(computed), native, name);
    }
  } finally {
    await firefox.close();
    await session.stop();
  }
});
