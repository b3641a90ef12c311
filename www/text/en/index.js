// The English words, by part of the page.

import { attempts } from "./attempts.js";
import { editor } from "./editor.js";
import { element } from "./element.js";
import { format } from "./format.js";
import { home } from "./home.js";
import { kinds } from "./kinds.js";
import { learns } from "./learns.js";
import { model } from "./model.js";
import { offline } from "./offline.js";
import { page } from "./page.js";
import { panels } from "./panels.js";
import { places } from "./places.js";
import { play } from "./play.js";
import { puzzles } from "./puzzles.js";
import { reading } from "./reading.js";
import { results } from "./results.js";
import { sharing } from "./sharing.js";

export const en = {
  attempts,
  editor,
  element,
  format,
  home,
  kinds,
  learns,
  model,
  offline,
  page,
  panels,
  places,
  play,
  puzzles,
  reading,
  results,
  sharing,
};

/** @typedef {typeof en} Catalogue */
