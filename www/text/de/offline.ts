// Eine neue Version der Seite.

import type { offline as english } from "../en/offline.ts";

export const offline: typeof english = {
  available: "Es gibt eine neue Version von Pathlight.",
  load: "Laden",
  later: "Später",
};
