// <pathlight-puzzle> and the page around it: the page's styles, language, policy and missing files, and what axe finds.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { axeFindsNothing } from "./axe.mjs";
import { LESSON, embed, imagined, single, wait, workers } from "./embedding.mjs";
import { start } from "./harness.mjs";
import { known, openPanel } from "./page-actions.mjs";

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

/** Plays a ball that solves the puzzle. */
async function solve(page) {
  const { solving } = await known();
  await page
    .locator("pathlight-puzzle")
    .evaluate((element, ball) => element.setAttribute("ball", ball), String(solving));
  await page.locator("#run").click();
  await page
    .locator("#status")
    .filter({ hasText: /^Solved!/ })
    .waitFor();
}

for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
  test(`axe finds nothing in an embedded puzzle, ${colorScheme}`, async () => {
    const page = await embed(session, LESSON, { colorScheme });
    const [one, two] = [page.locator("#one"), page.locator("#two")];
    await imagined(two);
    const names = await page
      .getByRole("group", { name: /^Puzzle / })
      .evaluateAll((groups) => groups.map((group) => group.getAttribute("aria-label")));
    assert.equal(names.length, 2);
    assert.match(names[1], /^Puzzle Funnel 00007:008$/);
    for (const panel of ["play", "imagine", "compare", "predict", "map"]) {
      await openPanel(two, panel);
      await axeFindsNothing(page, panel, { all: true });
    }
    for (const show of ["showKeys", "showAbout"]) {
      await two.evaluate((element, name) => element[name](), show);
      await two.locator("dialog[open]").waitFor();
      await axeFindsNothing(page, show, { all: true });
      await page.keyboard.press("Escape");
    }
    await one.evaluate((element) => element.setAttribute("task", "00007:999"));
    await one.locator("#problem").waitFor();
    await axeFindsNothing(page, "an unknown puzzle", { all: true });
  });
}

test("the puzzle looks the same whatever the page sets for its own text", async () => {
  const plain = single('task="00000:000" panel="imagine" theme="dark"', "width: 900px");
  const styles = `<style>
    * { font: italic 40px/3 serif; color: rgb(1, 2, 3); text-align: right; letter-spacing: 5px; word-spacing: 9px;
    * text-transform: uppercase; text-indent: 20px; }
    body { font: 40px serif; text-align: center; letter-spacing: 5px; }
  </style>`;
  const looks = [];
  for (const markup of [plain, plain.replace("<main>", `${styles}<main>`)]) {
    const page = await embed(session, markup);
    await imagined(page.locator("pathlight-puzzle"));
    await page.locator("pathlight-puzzle").evaluate((element) => element.showAbout());
    looks.push(
      await page.locator("pathlight-puzzle").evaluate(({ shadowRoot }) => {
        const names = [
          "font",
          "color",
          "textAlign",
          "letterSpacing",
          "wordSpacing",
          "lineHeight",
          "textTransform",
          "textIndent",
          "width",
          "height",
        ];
        const elements = [
          ...shadowRoot.querySelectorAll(".puzzle, .puzzle *, #about-dialog, #about-dialog *, #announcement"),
        ];
        return elements.map((element) =>
          [element.tagName, element.id, ...names.map((name) => getComputedStyle(element)[name])].join(" "),
        );
      }),
    );
  }
  assert.ok(looks[0].length > 100);
  assert.deepEqual(
    looks[1].filter((look, at) => look !== looks[0][at]),
    [],
  );
});

test("the maps over the scene follow the theme", async () => {
  const attributes = 'task="00007:008" panel="imagine" layers="target,placement"';
  const [dark, changed] = [
    await embed(session, single(`${attributes} theme="dark"`)),
    await embed(session, single(`${attributes} theme="light"`)),
  ];
  const pictureOf = (page) => page.locator("#scene").evaluate((canvas) => canvas.toDataURL());
  for (const page of [dark, changed]) await imagined(page.locator("pathlight-puzzle"));
  await changed.locator("pathlight-puzzle").evaluate((element) => element.setAttribute("theme", "dark"));
  await wait(async () => (await pictureOf(changed)) === (await pictureOf(dark)), "the same picture");
});

