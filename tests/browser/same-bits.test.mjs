// Natively, with one thread and with two, with AVX and without, in Node, in Chromium, in Firefox and, where it is
// installed, in WebKit the same rollouts to the bit, and the same proposals. PATHLIGHT_BITS=40 compares 1,000 rollouts,
// 40 of each template, and the proposals of 100 tasks. Processors that lack AVX are emulated by QEMU, where it is
// (apt-get install qemu-user).

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { startFirefox } from "./firefox.mjs";
import { startOn } from "./harness.mjs";
import { PACKAGE } from "./package.mjs";
import { computeInNode, computeInPage, computeNatively, digestOf, joined, pieces, sampleOf } from "./same-bits.mjs";
import { serveStatic } from "./static-server.mjs";
import { startWebKit, whyNoWebKit } from "./webkit.mjs";

const PER_TEMPLATE = Number(process.env.PATHLIGHT_BITS ?? 2);
const PROPOSED = process.env.PATHLIGHT_BITS ? 100 : 3;
/** Any file that a browser shows. */
const PAGE = "/licences.txt";
/** By what they have of AVX, the processors that QEMU emulates; the kernels of the nets differ. */
const PROCESSORS = { "with AVX2": "max", "without AVX": "Nehalem", "with SSE2 alone": "qemu64,-sse3" };

test(
  `${PER_TEMPLATE * 25} rollouts and the proposals of ${PROPOSED} tasks`,
  { timeout: 1_800_000 },
  async (context) => {
    const sample = await sampleOf(PER_TEMPLATE, PROPOSED);
    const native = computeNatively(sample);
    assert.ok(
      native.digests.length === PER_TEMPLATE * 25 && native.digests.every((digest) => /^[0-9a-f]{16}$/.test(digest)),
    );
    assert.ok(native.proposals.length === PROPOSED && native.proposals.every((balls) => balls.split(",").length > 200));
    context.diagnostic(`natively: ${digestOf(native)}`);
    const node = await computeInNode(sample);
    context.diagnostic(`Node: ${digestOf(node)}`);
    assert.deepEqual(node, native, "Node");
    const session = await startOn(await serveStatic(PACKAGE));
    /** @type {{ newPage: () => Promise<any>, close: () => Promise<void> }[]} */
    const browsers = [];
    const pageIn = async (browser) => {
      browsers.push(browser);
      const page = await browser.newPage();
      await page.goto(session.origin + PAGE);
      return page;
    };
    try {
      const pages = new Map([
        ["Chromium", await session.open(PAGE)],
        ["Firefox", await pageIn(await startFirefox())],
      ]);
      const lacks = whyNoWebKit();
      if (lacks) context.diagnostic(`WebKit is not compared: ${lacks}`);
      else pages.set("WebKit", await pageIn(await startWebKit()));
      for (const [name, page] of pages) {
        const computed = [];
        for (const piece of pieces(sample)) computed.push(await page.evaluate(computeInPage, piece));
        context.diagnostic(`${name}: ${digestOf(joined(computed))}`);
        assert.deepEqual(joined(computed), native, name);
      }
    } finally {
      for (const browser of browsers) await browser.close();
      await session.stop();
    }
  },
);

test("one thread or two, AVX or none", { timeout: 3_600_000 }, async (context) => {
  const sample = await sampleOf(PER_TEMPLATE, PROPOSED);
  const native = computeNatively(sample);
  for (const threads of [1, 2]) assert.deepEqual(computeNatively(sample, { threads }), native, `${threads} threads`);
  const lacks = process.arch === "x64" ? spawnSync("qemu-x86_64", ["--version"]).error : new Error("another processor");
  if (lacks) return context.diagnostic(`AVX is not compared: QEMU cannot be started here (${lacks.message})`);
  for (const [name, processor] of Object.entries(PROCESSORS)) {
    const computed = computeNatively(sample, { emulator: ["qemu-x86_64", "-cpu", processor] });
    context.diagnostic(`${name}: ${digestOf(computed)}`);
    assert.deepEqual(computed, native, name);
  }
});
