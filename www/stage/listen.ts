// Turns pointer, wheel and keys into changes of the state. Makes no decisions.

import { goBy, takeNextStep } from "../opening.ts";
import { toggleIntro } from "../core/change/home.ts";
import { openPanel, present } from "../core/change/route.ts";
import { again, stepBy, togglePlaying } from "../core/change/run.ts";
import { go } from "../core/change/walkthrough.ts";
import { introShown } from "../core/derived/home.ts";
import { shownPanel, shownPanels } from "../core/derived/hidden.ts";
import { SCENE_SIZE } from "../pkg/constants.ts";
import { keyAction } from "./keys.ts";
import { toolOf } from "./tools.ts";
import { wheelSteps } from "./wheel.ts";
import type { Point } from "../core/change/placement.ts";
import type { State } from "../core/state.ts";
import type { Store } from "../core/store.ts";
import type { KeyAction } from "./keys.ts";
import type { Stage } from "./stage.ts";

/** Distance within which a pointer grabs the knob, or the middle of a small ball, CSS px. */
const REACH: Record<string, { knob: number; ball: number }> = {
  mouse: { knob: 10, ball: 0 },
  pen: { knob: 14, ball: 10 },
  touch: { knob: 22, ball: 22 },
};

/** Listens until the signal is aborted. `around` is where to listen for keys that are not only for the scene. */
export function listen(stage: Stage, around: Document | ShadowRoot, store: Store<State>, signal: AbortSignal): void {
  const { canvas } = stage;
  const tool = () => toolOf(store.state);
  let keyPresses = 0;
  let wheelRest = 0;

  on(canvas, "pointerdown", (event: PointerEvent) => {
    if (event.button !== 0) return;
    canvas.setPointerCapture(event.pointerId);
    const { knob, ball } = REACH[event.pointerType] ?? REACH.mouse!;
    const reach = { knob: knob / stage.scale, ball: ball / stage.scale };
    stage.isTouched = event.pointerType === "touch";
    store.change(tool().press, event.pointerId, pointOf(event), reach);
  });
  on(canvas, "pointermove", (event: PointerEvent) => store.change(tool().drag, event.pointerId, pointOf(event)));
  on(canvas, "pointerup", (event: PointerEvent) => store.change(tool().release, event.pointerId));
  on(canvas, "pointercancel", (event: PointerEvent) => store.change(tool().cancel, event.pointerId));

  on(canvas, "wheel", (event: WheelEvent) => {
    // The wheel scrolls the page unless the person is handling the ball; with Ctrl it zooms.
    if (!canvas.matches(":focus") || event.ctrlKey || store.state.run || !tool().holds(store.state)) return;
    event.preventDefault();
    const [steps, rest] = wheelSteps(wheelRest, event);
    wheelRest = rest;
    if (steps) store.change(tool().nudge, 0, 0, steps, "wheel");
  });

  on(canvas, "keydown", (event: KeyboardEvent) => {
    // A key that is held down is one gesture.
    if (!event.repeat) keyPresses += 1;
    const changed = tool().key?.(store.state, event, `key ${keyPresses}`);
    if (changed) {
      event.preventDefault();
      return store.change(() => changed);
    }
    const action = keyAction(event);
    if (!action) return;
    if (action.kind === "move") store.change(tool().nudge, action.dx, action.dy, 0, `key ${keyPresses}`);
    else if (action.kind === "resize") store.change(tool().nudge, 0, 0, action.dr, `key ${keyPresses}`);
    else if (action.kind !== "next") return;
    else if (!event.repeat) takeNextStep(store);
    event.preventDefault();
  });

  on(around, "keydown", (event: KeyboardEvent) => {
    const action = keyAction(event);
    if (!action || store.state.dialog || event.defaultPrevented || isTyped(event, action)) return;
    if (act(action, event.repeat)) event.preventDefault();
  });

  function act(action: KeyAction, isRepeated: boolean): boolean {
    // What is behind the show must not change unseen.
    if (introShown(store.state)) {
      const isToggle = action.kind === "toggle";
      if (isToggle && !isRepeated) store.change(toggleIntro);
      return isToggle;
    }
    switch (action.kind) {
      case "undo":
        store.change(tool().undo);
        return true;
      case "redo":
        store.change(tool().redo);
        return true;
      case "stepBy":
        store.change(stepBy, action.steps);
        return store.state.run !== null;
      case "page":
        return turnPage(action.by);
      case "move":
        return action.dx !== 0 && turnPage(Math.sign(action.dx));
      case "toggle":
        if (store.state.run && !isRepeated) store.change(togglePlaying);
        return store.state.run !== null;
      case "again":
        store.change(again);
        return true;
      case "leave": {
        const isPresented = store.state.route.view !== null;
        if (isPresented) store.change(present, null);
        return isPresented;
      }
      case "panel": {
        const panel = shownPanels(store.state)[action.index];
        if (panel) store.change(openPanel, panel);
        return panel !== undefined;
      }
      case "previousPuzzle":
      case "nextPuzzle":
        goBy(store, action.kind === "nextPuzzle" ? 1 : -1);
        return true;
      default:
        return false;
    }
  }

  /** Turns pages in the presentation of the walkthrough; elsewhere the page handles the key. */
  function turnPage(by: number): boolean {
    const turns = store.state.route.view !== null && shownPanel(store.state) === "imagine";
    if (turns) store.change(go, by);
    return turns;
  }

  function pointOf({ clientX, clientY }: PointerEvent): Point {
    const box = canvas.getBoundingClientRect();
    return [((clientX - box.left) / box.width) * SCENE_SIZE, ((box.bottom - clientY) / box.height) * SCENE_SIZE];
  }

  function on(target: EventTarget, type: string, listener: (event: any) => void): void {
    target.addEventListener(type, listener, { signal, passive: false });
  }
}

/** Whether the key is meant for a field or a button. */
function isTyped(event: KeyboardEvent, action: KeyAction): boolean {
  const target = event.composedPath()[0];
  if (!(target instanceof Element)) return false;
  if (target.matches("input:not([type=range], [type=checkbox], [type=radio]), textarea, select")) return true;
  if (action.kind === "move" && target.matches("input")) return true;
  return action.kind === "toggle" && target.matches("button, input, summary, a");
}
