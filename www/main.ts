// The page: opens the puzzle that the address names, and stores attempts.

import { existing, follow, homeTask, puzzleOf } from "./opening.ts";
import { explained, filesAt, mount } from "./app.ts";
import { setNotice } from "./core/change/settings.ts";
import { addressEffect, hasMovedOn, pageOf, readLocation } from "./effects/address.ts";
import { homeEffects } from "./effects/home.ts";
import { cardEffect, qrEffect } from "./effects/sharing.ts";
import { keepingEffect, listenToOtherTabs, readKept } from "./effects/keeping.ts";
import { takeOver } from "./effects/old-keeping.ts";
import { documentEffect } from "./effects/language.ts";
import { loadSimulator, openPuzzle } from "./simulator.ts";
import { languageOf, loadText } from "./text/languages.ts";

const files = filesAt(import.meta.url);

async function run(root: HTMLElement): Promise<void> {
  const elsewhere = pageOf(location.hash);
  if (elsewhere) return location.replace(elsewhere);
  const forever = new AbortController().signal;
  const kept = readKept();
  const language = languageOf(navigator.language) ?? "en";
  const [text] = await Promise.all([loadText(kept.language ?? language), loadSimulator(files.simulator)]);
  const { link, unread } = readLocation(text);
  const shared = link.scene === null ? null : await puzzleOf(link.scene);
  const custom = shared && !("problem" in shared) ? shared : null;
  const named = custom ?? (link.task === null ? null : existing(link.task));
  const puzzle = named ?? openPuzzle(homeTask(kept));
  const given = { root, keys: document, link, puzzle, kept, files, language, theme: null, text };
  const home = homeEffects(new URL("assets/home.json", import.meta.url).href);
  const effects = [addressEffect, documentEffect, keepingEffect(), ...home, cardEffect, qrEffect];
  const { store } = await mount({ ...given, embedded: false, effects }, forever);
  listenToOtherTabs(store, forever);
  void takeOver(store);
  if (shared && "problem" in shared) store.change(setNotice, { kind: "bad_scene", ...shared });
  else if (link.task !== null && !named) store.change(setNotice, { kind: "no_task", task: link.task });
  else if (unread.length) store.change(setNotice, { kind: "unread_link", parts: unread });
  addEventListener("hashchange", followLocation);
  if (hasMovedOn()) followLocation();

  function followLocation(): void {
    const { link, unread } = readLocation(store.state.text);
    follow(store, link);
    if (unread.length) store.change(setNotice, { kind: "unread_link", parts: unread });
  }
}

const root = document.getElementById("page")!;
run(root).catch(async (error) => {
  reportError(error);
  const trouble = document.getElementById("trouble")!;
  trouble.hidden = false;
  trouble.textContent = await explained(error, languageOf(navigator.language) ?? "en");
});