test("in a page of a language that it does not speak it is English, from left to right", async () => {
  const page = await embed(
    session,
    single('task="00000:000"').replace('<html lang="en">', '<html lang="ar" dir="rtl">'),
  );
  await page.locator("#scene").waitFor();
  const wrong = await page.locator("pathlight-puzzle").evaluate(({ shadowRoot }) =>
    [...shadowRoot.children]
      .filter((element) => !["svg", "TEMPLATE"].includes(element.tagName))
      .filter((element) => !element.matches(":lang(en)") || getComputedStyle(element).direction !== "ltr")
      .map(({ outerHTML }) => outerHTML),
  );
  assert.deepEqual(wrong, []);
  assert.deepEqual(
    await page
      .locator("pathlight-puzzle")
      .evaluate(({ shadowRoot }) => shadowRoot.querySelectorAll(".puzzle, dialog").length),
    3,
  );
});

test("in a German page it speaks German, also to an English browser", async () => {
  const page = await embed(session, single('task="00000:000"').replace('<html lang="en">', '<html lang="de">'));
  await page.locator("#goal:lang(de)").filter({ hasText: "Die grüne Kugel soll" }).waitFor();
});

for (const { what, files, answer, words } of [
  {
    what: "a missing wasm",
    files: "**/*.wasm",
    answer: (route) => route.fulfill({ status: 404 }),
    words: /the server answered 404 .*Build or install Pathlight again/,
  },
  {
    what: "no way to the wasm",
    files: "**/*.wasm",
    answer: (route) => route.abort(),
    words: /wasm could not be loaded: .*Check the connection and try again/,
  },
  {
    what: "no way to a style sheet",
    files: "**/*.css",
    answer: (route) => route.abort(),
    words: /style sheet could not be loaded: .*Check the connection and try again/,
  },
]) {
  test(`${what} is a sentence in the element, and it is loaded when asked again`, async () => {
    const page = await session.open("", { reducedMotion: "reduce" });
    await page.route(files, answer);
    await page.route("**/lesson.html", (route) =>
      route.fulfill({ body: single('task="00000:000"'), contentType: "text/html" }),
    );
    await page.goto(`${session.origin}/lesson.html`);
    const alert = page.getByRole("alert").filter({ hasText: words });
    await alert.waitFor();
    assert.ok(await alert.evaluate((element) => element.matches(":lang(en)")));
    await axeFindsNothing(page, what, { all: true });
    await alert.getByRole("button", { name: "Try again" }).click();
    await page.locator(".placeholder button:focus").waitFor();
    await page.unroute(files);
    await alert.getByRole("button", { name: "Try again" }).click();
    await page.locator("#scene:focus").waitFor();
    await solve(page);
    const problems = session.takeProblems();
    assert.ok(
      problems.every((problem) => /404|ERR_FAILED/.test(problem)),
      problems.join("\n"),
    );
  });
}

test("an error of our own reaches the console, in the first update too", async () => {
  const page = await session.open("");
  await page.route("**/element/controller.js", async (route) => {
    const response = await route.fetch();
    await route.fulfill({
      response,
      body: `${await response.text()}\nPuzzleController.prototype.applyTexts = () => { throw new Error('the soup is cold'); };`,
    });
  });
  await page.route("**/lesson.html", (route) =>
    route.fulfill({ body: single('task="00000:000"'), contentType: "text/html" }),
  );
  await Promise.all([
    page.waitForEvent("pageerror", ({ message }) => message === "the soup is cold"),
    page.goto(`${session.origin}/lesson.html`),
  ]);
  await page.unroute("**/element/controller.js");
  await page.route("**/element/controller.js", (route) =>
    route.fulfill({
      body: "export class PuzzleController { constructor() { throw new Error('the soup is salty'); } }",
      contentType: "text/javascript",
    }),
  );
  await Promise.all([
    page.waitForEvent("pageerror", ({ message }) => message === "the soup is salty"),
    page.goto(`${session.origin}/lesson.html`),
  ]);
  await page.getByRole("alert").filter({ hasText: "the soup is salty" }).waitFor();
  const problems = session.takeProblems();
  assert.ok(
    problems.every((problem) => /the soup is/.test(problem)),
    problems.join("\n"),
  );
});

