// The entry: shows the top of the home page, loads the wasm and starts the page. Unhandled errors are shown here.

import "../element/pathlight-puzzle.js";
import { Hero } from "../home/hero.js";
import { byId } from "../widgets/dom.js";
import { hideParts } from "../widgets/hidden-parts.js";
import { showNotice } from "../widgets/notice.js";
import { loadWasm } from "../loading/load-wasm.js";
import { nextTask } from "../loading/next-task.js";
import { templateOf } from "../puzzles/templates.js";
import { showsHome } from "../state/links.js";
import { parseFragment } from "../state/url-state.js";
import { LANGUAGES, language } from "../text/language.js";
import { text, useLanguage } from "../text/text.js";
import { translate } from "../text/translate.js";

const reload = () => location.reload();

/** @param {unknown} error */
function showCrash(error) {
  const reason = error instanceof Error ? error.message : String(error);
  showNotice(text.page.broken.crash(reason.replace(/\.$/, "")), [[text.page.broken.reload, reload]]);
}

addEventListener("error", ({ error, message }) => showCrash(error ?? message));
addEventListener("unhandledrejection", ({ reason }) => showCrash(reason));

// First of all, so that no word is read before.
await useLanguage(new URLSearchParams(location.search).get("lang"), ...navigator.languages);
document.documentElement.lang = language;
// index.html holds the English words.
if (language !== "en") translate(document);
byId(document, "languages").append(
  ...Object.entries(LANGUAGES)
    .filter(([name]) => name !== language)
    .map(languageLink),
);

/** The top of the home page, which needs no wasm; at once if it is what the address asks for. */
const hero = new Hero();
const { state } = parseFragment(location.hash);
if (showsHome(state)) {
  hero.setState(state);
  hideParts(document, state.hide);
  byId(document, "gallery").hidden = false;
}
document.documentElement.classList.remove("home");
// A puzzle needs the wasm; what happens in it can be read meanwhile.
const story = byId(document, "loading-story");
const kind = state.task !== null && !state.hide.includes("story") ? templateOf(state.task)?.id : undefined;
for (const line of story.querySelectorAll("p")) line.classList.toggle("told", line.dataset.kind === kind);

/**
 * A link to the page in another language.
 * @param {[name: string, itself: string]} language
 */
function languageLink([name, itself]) {
  const link = document.createElement("a");
  Object.assign(link, { href: `?lang=${name}`, lang: name, hreflang: name, textContent: itself });
  // The fragment stays: it says, for example, what a lesson hides.
  link.addEventListener("click", () => (link.href = `?lang=${name}${location.hash}`));
  return link;
}

// Awaited, because offline/updates.js waits for this module before it keeps files for later.
await loadWasm().then(
  async () => {
    // Imported here, so that an error in the page's modules is shown too, as is one in the puzzle before they come.
    const { Page } = await import("./page.js");
    await nextTask();
    story.hidden = true;
    new Page(hero).start();
  },
  (error) => {
    // The notice says it once for the page and its puzzle. Loads the same address again, with what follows # in it.
    byId(document, "puzzle").hidden = story.hidden = true;
    showNotice(/** @type {Error} */ (error).message, [[text.element.tryAgain, reload]]);
  },
);
