/**
 * Which net of a model scores balls; null if none does.
 * @param {{ dynamics?: object, success?: object } | undefined} card of the loaded model
 * @returns {import("../text/en/model.js").BallNet | null}
 */
export function ballNetOf(card) {
  return card?.dynamics ? "dynamics" : card?.success ? "success" : null;
}
