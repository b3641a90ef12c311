// The German words for en/model.js.

import { counted, number, percent } from "./format.js";
import { upper } from "../sentence.js";

/** @type {Record<import("../en/model.js").Chance, string>} */
const CHANCES = {
  none: "klappt fast sicher nicht",
  little: "klappt wohl nicht",
  less: "klappt eher nicht",
  even: "steht auf der Kippe",
  more: "klappt vielleicht",
  good: "klappt wahrscheinlich",
  full: "klappt fast sicher",
};

const NUMBERS = ["keine", "ein", "zwei", "drei", "vier", "fünf", "sechs", "sieben", "acht", "neun"];

const BALL_NETS = {
  dynamics: {
    name: "das Dynamiknetz",
    about:
      "Das letzte, das Dynamiknetz, stellt sich vor, wohin sich das grüne Objekt und die Kugel bewegen würden und wie wahrscheinlich die Kugel das Rätsel löst.",
  },
  success: {
    name: "das Erfolgsnetz",
    about: "Das letzte, das Erfolgsnetz, sagt für jeden Ort, wie wahrscheinlich eine Kugel dort das Rätsel löst.",
  },
};

/**
 * By the code of an error.
 * @type {Record<string, string>}
 */
const FAILURES = {
  no_model: "Dieses Modell gibt es hier nicht.",
  no_weights:
    "Das Modell fehlt hier oder ließ sich nicht laden. Prüf die Verbindung und lade die Seite neu. Spielen kannst du auch ohne Modell.",
  bad_weights:
    "Die Datei des Modells ist beschädigt oder gehört zu einer anderen Version. Lade die Seite neu. Spielen kannst du auch ohne Modell.",
  bad_memory: "Dieses Gedächtnis ist beschädigt oder passt nicht zu diesem Modell.",
};

