// A new version of the page. These texts are bundled with offline/updates.ts alone.

import type { offline as english } from "../en/offline.ts";

export const offline: typeof english = {
  available: "Es gibt eine neue Version von Pathlight.",
  load: "Laden",
  later: "Später",
};
