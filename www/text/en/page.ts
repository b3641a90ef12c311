// The page around the scene: header, menu, and messages about errors.

import type { Failure } from "../../core/change/model.ts";
import type { Notice } from "../../core/change/settings.ts";
import { formatsOf } from "../formats.ts";
import { make } from "./make.ts";

const { counted, percent } = formatsOf("en-GB");

const FAILURES: Record<Failure["code"], string> = {
  offline: "No connection. It comes when you are back.",
  unreachable:
    "The server does not answer. Try again in a while; a page’s Content-Security-Policy has to allow it (connect-src).",
  missing: "A file was not found on this server. Whoever runs it has to put all files of Pathlight there.",
  page: "A web page came in place of a file. Does this network ask you to log in first? Else the server answers wrongly.",
  damaged: "A file arrived damaged, or is of another version. Load the page again.",
  forbidden: "This page forbids WebAssembly: its Content-Security-Policy needs 'wasm-unsafe-eval' in script-src.",
  old: "This browser is too old: it needs WebAssembly with SIMD. Update it, or take another.",
  worker:
    "This page forbids workers: its Content-Security-Policy needs worker-src, and a sandboxed frame allow-same-origin.",
  crashed: "It stopped unexpectedly. Load it again.",
  broken: "It could not be started. Load the page again.",
};

export const page = {
  brand: "Pathlight",
  share: "Share",
  present: "Presentation",
  leave: "Leave the presentation",
  previous: "Previous puzzle",
  next: "Next puzzle in the list",
  number: "Number of the puzzle",
  tabs: "Panels",
  menu: "Menu",
  theme: "Theme",
  themes: { light: "Light", dark: "Dark" },
  language: "Language",
  learns: "Watch it learn",
  results: "How good are the models?",
  scene: "puzzle scene",

  loading: (arrived: number) => `The model is loading (${percent(arrived)}). You can play already.`,
  /** Explains a failure and its remedy. */
  failure: (failure: Failure) => FAILURES[failure.code],
  noModel: (failure: Failure) => `You can play on, but the model is not here. ${FAILURES[failure.code]}`,
  retry: "Load it again",
  dismiss: "Close",
  notice: (notice: Notice) => {
    switch (notice.kind) {
      case "no_task":
        return `There is no puzzle ${notice.task}. Numbers go from 00000:000 to 00024:099.`;
      case "unread_link":
        return `This link has a part that Pathlight does not understand: ${notice.parts.join(", ")}.`;
      case "bad_scene":
        return `This link’s puzzle cannot be opened: ${notice.problem ? make.problem(notice.problem) : "a part of the link is missing. Ask for it again."}`;
      case "bad_file":
        return `This file was not opened: ${notice.problem ? make.problem(notice.problem) : "it holds no puzzles of Pathlight."}`;
      case "storage_full":
        return "This browser has no room left: what you play now is forgotten when you leave.";
      case "no_text":
        return "This language could not be loaded. Load the page again.";
      case "no_picture":
        return "This browser could not make the picture.";
      case "opening":
        return `The file is read: ${percent(notice.share)}.`;
      case "opened":
        return (
          `${counted(notice.found, "attempt", "attempts")} in the file, ${notice.added || "none"} of them new here.` +
          (notice.unread ? ` ${counted(notice.unread, "line is", "lines are")} no attempt.` : "")
        );
      case "no_attempts":
        return `${notice.file} is not a file of attempts from Pathlight. Nothing was changed.`;
    }
  },
};