/** @type {typeof import("../en/model.js").model} */
export const model = {
  chance: (chance, share) => `${CHANCES[chance]} (Chance ${share})`,
  hardlyAny: () => `unter ${percent(0.01)}`,
  nearlyAll: () => `über ${percent(0.99)}`,
  off: (distance) => `Seine Bahn für Grün lag im Schnitt ${number(distance)} px daneben.`,

  map: {
    strongest: (x, y, sides) => `am stärksten bei x ${x}, y ${y}; ${sides}`,
    sides: (left, right) => `${left} Prozent links, ${right} rechts`,
  },

  steps: {
    base: {
      name: "Wenn du nichts tust",
      meaning: "Wohin sich Grün von allein bewegt.",
      how: "Die Grundbahn. Ihr Netz sieht nur die Szene, als fünf Bilder aus 64 × 64 Feldern, eines für jede Farbe. Für jedes Feld sagt es, wie sicher es ist, dass Grün dort vorbeikommt.",
    },
    target: {
      name: "Wohin Grün soll",
      meaning: "Eine Bahn für Grün, die an seinem Ziel endet.",
      how: "Die Zielbahn. Auch ihr Netz sieht nur die Szene. Es hat aus gelösten Rätseln gelernt, welchen Weg Grün dort nahm. Die rote Kugel kennt es noch nicht.",
    },
    action: {
      name: "Was Rot tun muss",
      meaning: "Eine Bahn für die rote Kugel, die Grün dorthin bringt.",
      how: "Die Aktionsbahn. Ihr Netz sieht die Szene, die Grundbahn und die Zielbahn: was passieren würde und was passieren soll. Für den Unterschied muss die rote Kugel sorgen.",
    },
    placement: {
      name: "Wo Rot startet",
      meaning: "Wo die rote Kugel starten sollte.",
      how: "Die Startkarte. Ihr Netz sieht die Szene, die Zielbahn und die Aktionsbahn. Im Fachartikel kommen die Kugeln zuerst dran, die viel von dieser Karte bedecken. Ein Modell mit einem Netz, das Kugeln bewertet, probiert die aussichtsreichste zuerst.",
    },
    success: {
      name: "Wo es klappen würde",
      meaning: "Wo eine rote Kugel das Rätsel wahrscheinlich löst.",
      how: "Diese Karte gibt es im Fachartikel nicht. Sie sagt für Kugeln in acht Größen an jedem Ort, wie wahrscheinlich sie das Rätsel lösen, und zeigt die beste Größe.",
    },
    imagined: {
      name: "Vierzig mögliche Bahnen",
      meaning:
        "Jede Linie ist eine mögliche Bahn von Grün, jede mit einer anderen Kugel. Je kräftiger die Linie, desto besser die Chancen.",
      how: "Das Dynamiknetz hat an Kugeln aller Art gelernt, was sie bewirken. Es sagt für acht Größen an jedem Ort, wie wahrscheinlich eine Kugel das Rätsel löst, und die vielversprechendsten kommen in die Auswahl. Bei jeder davon stellt es sich vor, wohin sich Grün und die Kugel bewegen würden und wie wahrscheinlich das eine Lösung ist. Gezeichnet sind die vierzig aussichtsreichsten. Nichts davon wird simuliert.",
    },
    run: {
      name: "Ausprobieren und vergleichen",
      meaning: "Das Modell lässt seine Lieblingskugel fallen. Stimmt seine Vermutung?",
      how: "Die Kugel läuft im selben Simulator wie deine. Je breiter das Band um eine gepunktete Linie, desto unsicherer war sich das Modell. Wenn die Kugel es nicht schafft, lernt das Modell daraus: Kugeln, die ähnlich starten oder die es sich ganz ähnlich vorgestellt hat, werden unwahrscheinlicher, und die aussichtsreichste der anderen ist als Nächste dran.",
    },
  },

  nets: {
    intro: (paperNets, ballNet) =>
      `Bevor sich etwas bewegt, stellen sich ${inWords(paperNets + (ballNet ? 1 : 0))} kleine Netze nacheinander vor, was kommt${ballNet ? `: ${upper(inWords(paperNets))} zeichnen Karten, und ${BALL_NETS[ballNet].name} bewertet Kugeln` : ""}.`,
    about: (paperNets, ballNet) =>
      `Es hat ${inWords(paperNets + (ballNet ? 1 : 0))} kleine neuronale Netze, jedes eine lange Liste von Zahlen. ${ballNet ? `${upper(inWords(paperNets))} davon` : "Sie"} machen aus Bildern Karten: Hinein geht die Szene zusammen mit dem, was sich die Netze davor vorgestellt haben, und heraus kommt eine Karte, die für jeden Ort sagt, wie wahrscheinlich Grün oder Rot dort vorbeikommt.${ballNet ? ` ${BALL_NETS[ballNet].about}` : ""}`,
    how: {
      dynamics:
        "Das Dynamiknetz macht sie, bevor es sich einzelne Kugeln vorstellt. Es hat an Kugeln aller Art gelernt, was sie bewirken.",
      success:
        "Das Erfolgsnetz macht sie allein aus der Szene. Es hat an Kugeln gelernt, die Rätsel lösten, und an solchen, die es nicht schafften. Die aussichtsreichste Kugel kommt zuerst dran, und Kugeln, die einer schon probierten ähneln, müssen warten.",
    },
  },

  agents: {
    online: "das Modell, wie es hier spielt (es lernt aus seinen Versuchen)",
    dynamics: "dasselbe, ohne aus seinen Versuchen zu lernen",
    success: "das Erfolgsnetz allein",
    paper: "die vier Netze des Fachartikels allein",
    random: "zufällige Kugeln",
  },

  knows: { within: "kennt alle 25 Arten von Rätseln", cross: "kennt 20 der 25 Arten von Rätseln" },
  kinds: { within: "Kennt alle 25 Arten", cross: "Kennt 20 von 25 Arten" },
  seen: "hat dieses Rätsel geübt",
  seenByMaps: "nur seine Karten haben dieses Rätsel geübt",
  unseen: "kennt dieses Rätsel nicht",

  card: {
    samples: {
      term: "Gelernt aus",
      words: (samples, { tasks }) =>
        `${counted(samples, "Lösung", "Lösungen")} von ${counted(tasks, "Rätsel", "Rätseln")}`,
    },
    epochs: { term: "Jede angesehen", words: (epochs) => `${number(epochs)}-mal` },
    setup: {
      term: "Arten von Rätseln",
      words: (setup) =>
        setup === "within"
          ? "dieselben Arten, mit denen es geprüft wird, aber andere Rätsel („within“)"
          : "andere Arten als die, mit denen es geprüft wird („cross“)",
    },
    fold: {
      term: "Aufteilung",
      words: (fold) => `${fold}, eine von zehn Möglichkeiten, die Rätsel zum Lernen von denen zum Prüfen zu trennen`,
    },
    batch: { term: "Beispiele auf einmal", words: (batch) => number(batch) },
    learning_rate: { term: "Lernrate (Adam)", words: (rate) => number(rate, 0, { maximumSignificantDigits: 6 }) },
    decay_epochs: {
      term: "Lernrate sinkt am Ende auf null",
      words: (epochs) => `über ${counted(epochs, "Durchgang", "Durchgänge")}`,
    },
    without_dev: {
      term: "Rätsel zum Einstellen (dev)",
      words: (without) =>
        without ? "ausgelassen, um damit die Einstellungen zu wählen" : "mitgelernt wie die anderen",
    },
    mirror: {
      term: "Gespiegelt",
      words: (mirror) => (mirror ? "jedes zweite Mal, links und rechts vertauscht" : "nie"),
    },
    success: {
      term: "Das Erfolgsnetz lernte aus",
      words: ({ balls, epochs }) => `${counted(balls, "Kugel", "Kugeln")} und ihrem Ergebnis, ${number(epochs)}-mal`,
    },
    dynamics: {
      term: "Das Dynamiknetz lernte aus",
      words: ({ balls, epochs, unlisted, random_scenes: random, random_scenes_alone: alone, from }) =>
        `${counted(balls, "Kugel", "Kugeln")} und ihren Bahnen, in ${counted(epochs, "Durchgang", "Durchgängen")} durch ${alone ? `${number(random)} zufällig erzeugte Rätsel und keine anderen` : "die Rätsel"}${unlisted ? `, von denen ${number(unlisted)} zusätzliche der gleichen Arten sind` : ""}${random && !alone ? `, von denen ${number(random)} zufällig erzeugt sind` : ""}${from ? ", nach einem früheren Training" : ""}`,
    },
    simulator: { term: "Version des Simulators", words: String },
    seed: { term: "Startwert des Zufalls", words: String },
  },

  outcomes: {
    first: "Schon seine erste Idee klappt.",
    counted: (balls, solved, touched, missed) =>
      `Von ${counted(balls, "Kugel", "Kugeln")} ${solved > 1 ? `lösen ${number(solved)}` : solved ? "löst eine" : "löst keine"} das Rätsel, bei ${touched} berührt das grüne Objekt sein Ziel eine Weile, bei ${missed} nie.`,
  },

  results: {
    notLoaded: (why, address) =>
      `Die Ergebnisse ließen sich nicht laden. Prüf die Verbindung und versuch es noch einmal. (${address}: ${why})`,
    damaged: (address) =>
      `Die Ergebnisse sind beschädigt: Was in ${address} steht, ist kein JSON. „pathlight-lab publish results“ schreibt sie neu.`,
  },

  searchEnded: (why) => `Die Suche ist abgebrochen. ${why} Drück den Knopf, um noch einmal zu suchen.`,

  worker: {
    startedAgain: "Das Modell wurde neu gestartet.",
    notStarted: "Das Modell ist noch nicht gestartet.",
    other: "Ein anderes Modell wurde gestartet.",
    stopped: (why) => `Das Modell läuft nicht mehr${why ? ` (${why})` : ""}.`,
    notLoaded: (framed) =>
      `Das Modell ließ sich nicht starten. Falls Pathlight inzwischen aktualisiert wurde, lade die Seite neu. ${
        framed
          ? "Ein iframe mit dem Attribut sandbox muss seine eigene Herkunft erlauben (allow-same-origin)."
          : "Eine Seite mit einer Content Security Policy muss Worker erlauben (worker-src)."
      }`,
    failed: (code, message) => FAILURES[code] ?? `Das hat nicht geklappt. (${message})`,
  },
};

/** @param {number} count */
function inWords(count) {
  return NUMBERS[count] ?? number(count);
}
