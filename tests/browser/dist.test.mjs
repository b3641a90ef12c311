// dist/ works wherever it is put: under any path, on a host that sends no header but the media type, in a frame,
// without a network, and when another version is uploaded while it is open.

import assert from "node:assert/strict";
import { once } from "node:events";
import { mkdtemp, readFile, readdir, rm } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { brotliDecompressSync, gunzipSync } from "node:zlib";
import { start, startOn, startServer } from "./harness.mjs";
import { drawIcons } from "./icons.mjs";
import { EASY, STILL, button, drop, known, modelIsThere, place, says } from "./player.mjs";
import { serveStatic } from "./static-server.mjs";
import { buildDist } from "../../scripts/build-dist.mjs";

/** Brotli's quality here: the highest takes half a minute for the weights. */
const QUALITY = 4;

/** Folders that go at the end. */
const folders = [];
let folder;
let files;
/** Another version: a file of the page has one more line. */
let newer;
let server;
let session;
before(async () => {
  folder = await temporaryFolder();
  files = await buildDist({ out: folder, quality: QUALITY });
  newer = await temporaryFolder();
  const change = (files) => files.set("style.css", Buffer.from(`${files.get("style.css")}\n`));
  await buildDist({ out: newer, quality: 0, change });
  server = await serveStatic(folder);
  session = await startOn(server);
});
after(async () => {
  await session.stop();
  await Promise.all(folders.map((one) => rm(one, { recursive: true })));
});

async function temporaryFolder() {
  const folder = await mkdtemp(join(tmpdir(), "pathlight-dist-"));
  folders.push(folder);
  return folder;
}

const style = (page) => page.locator("link[rel=stylesheet]").getAttribute("href");
const menu = async (page, name) => {
  await button(page, "Menu").click();
  await button(page, name).click();
};

test("under a sub-path, without a header, a puzzle is played against the model", async () => {
  const page = await session.open("", { ...STILL, serviceWorkers: "block" });
  await page.goto(`${session.origin}/#task=${EASY}`);
  await modelIsThere(page);
  await place(page, (await known()).solving);
  await drop(page);
  await says(page, /^(You beat the model|A draw)/);
  const failed = server.answers.filter(({ status }) => status !== 200);
  assert.deepEqual(failed, []);
});

test("a host that sends compressed files sends little of the weights, and their progress is right", async () => {
  const compressing = await start({ dir: folder });
  const page = await compressing.open("");
  await page.addInitScript(() => {
    const fractions = [];
    Object.assign(globalThis, { fractions });
    Object.defineProperty(HTMLProgressElement.prototype, "value", {
      set: (fraction) => {
        fractions.push(fraction);
      },
    });
  });
  const answer = page.waitForResponse((response) => response.url().endsWith(".safetensors"));
  await page.goto(`${compressing.origin}/#task=${EASY}`);
  const headers = (await answer).headers();
  await modelIsThere(page);
  const fractions = await page.evaluate(() => /** @type {any} */ (globalThis).fractions);
  await compressing.stop();
  assert.equal(headers["content-encoding"], "br");
  const size = [...files].find(([path]) => path.endsWith(".safetensors"))[1].length;
  assert.ok(Number(headers["content-length"]) < 0.85 * size, `${headers["content-length"]} of ${size} bytes`);
  assert.ok(fractions.length > 2 && fractions.at(-1) > 0.5 && fractions.at(-1) <= 1, `${fractions}`);
  assert.ok(fractions.every((fraction, index) => index === 0 || fraction >= fractions[index - 1]));
});

test("its policy is in the page, and keeps other scripts out; our server sends the same", async () => {
  const page = await session.open("/", { serviceWorkers: "block" });
  const ran = await page.evaluate(() => {
    const script = document.createElement("script");
    script.textContent = 'document.title = "intruder"';
    document.head.append(script);
    return document.title === "intruder";
  });
  assert.equal(ran, false);
  assert.ok(session.takeProblems().every((problem) => /Content Security Policy/.test(problem)));
  const ours = await startServer(["--dir", folder]);
  const { headers } = await fetch(ours.origin);
  await ours.stop();
  const policy = await page.locator("meta[http-equiv=Content-Security-Policy]").getAttribute("content");
  assert.equal(headers.get("content-security-policy"), `${policy}; frame-ancestors 'none'`);
});

test("another site may show it in a frame", async () => {
  const site = createServer((_, response) =>
    response
      .setHeader("content-type", "text/html")
      .end(`<iframe src="${server.origin}/#task=${EASY}" width="900" height="700"></iframe>`),
  );
  site.listen(0, "localhost");
  await once(site, "listening");
  const page = await session.open("");
  await page.goto(`http://localhost:${/** @type {import('node:net').AddressInfo} */ (site.address()).port}`);
  const frame = page.frameLocator("iframe");
  await frame.getByText(/^Model A\./).waitFor();
  await page.context().close();
  site.close();
});

test("once it was open, page and exhibits work without a network", async () => {
  const page = await session.open("/", STILL);
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.reload();
  await page.context().setOffline(true);
  await page.goto(`${session.origin}/#task=${EASY}`);
  await page.reload();
  await modelIsThere(page);
  await page.goto(`${session.origin}/results.html`);
  await page.locator(".tasks a").first().waitFor();
  await page.goto(`${session.origin}/learns.html`);
  await button(page, "Let it play 20").click();
  await page.locator("figcaption", { hasText: "Ball 1" }).first().waitFor();
  session.takeProblems();
});

