// Predicting where the green object goes.

import { formatsOf } from "../formats.ts";

const { percent } = formatsOf("en-GB");

export const predict = {
  tab: "Predict",
  intro:
    "Which way will green go? Draw its path, then let it run: were you closer, or the model? Without a ball, or with one that you place first.",
  keys: "By keys: arrows in the scene draw on from green, with Shift further.",
  draw: "Start at green, and draw the way it will go.",
  drawn: "Done? Let it run.",
  wipe: "Wipe the line",
  noBall: "Take the ball away",
  result: (you: number, model: number | null) => {
    const [mine, its] = [percent(you), model === null ? null : percent(model)];
    if (model === null) return `You were ${mine} right.`;
    if (mine === its) return `A draw: both were ${mine} right.`;
    return you > model ? `You were closer: ${mine}, the model ${its}.` : `The model was closer: ${its}, you ${mine}.`;
  },
  measured: "100%: exactly the real path of green. 0%: nothing of it.",
};
