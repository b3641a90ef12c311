// What `home/` says, and the rest of the home page: its top, the picks and the grid of kinds.

export const home = {
  title: "Watch a tiny AI imagine what happens. Then beat it.",
  /** For who came by a link that hides the model. */
  titleWithoutModel: "Pick a puzzle",
  goal: `Place one red ball so that the <b class="role green">green</b> object touches its striped <b class="role blue">blue</b> or <b class="role purple">purple</b> goal for 3 seconds.`,
  model: "The AI is a small model. It runs in your browser and thinks in the blink of an eye.",
  play: "Play against it",
  make: "Drag the scene",
  guide: "Show me how it works",
  scene:
    "The model imagines many futures of the green ball and picks one. Then a real red ball drops, and the green ball rolls along the imagined path onto its goal.",
  pause: "Pause",
  replay: "Play",

  /** What the moving scene shows. */
  story: {
    imagine: (/** @type {number} */ futures) => `It imagines ${futures} futures…`,
    pick: (/** @type {string} */ chance) => `…and picks one: ${chance} sure.`,
    real: "Now the real ball drops.",
    solved: (/** @type {string} */ off) => `Solved! Its guess was off by ${off} of the width.`,
    missed: (/** @type {string} */ off) => `Its guess was off by ${off} of the width.`,
  },

  picks: {
    label: "Where to begin",
    day: "Puzzle of the day",
    dayFacts: (/** @type {string} */ day, /** @type {string} */ facts) => `${day}: ${facts}`,
    unsolved: "The model never solved this",
    canYou: (/** @type {string} */ facts) => `Can you? ${facts}`,
    learns: "Watch it learn",
    learnsFacts: "Twenty puzzles of a kind it has never seen",
    make: "Make your own",
    makeFacts: "Drag things around, play it, send it to a friend",
    facts: (/** @type {string} */ puzzle, /** @type {string} */ difficulty) => `${puzzle}, ${difficulty}`,
  },

  kinds: "25 kinds of puzzles",
  order: "Order",
  byNumber: "by number",
  byDifficulty: "the easiest first",
  results: "How good are the models? Results on all test puzzles",
};
