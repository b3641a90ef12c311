// Which model plays, and whether it was trained on the puzzle.

import type { Text } from "../text.ts";

export const model: Text["model"] = {
  choose: "Modell",
  names: { within: "Modell A: kennt alle 25 Arten von Rätseln", cross: "Modell B: kennt 20 der 25 Arten" },
  short: { within: "Modell A", cross: "Modell B" },
  practised: "Achtung: Genau dieses Rätsel hat es geübt.",
  unseen: {
    within: "Es kennt diese Art, aber nicht dieses Rätsel.",
    cross: "Diese Art Rätsel hat es nie gesehen.",
    custom: "Dieses Rätsel hat es nie gesehen.",
  },
};
