// Films, which the browser records from a canvas while frames are drawn on it.

/** What films are saved as, best first; browsers record different formats. */
const FORMATS = [
  { type: "video/webm;codecs=vp9", extension: "webm" },
  { type: "video/webm", extension: "webm" },
  { type: "video/mp4", extension: "mp4" },
];
/** Bits of a film per second. */
const BIT_RATE = 4e6;

/** The format of films that this browser records; null if it records none. */
export function filmFormat() {
  return (globalThis.MediaRecorder && FORMATS.find(({ type }) => MediaRecorder.isTypeSupported(type))) ?? null;
}

/**
 * Records a canvas while frames are drawn on it. Returns the film, or null if it was aborted. Rejects if the browser
 * cannot record it, or a frame cannot be drawn.
 * @param {HTMLCanvasElement} canvas
 * @param {string} type
 * @param {AbortSignal} signal
 * @param {(seconds: number) => boolean} drawFrame draws the frame of a time, s; returns whether more follow
 * @returns {Promise<Blob | null>}
 */
export async function recorded(canvas, type, signal, drawFrame) {
  drawFrame(0);
  const stream = canvas.captureStream();
  const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: BIT_RATE });
  /** @type {Blob[]} */
  const parts = [];
  recorder.addEventListener("dataavailable", ({ data }) => parts.push(data));
  /** @type {unknown} */
  let failure = null;
  recorder.addEventListener("error", (event) => (failure = event));
  const stopped = new Promise((resolve) => recorder.addEventListener("stop", resolve));
  recorder.start();
  const begin = performance.now();
  try {
    do await new Promise(requestAnimationFrame);
    while (!signal.aborted && recorder.state === "recording" && drawFrame((performance.now() - begin) / 1000));
  } finally {
    // It has stopped by itself if it has failed.
    if (recorder.state === "recording") recorder.stop();
    for (const track of stream.getTracks()) track.stop();
  }
  await stopped;
  if (failure) throw failure;
  return signal.aborted ? null : new Blob(parts, { type });
}
