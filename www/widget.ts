// The puzzle as a notebook widget, using anywidget. pathlight_phyre/widget.py of the Python package is the other half.
//
// A notebook runs this file from a blob and has no server, so the element's files also come from Python, as bytes in a
// message, once for all widgets of a page.

import "./element.ts";
import type { PathlightPuzzle, PathlightPuzzleEventMap } from "./element.ts";

/** The interface of anywidget: the traits of the widget, and messages to and from it. */
interface Model {
  get(trait: "task"): string;
  get(trait: "ball"): number[] | null;
  get(trait: "panel"): string;
  get(trait: "attempts"): object[];
  set(trait: string, value: unknown): void;
  save_changes(): void;
  on(event: string, listener: (...args: never[]) => void): void;
  off(event: string, listener: (...args: never[]) => void): void;
  send(message: object): void;
}

type Received = (message: { files?: string[] }, bytes: DataView<ArrayBuffer>[]) => void;

/** Not the class of this module: each widget loads its own module, and the first of them defined the element. */
const Puzzle = customElements.get("pathlight-puzzle") as typeof PathlightPuzzle;

async function loadFiles(model: Model): Promise<void> {
  if (Puzzle.base !== null) return;
  const [names, bytes] = await new Promise<[string[], DataView<ArrayBuffer>[]]>((resolve) => {
    const onMessage: Received = ({ files }, bytes) => {
      if (!files) return;
      model.off("msg:custom", onMessage);
      resolve([files, bytes]);
    };
    model.on("msg:custom", onMessage);
    model.send({ wants: "files" });
  });
  // Another widget may have been faster.
  if (Puzzle.base !== null) return;
  const addresses = new Map(names.map((name, index) => [name, addressOf(name, bytes[index]!)]));
  Puzzle.base = (path) => addresses.get(path) ?? path;
}

function addressOf(name: string, bytes: DataView<ArrayBuffer>): string {
  const types = { js: "text/javascript", wasm: "application/wasm" } as Record<string, string>;
  return URL.createObjectURL(new Blob([bytes], { type: types[name.split(".").at(-1)!] ?? "application/octet-stream" }));
}

async function render({ model, el }: { model: Model; el: HTMLElement }): Promise<() => void> {
  await loadFiles(model);
  const puzzle = document.createElement("pathlight-puzzle") as PathlightPuzzle;
  // Keys go to the puzzle here, not to JupyterLab's shortcuts.
  puzzle.dataset.lmSuppressShortcuts = "true";
  const show = () => {
    puzzle.task = model.get("task");
    puzzle.panel = model.get("panel");
    puzzle.ball = model.get("ball")?.join(",") ?? null;
  };
  show();
  // Python names a task, which a changed puzzle is not.
  puzzle.hide = "make";
  puzzle.theme = { true: "light", false: "dark" }[document.body.dataset.jpThemeLight ?? ""] ?? null;
  puzzle.addEventListener("statechange", ({ detail }) => {
    model.set("task", detail.task);
    model.set("panel", detail.panel ?? "play");
    model.set("ball", detail.ball?.split(",").map(Number) ?? null);
    model.save_changes();
  });
  puzzle.addEventListener("attempt", ({ detail }: PathlightPuzzleEventMap["attempt"]) => {
    const { task, ball, solved } = detail;
    model.set("attempts", [...model.get("attempts"), { task, ball, solved }]);
    model.save_changes();
  });
  const events = ["change:task", "change:panel", "change:ball"];
  for (const event of events) model.on(event, show);
  el.append(puzzle);
  return () => {
    for (const event of events) model.off(event, show);
  };
}

export default { render };
