// The page round the scene: header, menu, and what is said when something goes wrong.

import type { Failure } from "../../core/change/model.ts";
import type { Notice } from "../../core/change/settings.ts";
import { formatsOf } from "../formats.ts";
import { make } from "./make.ts";

const { counted, percent } = formatsOf("en-GB");

const FAILURES: Record<Failure["code"], string> = {
  offline: "No connection. You can play on; the model comes when you are back.",
  missing: "The model’s files were not found on this server. You can play on alone.",
  damaged: "The model’s file arrived damaged. You can play on alone.",
  crashed: "The model stopped unexpectedly. You can play on alone.",
  broken: "The model could not be started. You can play on alone.",
};

export const page = {
  brand: "Pathlight",
  skip: "Skip to the scene",
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
  failure: (failure: Failure) => FAILURES[failure.code],
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
      case "file_read":
        return (
          `${counted(notice.attempts, "ball is", "balls are")} new here.` +
          (notice.unread ? ` ${counted(notice.unread, "line", "lines")} without a valid attempt were left out.` : "")
        );
      case "file_unread":
        return `${notice.name} holds no attempts. Choose a file that Pathlight has saved.`;
    }
  },
};
