// The components of all that the first picture of a puzzle does not need, made in the order in which they are opened:
// the maps are asked for first, and what others read comes before them.

import { About } from "../panels/about.js";
import { COMPARE } from "../panels/compare-panel.js";
import { Forecast } from "../panels/forecast.js";
import { Imagine } from "../panels/imagine.js";
import { IMAGINE } from "../panels/imagine-panel.js";
import { ModelChoice } from "../panels/model-choice.js";
import { Overlays } from "../panels/overlays.js";
import { PREDICT } from "../panels/predict.js";
import { Presentation } from "../panels/presentation.js";
import { Proposals } from "../panels/proposals.js";
import { ScenePicture } from "../panels/scene-picture.js";
import { MAP } from "../panels/solve-map.js";
import { Editor } from "../editor/editor.js";
import { MAKE } from "../editor/make-panel.js";
import { Luck } from "../attempts/luck.js";
import { Replays } from "../attempts/replays.js";
import { pauseIfLong } from "../loading/next-task.js";
import { byId } from "../widgets/dom.js";
import { fragmentOf } from "./markup.js";

/** The modules of the panels. Play has none: it is there from the first picture on. */
const MODULES = { imagine: IMAGINE, compare: COMPARE, predict: PREDICT, map: MAP, make: MAKE };

/**
 * Fills the panels, and returns their components, and by name those that the controller itself asks for something.
 * @param {import("./components.js").Parts} parts
 * @param {import("../play/canvas.js").SceneCanvas} canvas
 */
export async function createPanelComponents(parts, canvas) {
  const { root, client, preferences } = parts;
  for (const [name, { markup }] of Object.entries(MODULES)) {
    byId(root, name).append(fragmentOf(markup()));
    await pauseIfLong();
  }
  const scenePicture = new ScenePicture(root);
  const imagine = new Imagine(root, client, scenePicture);
  const all = [
    new About(root, client),
    scenePicture,
    imagine,
    ...Object.values(MODULES).flatMap(({ create }) => create({ ...parts, imagine, scenePicture })),
    new ModelChoice(root, client),
    new Forecast(root, client, preferences),
    new Luck(root, client),
    new Replays(root, client),
  ];
  /** @type {<Type>(type: new (...args: any[]) => Type) => Type} */
  const one = (type) => /** @type {any} */ (all.find((component) => component instanceof type));
  return {
    all: [...all, new Overlays(root, canvas, all)],
    editor: one(Editor),
    proposals: one(Proposals),
    presentation: one(Presentation),
  };
}
