// The messages between the page and its worker, as types. There is no code in this file.
//
// The page sends a Request, and the worker answers it by any number of updates (`progress`, `attempt`, `map`) and then
// by one `value` or one `error`. A Cancel ends a request that is still running; nobody waits for its answer.

/** @typedef {import("../pkg/pathlight.js").Attempt} Attempt */
/** @typedef {import("../pkg/pathlight.js").Ball} Ball */
/** @typedef {import("../pkg/pathlight.js").ImaginedBall} ImaginedBall */
/** @typedef {import("../pkg/pathlight.js").Proposal} Proposal */
/** @typedef {import("../pkg/pathlight.js").Played} Played */

/**
 * The model in the worker: its name, the names of all models there are, and how it was trained.
 * @typedef {{ name: string, names: string[], card: import("../pkg/pathlight.js").ModelCard }} LoadedModel
 */

/**
 * What the nets imagine of a scene. `seen`: was the model trained on it?
 * @typedef {{ maps: import("../pkg/pathlight.js").Maps, seen: boolean, milliseconds: number }} Imagined
 */

/**
 * A part of a map of all solutions: an outcome for each cell, and the fraction of the cells that has been tried.
 * @typedef {{ outcomes: Uint8Array, progress: number }} SolveMapUpdate
 */

/**
 * The balls that the model considers, and the one of them that it tries first.
 * @typedef {{ candidates: import("../pkg/pathlight.js").Candidate[], chosen: Proposal }} Considered
 */

/**
 * A scene that ran without a ball: where the green object was, x, y, x, y, … in px, every few steps and at the end, and
 * whether it solved itself.
 * @typedef {{ path: Float32Array, solved: boolean }} Watched
 */

/** @typedef {import("../pkg/pathlight.js").FoundSolutions} FoundSolutions */
/** @typedef {import("../pkg/pathlight.js").AttemptLine} AttemptLine */
/** @typedef {import("../pkg/pathlight.js").Verification} Verification */

/**
 * The calls of the worker: their arguments and their values. `start` takes the compiled wasm; `load` the name of
 * weights in assets/model.json (null: the first); `propose` returns the balls of a turn with what becomes of each;
 * `imagineBall` and `consider` return null if the weights have no dynamics net; `turn` tries them in order; `watch`
 * runs the scene without a ball; `search` looks for solutions, `luck` tries the balls beside one; `attemptLines`
 * simulates balls with their digests, `verify` simulates such lines again; `solve` maps where a ball of a radius (px)
 * solves.
 * @typedef {object} Calls
 * @property {{ args: { module: WebAssembly.Module }, value: void }} start
 * @property {{ args: { name: string | null }, value: LoadedModel }} load
 * @property {{ args: { played: Played }, value: Imagined }} imagine
 * @property {{ args: { played: Played, ball: Ball }, value: ImaginedBall | null }} imagineBall
 * @property {{ args: { played: Played, seed: number }, value: Considered | null }} consider
 * @property {{ args: { played: Played, seed: number }, value: import("../pkg/pathlight.js").TriedProposal[] }} propose
 * @property {{ args: { played: Played, seed: number }, value: void }} turn
 * @property {{ args: { played: Played }, value: Watched }} watch
 * @property {{ args: { played: Played }, value: void }} search
 * @property {{ args: { played: Played, ball: Ball }, value: import("../pkg/pathlight.js").Luck }} luck
 * @property {{ args: { played: Played, balls: Ball[] }, value: AttemptLine[] }} attemptLines
 * @property {{ args: { lines: unknown[] }, value: Verification[] }} verify
 * @property {{ args: { played: Played, radius: number }, value: void }} solve
 */

/**
 * What a running request sends before its answer: the fraction of the weights that has arrived (null if unknown), an
 * attempt, a map, or what a search has found.
 * @typedef {{ progress?: number | null, attempt?: Attempt, map?: SolveMapUpdate, found?: FoundSolutions }} Update
 */

/**
 * An error for the person. Codes that the page knows: "no_model" (no model of this name), "crashed" (the wasm trapped,
 * so the worker must not be used again). Others come from the wasm exports and are only shown.
 * @typedef {{ code: string, message: string }} Failure
 */

/** @typedef {{ id: number, call: keyof Calls, args: any }} Request */
/** @typedef {{ cancel: number }} Cancel */
/** @typedef {{ id: number, value?: any, error?: Failure, update?: Update }} Response */

export {};
