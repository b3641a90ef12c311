// The components of all that the first picture of a puzzle does not need, made in the order in which they are opened:
// the maps are asked for first, and what others read comes before them.

import { Choice } from "../panels/choice.js";
import { Compare } from "../panels/compare.js";
import { Forecast } from "../panels/forecast.js";
import { Imagine } from "../panels/imagine.js";
import { ImaginedVsReal } from "../panels/imagined-vs-real.js";
import { ModelPair } from "../panels/model-pair.js";
import { ModelBadge } from "../panels/model-badge.js";
import { Overlays } from "../panels/overlays.js";
import { Predict } from "../panels/predict.js";
import { Probe } from "../panels/probe.js";
import { Proposals } from "../panels/proposals.js";
import { ScenePicture } from "../panels/scene-picture.js";
import { Scoreboard } from "../panels/scoreboard.js";
import { SolveMapPanel } from "../panels/solve-map.js";
import { Presentation } from "../panels/presentation.js";
import { StripPicture } from "../panels/strip-picture.js";
import { Walkthrough } from "../panels/walkthrough.js";
import { AttemptList } from "../play/attempt-list.js";
import { About } from "../panels/about.js";
import { byId } from "../widgets/dom.js";
import { Editor } from "../editor/editor.js";
import { Check } from "../editor/check.js";
import { Luck } from "../attempts/luck.js";
import { Pictures } from "../attempts/pictures.js";
import { Replays } from "../attempts/replays.js";
import { SharePuzzle } from "../editor/share-puzzle.js";

/** @typedef {import("../widgets/component.js").Component} Component */

/**
 * Returns these components, and by name those that the controller itself asks for something.
 * @param {import("./components.js").Parts} parts
 * @param {import("../play/canvas.js").SceneCanvas} canvas
 */
export function createPanelComponents({ root, module, client, progress, preferences, hrefOf }, canvas) {
  const editor = new Editor(root, client);
  const scenePicture = new ScenePicture(root);
  const imagine = new Imagine(root, client, scenePicture);
  const predict = new Predict(root, imagine, scenePicture);
  const proposals = new Proposals(root, client, imagine);
  const [choice, forecast, solveMap] = [
    new Choice(root, client),
    new Forecast(root, client, preferences),
    new SolveMapPanel(root, client, imagine),
  ];
  const walkthrough = new Walkthrough(root, imagine, choice, preferences);
  const presentation = new Presentation(root, walkthrough);
  /** @type {Component[]} */
  const all = [
    new About(root, client),
    scenePicture,
    imagine,
    new AttemptList(root, byId(root, "player-attempts"), byId(root, "player-count"), "player"),
    new AttemptList(root, byId(root, "model-attempts"), byId(root, "model-count"), "model"),
    choice,
    walkthrough,
    presentation,
    new Probe(root, imagine),
    new ImaginedVsReal(root, imagine, scenePicture),
    predict,
    forecast,
    new Compare(root, client),
    proposals,
    solveMap,
    new ModelBadge(root, client, imagine),
    new ModelPair(root, module, client, scenePicture),
    editor,
    new SharePuzzle(root, editor, progress.persistent),
    new Pictures(root),
    new StripPicture(root, imagine, scenePicture),
    new Check(root, client, editor),
    new Luck(root, client),
    new Replays(root, client),
    new Scoreboard(root, client, progress, (task) => hrefOf(task, "compare")),
    new Overlays(root, canvas, { editor, choice, forecast, imagine, predict, proposals, solveMap }),
  ];
  return { all, editor, proposals, presentation };
}
