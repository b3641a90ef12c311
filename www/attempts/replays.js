// Attempts as files: saves those at the open puzzle, opens files of anybody, simulates each attempt again in the
// worker, says whether the same comes out to the bit, and replays it.

import { Component } from "../widgets/component.js";
import { SIMULATOR_VERSION } from "../shell/constants.js";
import { turnVersions } from "../model/turn-versions.js";
import { createButton, setText } from "../widgets/dom.js";
import { pathlight } from "../shell/page-api.js";
import { sceneName } from "../puzzles/puzzle-name.js";
import { text } from "../text/text.js";
import { MOST_ATTEMPTS, readAttempts, saveAttempts } from "./attempt-file.js";
import { textOfScene } from "../editor/scene-link.js";

/** @typedef {import("../pkg/pathlight.js").AttemptLine} AttemptLine */
/** @typedef {import("../pkg/pathlight.js").Verification} Verification */
/** @typedef {import("../pkg/pathlight.js").Ball} Ball */

/** Attempts that go to the worker at once. */
const BATCH = 50;
/** The most attempts of a file that are listed. */
const LISTED = 500;

export class Replays extends Component {
  #client;
  #input = this.byId("attempts-file", HTMLInputElement);
  /**
   * Runs while the worker is asked.
   * @type {AbortController | null}
   */
  #call = null;
  /** The sentence about the attempts that are listed. They are a file's, not the puzzle's, and stay when it is left. */
  #listWords = "";

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   */
  constructor(root, client) {
    super(root);
    this.#client = client;
    this.byId("attempts-save").addEventListener("click", () => this.#save());
    this.byId("attempts-open").addEventListener("click", () => this.#input.click());
    this.#input.addEventListener("change", () => this.#open());
  }

  /** @param {import("../play/session.js").Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#update());
    this.#update();
  }

  close() {
    super.close();
    this.#call?.abort();
    setText(this.byId("attempts-words"), this.#listWords);
  }

  #save() {
    const { session } = this;
    if (!session) return;
    const { name } = session;
    const made = [
      ...attemptsBy("player", session.attempts.of("player"), {}),
      ...attemptsBy(
        session.attempts.modelName ?? "model",
        session.attempts.of("model"),
        turnVersions(this.#client.loaded),
      ),
    ];
    this.#tell(async (signal) => {
      const balls = made.map(({ ball }) => ball);
      const lines = await this.#client.call("attemptLines", [session.puzzle, balls], signal);
      saveAttempts(
        name,
        lines.map((line, index) => ({ ...line, ...made[index] })),
      );
      return text.attempts.replays.saved(lines.length);
    });
  }

  #open() {
    const [file] = this.#input.files ?? [];
    this.#input.value = "";
    if (!file) return;
    const words = text.attempts.replays;
    this.#tell(async (signal) => {
      const { attempts, left } = await readAttempts(file, {
        signal,
        onProgress: (done) => setText(this.byId("attempts-words"), words.read(Math.floor(100 * done) / 100)),
      });
      if (!signal.aborted) this.#say(words.begun);
      const { done, sentences } = await this.#verify(file.name, attempts, signal);
      if (done > LISTED) sentences.push(words.listed(LISTED));
      if (left > 0) sentences.push(words.left(left, MOST_ATTEMPTS));
      return (this.#listWords = sentences.join(" "));
    });
  }

  /**
   * Simulates attempts again, some at a time, and lists them, until all are done or the person stops it.
   * @param {string} name the file's
   * @param {unknown[]} attempts
   * @param {AbortSignal} signal
   */
  async #verify(name, attempts, signal) {
    this.#listWords = "";
    const list = this.byId("attempts-read");
    const words = text.attempts.replays;
    const stop = new AbortController();
    const last = document.createElement("li");
    last.append(createButton(words.stop, () => stop.abort()));
    list.replaceChildren(last);
    let [done, same] = [0, 0];
    /** @type {string[]} */
    let sentences = [];
    try {
      while (done < attempts.length && !stop.signal.aborted && !signal.aborted) {
        const batch = attempts.slice(done, done + BATCH);
        const verifications = await this.#client.call("verify", [batch], signal);
        const listed = batch.slice(0, Math.max(0, LISTED - done));
        last.before(...listed.map((attempt, index) => this.#item(attempt, verifications[index])));
        same += verifications.filter(({ verdict }) => verdict === "same").length;
        done += batch.length;
        setText(this.byId("attempts-words"), words.simulated(done, attempts.length));
        sentences = [words.result(name, same, done)];
        if (done < attempts.length) sentences.push(words.stopped(attempts.length - done));
        // It stays if the puzzle is left now.
        this.#listWords = sentences.join(" ");
      }
    } catch (error) {
      if (signal.aborted) throw error;
      // Nobody has stopped it.
      sentences = [...sentences.slice(0, 1), /** @type {Error} */ (error).message];
    } finally {
      last.remove();
    }
    return { done, sentences };
  }

  /**
   * Says what the worker is asked for, unless something else is asked for or the puzzle is left meanwhile.
   * @param {(signal: AbortSignal) => Promise<string>} ask
   */
  async #tell(ask) {
    this.#call?.abort();
    const call = (this.#call = new AbortController());
    // A lesson that shows nothing of the model has not started the worker.
    if (!this.#client.alive) this.requestModel();
    try {
      const words = await ask(call.signal);
      if (!call.signal.aborted) this.#say(words);
    } catch (error) {
      if (!call.signal.aborted) this.#say(/** @type {Error} */ (error).message);
    }
  }

  /**
   * @param {unknown} line
   * @param {Verification} verification
   */
  #item(line, verification) {
    const item = document.createElement("li");
    if (verification.verdict === "not_valid") {
      item.textContent = text.attempts.replays.unplayable[verification.fault];
      return item;
    }
    // What was simulated again has the form of an attempt.
    const attempt = /** @type {AttemptLine} */ (line);
    const { task, scene, ball, status, steps } = attempt;
    const puzzle = task ?? sceneName(scene);
    const words = text.attempts.replays;
    const place = ball ? words.ball(...ball) : words.noBall;
    const same = verification.verdict === "same";
    const found = same ? status : verification.status;
    const outcome = !same
      ? otherWords(attempt, verification)
      : found === "invalid"
        ? words.invalid
        : words[found === "solved" ? "solved" : "missed"](steps);
    const sentence = `${puzzle}, ${place}: ${outcome}`;
    item.append(found === "invalid" ? sentence : createButton(sentence, () => this.#replay(attempt)));
    return item;
  }

  /** @param {AttemptLine} attempt */
  async #replay({ task, scene, ball }) {
    // It would cover what runs.
    this.byId("more").hidePopover();
    const packed = scene ? await textOfScene(pathlight.customScene(scene)) : null;
    this.requestState({
      task: packed === null ? (task ?? null) : null,
      scene: packed,
      ball: null,
      proposal: null,
      challenge: null,
      panel: "play",
    });
    if (ball) this.session?.playOpened(ball);
    else this.session?.watch();
  }

  #update() {
    const { session } = this;
    if (!session) return;
    this.byId("attempts-save", HTMLButtonElement).disabled =
      session.attempts.standing("player").used + session.attempts.standing("model").used === 0;
  }

  /** @param {string} words */
  #say(words) {
    setText(this.byId("attempts-words"), words);
    this.announce(words);
  }
}

/**
 * What the lines of attempts tell beside what verifies them.
 * @param {string} by
 * @param {import("../pkg/pathlight.js").Attempt[]} attempts
 * @param {{ agents?: number, weights?: string }} versions of a model
 */
function attemptsBy(by, attempts, { agents, weights }) {
  return attempts.map(({ ball, ending: { longest_touch, final_touch } }) => ({
    ball,
    by,
    longest_touch,
    final_touch,
    agents,
    weights,
  }));
}

/**
 * What came of an attempt instead of what its line says.
 * @param {AttemptLine} said
 * @param {Pick<AttemptLine, "status" | "steps">} found
 */
function otherWords(said, found) {
  const words = text.attempts.replays;
  const version = said.simulator === SIMULATOR_VERSION ? "" : ` ${words.version(said.simulator, SIMULATOR_VERSION)}`;
  const isSame = said.status === found.status && said.steps === found.steps;
  return (isSame ? words.otherPoses : words.otherOutcome(words.outcome(said), words.outcome(found))) + version;
}