test("where the page forbids workers the puzzle says so and can be played", async () => {
  const headers = { "content-security-policy": "worker-src 'none'" };
  const page = await embed(session, single('task="00000:000" panel="imagine"'), { headers });
  await page
    .locator("#imagine-trouble:visible")
    .filter({ hasText: /worker/i })
    .waitFor();
  assert.ok(await page.locator("#imagine-loading").isHidden());
  await solve(page);
  const problems = session.takeProblems();
  assert.ok(
    problems.every((problem) => /Content Security Policy|worker\.js/.test(problem)),
    problems.join("\n"),
  );
});

test("a frame with the attribute sandbox is told what it has to allow", async () => {
  const frame = (sandbox) =>
    `<!doctype html><html lang="en"><title>Frame</title><iframe sandbox="${sandbox}" src="/inside.html"></iframe></html>`;
  const inside = single('task="00000:000" panel="imagine"');
  for (const { sandbox, works } of [
    { sandbox: "allow-scripts", works: false },
    { sandbox: "allow-scripts allow-same-origin", works: true },
  ]) {
    const page = await session.open("");
    // A frame without an origin needs every file of the server by CORS.
    await page.route("**/*", async (route) => {
      const { pathname } = new URL(route.request().url());
      const headers = { "access-control-allow-origin": "*" };
      const pages = { "/lesson.html": frame(sandbox), "/inside.html": inside };
      if (pathname in pages) return route.fulfill({ body: pages[pathname], contentType: "text/html", headers });
      const response = await route.fetch();
      return route.fulfill({ response, headers: { ...response.headers(), ...headers } });
    });
    await page.goto(`${session.origin}/lesson.html`);
    const puzzle = page.frameLocator("iframe").locator("pathlight-puzzle");
    if (works) await imagined(puzzle);
    else
      await puzzle
        .locator("#imagine-trouble:visible")
        .filter({ hasText: /allow-same-origin/ })
        .waitFor();
    assert.deepEqual(session.takeProblems(), []);
  }
});

test("a second copy of the module leaves the first one in place", async () => {
  const page = await embed(session, single('task="00000:000"'));
  await page.locator("#scene").waitFor();
  const kept = await page.evaluate(async (address) => {
    const first = customElements.get("pathlight-puzzle");
    const { PathlightPuzzle } = await import(address);
    return PathlightPuzzle !== first && customElements.get("pathlight-puzzle") === first;
  }, "/element/pathlight-puzzle.js?copy");
  assert.ok(kept);
});

test("modules from another origin bring their worker along", async () => {
  const page = await session.open("");
  await page.context().route("http://elsewhere.test/**", async (route) => {
    const { pathname } = new URL(route.request().url());
    const response = await route.fetch({ url: session.origin + pathname });
    await route.fulfill({
      response,
      headers: { "content-type": response.headers()["content-type"], "access-control-allow-origin": "*" },
    });
  });
  const markup = single('task="00007:008" panel="imagine"').replace("/element/", "http://elsewhere.test/element/");
  await page.route("**/lesson.html", (route) => route.fulfill({ body: markup, contentType: "text/html" }));
  await page.goto(`${session.origin}/lesson.html`);
  await imagined(page.locator("pathlight-puzzle"));
  workers(page, 1);
});
