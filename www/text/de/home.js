// The German words for en/home.js.

/** @type {typeof import("../en/home.js").home} */
export const home = {
  title: "Schau zu, wie sich eine winzige KI vorstellt, was passiert. Dann besiege sie.",
  titleWithoutModel: "Such dir ein Rätsel aus",
  goal: `Setz eine rote Kugel so, dass das <b class="role green">grüne</b> Objekt 3 Sekunden lang sein gestreiftes <b class="role blue">blaues</b> oder <b class="role purple">violettes</b> Ziel berührt.`,
  model: "Die KI ist ein kleines Modell. Es läuft in deinem Browser und denkt in einem Wimpernschlag.",
  play: "Spiel gegen sie",
  make: "Bau die Szene um",
  guide: "Zeig mir, wie es geht",
  scene:
    "Das Modell stellt sich viele Bahnen der grünen Kugel vor und wählt eine aus. Dann fällt eine echte rote Kugel, und die grüne rollt auf der vorgestellten Bahn an ihr Ziel.",
  pause: "Pause",
  replay: "Abspielen",

  story: {
    imagine: (futures) => `Das Modell stellt sich ${futures} Bahnen vor …`,
    pick: (chance) => `… und wählt eine: zu ${chance} sicher.`,
    real: "Jetzt fällt die echte Kugel.",
    solved: (off) => `Gelöst! Seine Vermutung lag um ${off} der Breite daneben.`,
    missed: (off) => `Seine Vermutung lag um ${off} der Breite daneben.`,
  },

  picks: {
    label: "Womit du anfangen kannst",
    day: "Rätsel des Tages",
    dayFacts: (day, facts) => `${day}: ${facts}`,
    unsolved: "Das hat das Modell nie gelöst",
    canYou: (facts) => `Schaffst du es? ${facts}`,
    learns: "Schau dem Modell beim Lernen zu",
    learnsFacts: "Zwanzig Rätsel einer Art, die es noch nie gesehen hat",
    make: "Bau dein eigenes Rätsel",
    makeFacts: "Verschieb, was du willst, spiel es und schick es Freunden",
    facts: (puzzle, difficulty) => `${puzzle}, ${difficulty}`,
  },

  kinds: "25 Arten von Rätseln",
  order: "Reihenfolge",
  byNumber: "nach Nummer",
  byDifficulty: "die leichtesten zuerst",
  results: "Wie gut sind die Modelle? Ergebnisse für alle Testrätsel",
};
