// dist/ works wherever it is put: under any path, on a host that sends no header but the media type, in a frame, and
// when another version is uploaded while it is open.

import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { createServer } from "node:http";
import { once } from "node:events";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { brotliDecompressSync, gunzipSync } from "node:zlib";
import { buildDist } from "../../scripts/build-dist.mjs";
import { changedDist, temporaryFolder } from "./dist-versions.mjs";
import { start, startOn } from "./harness.mjs";
import { drawIcons } from "./icons.mjs";
import { assertPolicyHolds, known, openLesson, openPuzzle, says, type } from "./page-actions.mjs";
import { serveStatic } from "./static-server.mjs";

/** Brotli's quality here: the highest takes half a minute for the weights. */
const QUALITY = 4;

let folder;
let files;
let server;
let session;
before(async () => {
  folder = await temporaryFolder();
  files = await buildDist({ out: folder, quality: QUALITY });
  server = await serveStatic(folder);
  session = await startOn(server);
});
after(() => session.stop());

test("under a sub-path, without a header, the first puzzle is played to its solution", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await type(page, (await known()).solving);
  await page.locator("#run").click();
  await says(page, /^Solved!/);
  await page.locator("#tab-imagine").click();
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  const failed = server.answers.filter(({ status }) => status !== 200);
  assert.deepEqual(failed, []);
});

test("a host that sends compressed files sends little of the weights, and their progress is right", async () => {
  const compressing = await start({ serve: ["--dir", folder] });
  const page = await compressing.open("");
  await page.addInitScript(() => {
    const shown = /** @type {PropertyDescriptor} */ (
      Object.getOwnPropertyDescriptor(HTMLProgressElement.prototype, "value")
    );
    globalThis.fractions = [];
    Object.defineProperty(HTMLProgressElement.prototype, "value", {
      ...shown,
      set(fraction) {
        globalThis.fractions.push(fraction);
      },
    });
  });
  const answer = page.waitForResponse((response) => response.url().endsWith(".safetensors"));
  await page.goto(`${compressing.origin}/#task=00000:000&panel=imagine`);
  const headers = (await answer).headers();
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  const fractions = await page.evaluate(() => globalThis.fractions.filter((fraction) => fraction > 0));
  await compressing.stop();
  assert.equal(headers["content-encoding"], "br");
  const size = [...files].find(([path]) => path.endsWith(".safetensors"))?.[1].length ?? 0;
  assert.ok(Number(headers["content-length"]) < 0.85 * size, `${headers["content-length"]} of ${size} bytes`);
  assert.ok(
    fractions.length > 2 && fractions.every((fraction, index) => index === 0 || fraction > fractions[index - 1]),
    `${fractions}`,
  );
  assert.equal(fractions.at(-1), 1);
});

test("its policy is in the page, and keeps scripts from elsewhere out", async () => {
  const page = await session.open("/");
  await assertPolicyHolds(session, page);

  const served = await start({ sources: true });
  const { headers } = await fetch(served.origin);
  await served.stop();
  const policy = await page.locator("meta[http-equiv=Content-Security-Policy]").getAttribute("content");
  assert.equal(headers.get("content-security-policy"), `${policy}; frame-ancestors 'none'`);
});

test("no address names a host or begins at the root", () => {
  assert.deepEqual(
    [...files].flatMap(([path, content]) => foreignAddresses(path, content.toString())),
    [],
  );
});

test("an address that names a host or begins at the root is found", () => {
  const found = (path, text) => foreignAddresses(path, text).length;
  assert.equal(found("index.html", '<script src="/main.js"></script>'), 1);
  assert.equal(found("index.html", "<link rel=\"stylesheet\" href='https://host/style.css'>"), 1);
  assert.equal(found("index.html", '<use href="//host/icon.svg#mark"/>'), 1);
  assert.equal(found("index.html", '<p>See <a href="https://host/">there</a>, <b href="#id">here</b>.</p>'), 0);
  assert.equal(found("style.css", 'a { background: url(/icon.svg) } b { background: url("icon.svg") }'), 1);
  assert.equal(found("main.js", 'import { a } from "/a.js"; await import("./b.js");'), 1);
  assert.equal(found("main.js", 'new URL("http://host/a", base); fetch(`/b`); new Worker("c.js")'), 2);
  assert.equal(
    found("manifest.webmanifest", '{ "start_url": "/", "scope": "./", "icons": [{ "src": "https://host/a.png" }] }'),
    2,
  );
});

/**
 * The addresses in a file that a browser would load or go to by itself, and that are not relative. What a person may
 * follow, a link in a text, is not one of them.
 */
