// The Predict panel: the person draws the path that they expect the green object to take, runs, and is compared with
// the net, both against the real path. Without a ball the net's prediction is its base path, with the ball its target
// path. The canvas of the scene passes pointer and keys on while this panel is shown.

import { Component } from "../widgets/component.js";
import { SCENE_SIZE } from "../shell/constants.js";
import { ARROW_KEYS } from "../play/gestures.js";
import { text } from "../text/text.js";
import { OverlapCard } from "./overlap-card.js";

/** @typedef {import("../play/canvas.js").Point} Point */
/** @typedef {import("../play/session.js").Session} Session */

/** The shortest segment of a line worth keeping, px. */
const MIN_SEGMENT = 2;
/** The most points of a line: more than a day of drawing needs. */
const MAX_POINTS = 4000;
/** How far an arrow key draws, without and with Shift, px. */
const KEY_STEP = 6;
const LARGE_KEY_STEP = 24;
/** What is left below the verdict in a low panel, px. */
const MARGIN = 8;

export class Predict extends Component {
  /**
   * The line that is drawn, px.
   * @type {Point[]}
   */
  #sketch = [];
  #imagine;
  #visible = false;
  #playerCard;
  #modelCard;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("./imagine.js").Imagine} imagine
   * @param {import("./scene-picture.js").ScenePicture} scenePicture
   */
  constructor(root, imagine, scenePicture) {
    super(root);
    this.#imagine = imagine;
    this.#playerCard = new OverlapCard(this.fromTemplate("overlap-card"), scenePicture);
    this.#modelCard = new OverlapCard(this.fromTemplate("overlap-card"), scenePicture);
    this.byId("predict-cards").append(this.#playerCard.element, this.#modelCard.element);
    this.byId("predict-watch").addEventListener("click", () => this.session?.watch());
    this.byId("predict-run").addEventListener("click", () => {
      this.session?.reset();
      this.session?.run();
    });
    this.byId("predict-wipe").addEventListener("click", () => this.#setSketch([]));
    imagine.addEventListener("maps", () => this.#update());
  }

  /** @param {Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#update());
    this.#update();
  }

  close() {
    super.close();
    this.#setSketch([]);
  }

  /** @param {import("../state/view.js").View} view */
  setState({ panel }) {
    this.#visible = panel === "predict";
  }

  /** @returns {{ sketch: Point[], pen: import("../play/gestures.js").Pen } | null} */
  get overlay() {
    return this.#visible ? { sketch: this.#sketch, pen: this } : null;
  }

  /** @param {boolean} dark */
  setTheme(dark) {
    super.setTheme(dark);
    this.#update();
  }

  /**
   * A pointer goes down: a new line begins.
   * @param {Point} point
   */
  begin(point) {
    this.#leaveRun();
    this.#setSketch([inside(point)]);
  }

  /**
   * The pointer moves. The line may have been wiped meanwhile; then it begins here.
   * @param {Point} point
   */
  draw(point) {
    const next = inside(point);
    const last = this.#sketch.at(-1);
    if (!last) this.#setSketch([next]);
    else if (Math.hypot(next[0] - last[0], next[1] - last[1]) >= MIN_SEGMENT && this.#sketch.length < MAX_POINTS)
      this.#setSketch([...this.#sketch, next]);
  }

  /**
   * A key in the scene: arrows extend the line, or begin it at the green object; Backspace shortens it. Returns whether
   * it was one of these.
   * @param {KeyboardEvent} event
   */
  onKeydown({ key, shiftKey }) {
    const direction = ARROW_KEYS[key];
    if (!this.session || (!direction && key !== "Backspace")) return false;
    this.#leaveRun();
    if (direction) {
      const [startX, startY] = this.session.game.objectStart();
      const [x, y] = this.#sketch.at(-1) ?? [startX, startY];
      const line = this.#sketch.length ? this.#sketch : [/** @type {Point} */ ([x, y])];
      const distance = shiftKey ? LARGE_KEY_STEP : KEY_STEP;
      this.#setSketch([...line, inside([x + direction[0] * distance, y + direction[1] * distance])]);
    } else {
      this.#setSketch(this.#sketch.slice(0, -1));
    }
    return true;
  }

  /** A prediction is about what comes: a run that is shown is left. */
  #leaveRun() {
    if (this.session && !this.session.placing) this.session.reset();
  }

  /** @param {Point[]} line */
  #setSketch(line) {
    this.#sketch = line;
    if (this.session) this.session.sketched = line.length > 0;
    this.#update();
    this.changeOverlay();
  }

  #update() {
    const session = this.session;
    if (!session) return;
    const end = this.#sketch.at(-1);
    this.byId("predict-watch", HTMLButtonElement).disabled = !end;
    this.byId("predict-run", HTMLButtonElement).disabled = !end || !session.ball || session.invalidReason !== null;
    this.byId("predict-wipe", HTMLButtonElement).disabled = !end;
    const measurable = session.phase === "watch" || session.shown?.author === "player";
    const measured = Boolean(end) && session.finished && measurable && !session.placing;
    const result = this.byId("predict-result");
    const isNew = measured && result.hidden;
    result.hidden = !measured;
    const words = measured
      ? this.#measure(session)
      : end
        ? text.panels.predict.ends(...end)
        : text.panels.predict.nothing;
    const line = this.byId("predict-words");
    if (line.textContent !== words) {
      line.textContent = words;
      if (this.#visible) this.announce(words);
    }
    // Who was closer is in sight, however low the panel is.
    const panel = this.byId("tabpanel-imagine");
    if (isNew) panel.scrollTop = line.offsetTop + line.offsetHeight + MARGIN - panel.clientHeight;
  }

  /**
   * Measures both lines against the real path and says who was closer.
   * @param {Session} session
   */
  #measure({ game, phase }) {
    const words = text.panels.predict;
    const mapName = phase === "watch" ? "base" : "target";
    const real = game.pathMasks()[0].object;
    const modelMap = this.#imagine.maps?.[mapName];
    const shared = { mapName: /** @type {import("../pkg/pathlight.js").MapName} */ (mapName), real, dark: this.dark };
    const player = this.#playerCard.draw({
      ...shared,
      name: words.you,
      values: game.sketchMask(new Float64Array(this.#sketch.flat())),
    });
    this.#modelCard.element.hidden = !modelMap;
    if (!modelMap) return words.alone(text.format.percent(player));
    const model = this.#modelCard.draw({ ...shared, name: words.model, values: modelMap });
    const [you, it] = [text.format.percent(player), text.format.percent(model)];
    this.#playerCard.element.classList.toggle("closer", you !== it && player > model);
    this.#modelCard.element.classList.toggle("closer", you !== it && model > player);
    if (you === it) return words.draw(you);
    return player > model ? words.player(you, it) : words.modelCloser(you, it);
  }
}

/**
 * @param {Point} point
 * @returns {Point}
 */
function inside([x, y]) {
  return [Math.min(Math.max(x, 0), SCENE_SIZE), Math.min(Math.max(y, 0), SCENE_SIZE)];
}

/** @type {import("./panel-module.js").PanelModule} */
export const PREDICT = {
  markup() {
    const words = text.panels.predict;
    return `
<p>${words.intro}</p>
<p class="actions">
  <button type="button" id="predict-watch" class="primary">${words.watch}</button>
  <button type="button" id="predict-run">${words.run}</button>
  <button type="button" id="predict-wipe">${words.wipe}</button>
</p>
<p id="predict-words"></p>
<section id="predict-result" aria-label="${words.result}" hidden>
  <ul class="overlap-cards" id="predict-cards"></ul>
  <details><summary>${words.measured}</summary><p>${words.measuredHow}</p></details>
</section>
<p class="hint">${words.hint}</p>
`;
  },
  create: ({ root, imagine, scenePicture }) => [new Predict(root, imagine, scenePicture)],
};
