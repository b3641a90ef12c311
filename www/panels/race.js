// The race: the model's turn, with what it remembers or without, and how both stand. Nothing of the model's result is
// told before it has run.

import { Component } from "../widgets/component.js";
import { ATTEMPT_LIMIT } from "../shell/constants.js";
import { text } from "../text/text.js";
import { setText } from "../widgets/dom.js";
import { ModelShow } from "./model-show.js";
import { TroubleBox } from "./trouble-box.js";
import { verdictWords } from "../play/verdict.js";
import { showSource } from "./ball-source.js";

/** @typedef {import("../play/session.js").Session} Session */

export class Race extends Component {
  #client;
  #memory;
  #hrefOf;
  #turnButton = this.byId("model-turn", HTMLButtonElement);
  #raceButton = this.byId("race-it", HTMLButtonElement);
  #trouble = new TroubleBox(this.byId("compare-trouble"));
  /**
   * The turn that the model is playing.
   * @type {AbortController | null}
   */
  #turn = null;
  /**
   * Shows that turn.
   * @type {ModelShow | null}
   */
  #show = null;
  /**
   * The earlier puzzle that led to the ball that solved.
   * @type {import("../model/model-memory.js").Source | null}
   */
  #source = null;
  /** @type {string | null} */
  #callFailure = null;
  /** Did the button of the race have the focus when it was disabled? */
  #hadFocus = false;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   * @param {import("../model/model-memory.js").ModelMemory} memory
   * @param {(task: string) => string | null} hrefOf the address of another puzzle, or null
   */
  constructor(root, client, memory, hrefOf) {
    super(root);
    this.#client = client;
    this.#memory = memory;
    this.#hrefOf = hrefOf;
    this.#turnButton.addEventListener("click", () => (this.#turn ? this.#stopTurn() : this.#playTurn()));
    this.#raceButton.addEventListener("click", ({ detail }) => {
      // The second click of a double click must not stop what the first has started.
      if (detail < 2) this.#race();
    });
    this.byId("model-skip").addEventListener("click", () => this.#show?.skip());
    this.byId("clear-attempts").addEventListener("click", () => {
      this.#stopTurn();
      this.session?.clearAllAttempts();
    });
    client.addEventListener("change", () => this.#onClientChange());
    memory.addEventListener("switch", () => this.#stopTurn());
  }

  /** @param {Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#update());
    this.#update();
  }

  close() {
    super.close();
    this.#endTurn();
    this.#callFailure = null;
  }

  /** Ends the turn that is being played; the worker's late attempts are dropped. */
  #stopTurn() {
    this.#endTurn();
    this.#update();
  }

  #endTurn() {
    this.#source = null;
    this.#turn?.abort();
    this.#turn = null;
    this.#show?.stop();
    this.#show = null;
  }

  /** The button in Play: the model plays, stops, or both are run again. */
  #race() {
    if (this.#turn) this.#stopTurn();
    else if (this.#over) this.session?.compare(true);
    else this.#playTurn();
  }

  /** Has the model played its whole turn? */
  get #over() {
    const model = this.session?.attempts.standing("model");
    return model !== undefined && (model.solved_at !== null || model.used === ATTEMPT_LIMIT);
  }

  async #playTurn() {
    const { session } = this;
    const { loaded } = this.#client;
    if (!session || !loaded) return;
    const remembers = this.#memory.on;
    const name = remembers ? null : loaded.name;
    const turn = (this.#turn = new AbortController());
    const show = (this.#show = new ModelShow(session, (attempt) => session.attempts.add(attempt, name)));
    this.#callFailure = null;
    this.#update();
    try {
      const shown = show.run();
      const played = remembers
        ? this.#memory.play(session, turn.signal, (attempt, source) => {
            this.#source = source;
            show.add(attempt);
          })
        : this.#client.call("turn", [session.puzzle], turn.signal, (attempt) => show.add(attempt));
      await Promise.all([played.finally(() => show.end()), shown]);
      if (turn.signal.aborted) return;
      // Neither a replay that is being watched nor what the person does meanwhile is interrupted.
      const free = !show.interrupted && !session.playback.playing && !session.shown?.preview;
      if (show.solution) session.attempts.add(show.solution, name, free);
      if (free) this.#showResult(session, show.solution !== null);
    } catch (error) {
      if (!turn.signal.aborted) this.#callFailure = /** @type {Error} */ (error).message;
    } finally {
      if (this.#turn === turn) {
        this.#turn = null;
        this.#show = null;
        this.#update();
      }
    }
  }

  /**
   * Shows the model's best attempt: over the player's, if there is one.
   * @param {Session} session
   * @param {boolean} fresh is it a solution that has not been shown?
   */
  #showResult(session, fresh) {
    const { used, solved_at: solvedAt } = session.attempts.standing("model");
    if (session.attempts.standing("player").used > 0 || used === 0) session.compare(true, fresh);
    else session.replay("model", solvedAt ?? used, fresh);
  }

  #onClientChange() {
    // Another model is being loaded: a turn of the old one ends.
    if (this.#client.status !== "ready") {
      this.#endTurn();
      this.#callFailure = null;
    }
    this.#update();
  }

  #update() {
    this.#trouble.update(this.#client, this.#callFailure, {
      restartModel: () => this.requestModel(),
      repeatCall: () => this.#playTurn(),
    });
    if (!this.session) return;
    const words = text.panels.compare;
    const { attempts } = this.session;
    const [player, model] = [attempts.playerTotal, attempts.standing("model")];
    const over = this.#over;
    this.setDisabled(this.#turnButton, this.#client.status !== "ready" || over);
    setText(this.#turnButton, this.#turn ? words.stop : over ? words.played : words.play);
    this.setHidden(this.byId("model-skip"), !this.#show);
    this.byId("clear-attempts", HTMLButtonElement).disabled = player.used + model.used === 0;
    this.#updateRace(player, model, this.#turn !== null || this.session.hiddenAuthor === "model");
  }

  /**
   * @param {import("../pkg/pathlight.js").Standing} player
   * @param {import("../pkg/pathlight.js").Standing} model
   * @param {boolean} racing
   */
  #updateRace(player, model, racing) {
    const words = text.panels.compare;
    const running = this.session?.hiddenAuthor === "player";
    setText(this.byId("race-player"), running ? words.trying : standingWords(player, words.notYet));
    setText(this.byId("race-model"), racing ? words.trying : standingWords(model, "?"));
    const told = model.used > 0 && !racing && !running;
    setText(this.byId("race-verdict"), told ? verdictWords(player, model) : player.used === 0 ? words.first : "");
    const start = this.#over && !racing ? words.again : text.play.panel.raceIt;
    setText(this.#raceButton, this.#turn ? words.stopRace : start);
    const line = this.byId("race-source");
    // Together with the result, which has just been announced.
    const isTold = this.#memory.on && model.solved_at !== null && !racing;
    if (showSource(line, isTold ? this.#source : null, this.#hrefOf))
      this.announce(`${this.byId("status").textContent} ${line.textContent}`);
    this.#enableRace(
      this.#client.status === "ready" && player.used > 0 && !running && !(racing && this.#turn === null),
    );
    this.#raceButton.classList.toggle("primary", player.solved_at !== null && !this.#over);
  }

  /**
   * Lets the race be started, or not. The button has its focus again after that, unless something else has got it.
   * @param {boolean} enabled
   */
  #enableRace(enabled) {
    const button = this.#raceButton;
    if (!enabled && button.matches(":focus")) this.#hadFocus = true;
    button.disabled = !enabled;
    if (!enabled || !this.#hadFocus) return;
    this.#hadFocus = false;
    if (document.activeElement?.localName === "body") button.focus({ preventScroll: true });
  }
}

/**
 * @param {import("../pkg/pathlight.js").Standing} standing
 * @param {string} none what is said of no attempt
 */
function standingWords({ used, solved_at: solvedAt }, none) {
  if (used === 0) return none;
  return solvedAt === null ? text.panels.compare.missed(used) : text.panels.compare.solved(solvedAt);
}