function foreignAddresses(path, text) {
  const code = text.replace(/^\s*(\/\/|\/?\*).*$/gm, "");
  const patterns = {
    html: [/<(?!a\b)\w+[^>]*\s(?:href|src|action|data)\s*=\s*["']?([^"'\s>]+)/g],
    svg: [/\b(?:href|src)\s*=\s*["']([^"']+)/g],
    css: [/url\(\s*["']?([^"')]+)/g, /@import\s+["']([^"']+)/g],
    js: [
      /(?:\bfrom|\bimport)\s*\(?\s*["'`]([^"'`]+)/g,
      /\b(?:URL|Request|Worker|fetch|importScripts|register)\(\s*["'`]([^"'`]+)/g,
    ],
    json: [/"(?:file|src|start_url|scope|id)":\s*"([^"]+)"/g],
  };
  const kind = path.split(".").at(-1)?.replace("webmanifest", "json") ?? "";
  const addresses = (patterns[kind] ?? []).flatMap((pattern) =>
    [...code.matchAll(pattern)].map(([, address]) => address),
  );
  return addresses
    .filter((address) => /^(\/|[a-z][a-z0-9+.-]*:)/i.test(address))
    .map((address) => `${path}: ${address}`);
}

test("the same sources give the same bytes, and the compressed files are those beside them", async () => {
  const again = await temporaryFolder();
  await buildDist({ out: again, quality: QUALITY });
  const paths = await filesOf(folder);
  assert.deepEqual(await filesOf(again), paths);
  for (const path of paths)
    assert.ok((await readFile(join(again, path))).equals(await readFile(join(folder, path))), path);
  for (const [path, content] of files) {
    if (/\.png$/.test(path)) continue;
    assert.ok(brotliDecompressSync(await readFile(join(folder, `${path}.br`))).equals(content), path);
    assert.ok(gunzipSync(await readFile(join(folder, `${path}.gz`))).equals(content), path);
  }
});

async function filesOf(folder) {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  return entries
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name).slice(folder.length + 1))
    .sort();
}

test("a folder that holds other files is not replaced", async () => {
  await assert.rejects(buildDist({ out: join(folder, "icons") }), /holds files that are not a built page/);
});

test("another version has another folder for its code, and the same weights", async () => {
  const changed = await changedDist();
  const codeOf = (paths) => paths.filter((path) => path.includes("/") && !/^(assets|icons)\//.test(path));
  const [before, after] = [[...files.keys()], [...changed.files.keys()]];
  assert.deepEqual(
    codeOf(before).filter((path) => codeOf(after).includes(path)),
    [],
  );
  const weightsOf = (paths) => paths.filter((path) => path.endsWith(".safetensors"));
  assert.ok(weightsOf(before).length > 0);
  assert.deepEqual(weightsOf(after), weightsOf(before));
});

test("a page whose files are gone from the server says how to go on", async () => {
  const page = await session.open("/", { serviceWorkers: "block", reducedMotion: "reduce" });
  await page.locator("#templates a").first().waitFor();
  server.folder = (await changedDist()).folder;
  await page.evaluate(() => (location.hash = "task=00000:000&panel=imagine"));
  const trouble = page.locator("#imagine-trouble:visible").filter({ hasText: "load the page again" });
  await trouble.waitFor();
  await page.locator("#tab-play").click();
  await type(page, (await known()).solving);
  await page.locator("#run").click();
  await says(page, /^Solved!/);
  await page.reload();
  await page.locator("#tab-imagine").click();
  await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
  server.folder = folder;
  const problems = session.takeProblems();
  assert.ok(
    problems.every((problem) => problem.includes("404") || problem.includes("/model/worker.js")),
    problems.join("\n"),
  );
});

test("what is loaded only when it is asked for is there: the results, and the library for QR codes", async () => {
  const page = await session.open("/#view=results", { serviceWorkers: "block" });
  await page.locator("#results-templates a").first().waitFor();
  await page.goto(`${server.origin}/#task=00000:000`);
  await openLesson(page);
  await page.waitForFunction(
    () => /** @type {HTMLCanvasElement | null} */ (document.querySelector("#lesson-code"))?.width !== 300,
  );
  assert.ok(await page.locator("#lesson-code").isVisible());
});

test("another site may show it in a frame", async () => {
  const site = createServer((request, response) =>
    response
      .setHeader("content-type", "text/html")
      .end(`<iframe src="${server.origin}/#task=00000:000" width="900" height="700"></iframe>`),
  );
  site.listen(0, "localhost");
  await once(site, "listening");
  const page = await session.open("");
  await page.goto(`http://localhost:${/** @type {import('node:net').AddressInfo} */ (site.address()).port}`);
  await page.frameLocator("iframe").locator("#scene").waitFor();
  await page.close();
  site.close();
  assert.deepEqual(session.takeProblems(), []);
});

test("the icons of the manifest are drawn from icon.svg", async () => {
  const { icons } = JSON.parse(String(files.get("manifest.webmanifest")));
  for (const { src } of icons) assert.ok(files.has(src), src);
  const page = await session.open("/");
  const drawn = await drawIcons(session.browser);
  assert.deepEqual(
    icons.filter(({ type }) => type === "image/png").map(({ src }) => src),
    drawn.map(({ path }) => path),
  );
  for (const { path, side, png } of drawn) {
    const difference = await page.evaluate(
      pixelDifference,
      [files.get(path), png].map((image) => `data:image/png;base64,${image.toString("base64")}`),
    );
    assert.deepEqual(difference.sides, [side, side, side, side], path);
    assert.ok(
      difference.mean < 1,
      `${path} differs by ${difference.mean} of 255 on average: node tests/browser/icons.mjs draws it anew`,
    );
  }
});

/** The widths and heights of two pictures, and the mean difference of their channels, 0..255. */
async function pixelDifference(addresses) {
  const [one, other] = await Promise.all(
    addresses.map(async (address) => {
      const image = new Image();
      image.src = address;
      await image.decode();
      const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
      if (!context) throw new Error("no canvas");
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, image.width, image.height);
    }),
  );
  const sum = one.data.reduce((sum, value, at) => sum + Math.abs(value - other.data[at]), 0);
  return { sides: [one.width, one.height, other.width, other.height], mean: sum / one.data.length };
}