test("another version that is uploaded while it is open is offered, and the old one goes on until it is taken", async () => {
  const page = await session.open("", STILL);
  await page.goto(`${session.origin}/#task=${EASY}`);
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.reload();
  const before = await style(page);
  server.folder = newer;
  try {
    await page.evaluate(() => document.dispatchEvent(new Event("visibilitychange")));
    await page.getByText("There is a new version of Pathlight").waitFor();
    // Code that is loaded only now is that of the version that is open.
    await menu(page, "Deutsch");
    await button(page, "Fallen lassen").waitFor();
    await button(page, "English").click();
    await button(page, "Link for a lesson").click();
    await page.getByRole("img", { name: "QR code" }).waitFor();
    await page.keyboard.press("Escape");
    await Promise.all([page.waitForNavigation(), button(page, "Load it").click()]);
    await button(page, "Drop it").waitFor();
    assert.notEqual(await style(page), before);
  } finally {
    server.folder = folder;
  }
});

test("a page whose files are gone from the server plays on, and says what cannot be loaded", async () => {
  const page = await session.open("", { ...STILL, serviceWorkers: "block" });
  await page.goto(`${session.origin}/#task=${EASY}`);
  await modelIsThere(page);
  server.folder = newer;
  try {
    await menu(page, "Deutsch");
    await page.getByRole("alert").getByText("This language could not be loaded").waitFor();
    await place(page, (await known()).solving);
    await drop(page);
    await says(page, /^(You beat the model|A draw)/);
  } finally {
    server.folder = folder;
  }
  session.takeProblems();
});

test("another version has another folder for its code, and the same weights", async () => {
  const [one, other] = [await filesOf(folder), await filesOf(newer)];
  const shared = one.filter((path) => other.includes(path) && path.includes("/"));
  assert.deepEqual([...new Set(shared.map((path) => path.split("/")[0]))], ["assets", "icons"]);
  assert.ok(shared.filter((path) => path.endsWith(".safetensors")).length === 2);
});

test("no address that a browser loads by itself names a host or begins at the root", () => {
  const foreign = [...files].flatMap(([path, content]) => foreignAddresses(path, content.toString()));
  assert.deepEqual(foreign, []);
  const found = (path, text) => foreignAddresses(path, text).length;
  assert.equal(found("a.html", `<script src="/main.js"></script><use href='//host/a.svg'/><a href="https://a/">`), 2);
  assert.equal(found("a.css", 'a { background: url(/icon.svg) } b { background: url("icon.svg") }'), 1);
  assert.equal(found("a.js", 'import { a } from "/a.js"; await import("./b.js"); fetch(`/b`); new Worker("c.js")'), 2);
  assert.equal(
    found("a.webmanifest", '{ "start_url": "/", "scope": "./", "icons": [{ "src": "https://a/b.png" }] }'),
    2,
  );
});

function foreignAddresses(path, text) {
  const patterns = {
    html: [/<(?!a\b)\w+[^>]*\s(?:href|src|action|data)\s*=\s*["']?([^"'\s>]+)/g],
    svg: [/\b(?:href|src)\s*=\s*["']([^"']+)/g],
    css: [/url\(\s*["']?([^"')]+)/g, /@import\s+["']([^"']+)/g],
    js: [
      /(?:\bfrom|\bimport)\s*\(?\s*["'`]([^"'`]+)/g,
      /\b(?:URL|Request|Worker|fetch|importScripts|register)\(\s*["'`]([^"'`]+)/g,
    ],
    webmanifest: [/"(?:file|src|start_url|scope|id)":\s*"([^"]+)"/g],
  };
  const addresses = (patterns[path.split(".").at(-1)] ?? []).flatMap((pattern) =>
    [...text.matchAll(pattern)].map(([, address]) => address),
  );
  return addresses.filter((address) => /^(\/|[a-z][a-z0-9+.-]*:)/i.test(address)).map((one) => `${path}: ${one}`);
}

test("the same sources give the same bytes, and the compressed files are those beside them", async () => {
  const again = await temporaryFolder();
  await buildDist({ out: again, quality: QUALITY });
  const paths = await filesOf(folder);
  assert.deepEqual(await filesOf(again), paths);
  for (const path of paths)
    assert.ok((await readFile(join(again, path))).equals(await readFile(join(folder, path))), path);
  for (const path of paths.filter((path) => path.endsWith(".br"))) {
    const content = await readFile(join(folder, path.slice(0, -3)));
    assert.ok(brotliDecompressSync(await readFile(join(folder, path))).equals(content), path);
    assert.ok(gunzipSync(await readFile(join(folder, path.replace(/br$/, "gz")))).equals(content), path);
  }
});

async function filesOf(folder) {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  const found = entries.filter((entry) => entry.isFile());
  return found.map((entry) => join(entry.parentPath, entry.name).slice(folder.length + 1)).sort();
}

test("a folder that holds other files is not replaced", async () => {
  await assert.rejects(buildDist({ out: join(folder, "icons") }), /holds files that are not a built page/);
});

test("the icons of the manifest are drawn from icon.svg", async () => {
  const { icons } = JSON.parse(String(files.get("manifest.webmanifest")));
  for (const { src } of icons) assert.ok(files.has(src), src);
  const page = await session.open("/", { serviceWorkers: "block" });
  const drawn = await drawIcons(session.browser);
  assert.deepEqual(
    icons.filter(({ type }) => type === "image/png").map(({ src }) => src),
    drawn.map(({ path }) => path),
  );
  for (const { path, side, png } of drawn) {
    const images = [files.get(path), png].map((image) => `data:image/png;base64,${image.toString("base64")}`);
    const { sides, mean } = await page.evaluate(pixelDifference, images);
    assert.deepEqual(sides, [side, side, side, side], path);
    assert.ok(mean < 1, `${path} differs by ${mean} of 255 on average: node tests/browser/icons.mjs draws it anew`);
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
