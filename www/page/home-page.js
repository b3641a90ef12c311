// The home page: its top, the picks, the kinds of puzzles and the custom ones. It is shown when the state names no
// puzzle.

import { hideParts } from "../widgets/hidden-parts.js";
import { byId } from "../widgets/dom.js";
import { Gallery } from "../widgets/gallery.js";
import { TEMPLATES } from "../puzzles/templates.js";
import { hrefOf, pageViewHref, showsHome } from "../state/links.js";
import { readRecording } from "../home/recording.js";
import { CustomGallery } from "./custom-gallery.js";
import { Picks } from "./picks.js";

/** @typedef {import("../state/url-state.js").State} State */

const section = byId(document, "gallery");
const order = byId(document, "gallery-order", HTMLSelectElement);

export class HomePage {
  gallery = new Gallery(byId(document, "templates"), TEMPLATES);
  #picks;
  #customGallery;
  #hero;

  /**
   * @param {import("../home/hero.js").Hero} hero
   * @param {import("../storage/progress.js").Progress} progress
   * @param {(scene: string) => void} openScene shows the custom puzzle of a link's text
   */
  constructor(hero, progress, openScene) {
    this.#hero = hero;
    this.#picks = new Picks(TEMPLATES, progress.player);
    this.#customGallery = new CustomGallery(progress, openScene);
    order.addEventListener("change", () => this.#orderKinds());
    byId(document, "catalogue").hidden = false;
    byId(document, "guide-start", HTMLButtonElement).disabled = false;
  }

  /** @param {FocusOptions} options */
  focus(options) {
    byId(document, "gallery-title").focus(options);
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    this.gallery.setTheme(dark);
    this.#customGallery.setTheme(dark);
    this.#picks.setTheme(dark);
  }

  /** @param {State} state */
  show(state) {
    section.hidden = !showsHome(state);
  }

  /**
   * Takes into its links what the state says of them.
   * @param {State} state
   */
  setState(state) {
    this.#hero.setState(state);
    this.gallery.setState(state);
    this.#customGallery.setState(state);
    const results = pageViewHref("results", state);
    const link = byId(document, "results-link", HTMLAnchorElement);
    link.hidden = results === null;
    link.href = results ?? "#";
    for (const back of document.querySelectorAll("a.back")) back.setAttribute("href", hrefOf(state, null) ?? "#");
    if (section.hidden) return;
    this.#orderKinds();
    this.#picks.update(state);
    // Without the recording, everything else is there.
    readRecording().then(
      ({ kinds, unsolved }) => {
        this.gallery.setPaths(kinds);
        this.#picks.setUnsolved(unsolved);
        this.#picks.update(state);
        hideParts(document, state.hide);
      },
      () => {},
    );
  }

  #orderKinds() {
    this.gallery.show(order.value === "difficulty" ? "difficulty" : "number");
  }
}
