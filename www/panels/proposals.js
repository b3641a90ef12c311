// The model's proposals, one by one, whether it has tried them or not: the outcome of each, what the model imagined for
// it, and where it comes from. The one that is looked at is shown at its end at once, with its paths, imagined and
// real, over the scene and the balls before it marked. Its number is in the address.

import { Component } from "../widgets/component.js";
import { ATTEMPT_LIMIT } from "../shell/constants.js";
import { setText } from "../widgets/dom.js";
import { BallImaginer } from "../model/ball-imaginer.js";
import { otherOutcome, outcomesWords } from "../model/outcomes.js";
import { saveBalls } from "../model/save-balls.js";
import { sameBall } from "../puzzles/ball.js";
import { text } from "../text/text.js";
import { imaginedWords, outcomeWords } from "./proposal-facts.js";
import { originWords, sourceOf } from "./proposal-origin.js";
import { TroubleBox } from "./trouble-box.js";

/** @typedef {import("../pkg/pathlight.js").TriedProposal} Proposal */
/** @typedef {import("../play/session.js").Session} Session */

export class Proposals extends Component {
  #client;
  #imagine;
  #imaginer;
  #slider = this.byId("proposal-slider", HTMLInputElement);
  /**
   * Null until the model has proposed them.
   * @type {Proposal[] | null}
   */
  #proposals = null;
  /**
   * The number of the ball that the address asks for, from 1.
   * @type {number | null}
   */
  #requested = null;
  /**
   * The number of the ball that is shown in the scene.
   * @type {number | null}
   */
  #shown = null;
  #visible = false;
  /** Are the balls saved once they are there? */
  #saves = false;
  #trouble = new TroubleBox(this.byId("proposals-trouble"));
  /**
   * The call to the worker that counts.
   * @type {AbortController | null}
   */
  #call = null;
  /** @type {string | null} */
  #callFailure = null;

  /**
   * @param {import("../widgets/dom.js").Root} root
   * @param {import("../model/shared-client.js").SharedClient} client
   * @param {import("./imagine.js").Imagine} imagine
   */
  constructor(root, client, imagine) {
    super(root);
    this.#client = client;
    this.#imagine = imagine;
    this.#imaginer = new BallImaginer(client);
    this.#imaginer.addEventListener("answer", () => {
      this.#updateFacts(this.#proposals ?? []);
      this.changeOverlay();
    });
    this.#slider.addEventListener("input", () => this.#request(Number(this.#slider.value)));
    this.byId("proposal-back").addEventListener("click", () => this.#request((this.#requested ?? 2) - 1));
    this.byId("proposal-next").addEventListener("click", () => this.#request((this.#requested ?? 0) + 1));
    this.byId("proposal-other").addEventListener("click", () => this.goToOtherOutcome(1));
    this.byId("proposal-save").addEventListener("click", () => this.#save());
    this.byId("proposal-close").addEventListener("click", () => this.session?.reset());
    // The maps come as soon as the model can propose, and go when another is loaded.
    imagine.addEventListener("maps", () => {
      if (!imagine.maps) this.#drop();
      this.#load();
    });
    client.addEventListener("change", () => client.failure && this.#giveUpSaving(client.failure.message));
    imagine.addEventListener("failure", () => this.#giveUpSaving(imagine.failure ?? ""));
  }

  /** @param {Session} session */
  open(session) {
    super.open(session);
    this.listen("change", () => this.#onSessionChange(session));
    this.#show();
  }

  close() {
    super.close();
    this.#saves = false;
    setText(this.byId("proposal-none"), "");
    this.#drop();
    this.#imaginer.forget();
  }

  /** @param {import("../state/view.js").View} view */
  setState({ panel, proposal }) {
    this.#visible = panel === "compare";
    this.#requested = proposal;
    this.#load();
    this.#show();
  }

  /** The ball that is looked at, and where it comes from: a place on the map that orders them, if a map does. */
  get overlay() {
    const shown = this.#shown;
    if (!this.#visible || shown === null || !this.#proposals) return null;
    return {
      maps: this.#able ? [] : this.#imagine.canvasesOf([this.#imagine.maps?.success ? "success" : "placement"]),
      marks: this.#proposals.slice(0, shown).map((proposal, index, proposals) => {
        const chosen = index + 1 === shown;
        return { ball: proposal.ball, from: chosen ? sourceOf(proposal, proposals) : null, chosen };
      }),
      imagined: this.#answer ? this.#imaginer.paths : null,
    };
  }

  /** Does the model imagine balls? Then it learns from its attempts, and the list ends with the ball that solves. */
  get #able() {
    return this.#imaginer.able;
  }

  /** What the model imagines for the ball that is looked at; null until it has come. */
  get #answer() {
    return sameBall(this.#imaginer.answer?.of, this.session?.shown?.ball) ? this.#imaginer.answer : null;
  }

  /** The outcomes tell how the race ends: only when the model has played, or the person looks at its balls anyway. */
  #tellOutcomes() {
    const { solved_at: solvedAt = null, used } = this.session?.attempts.standing("model") ?? {};
    const played = (solvedAt !== null || used === ATTEMPT_LIMIT) && this.session?.hiddenAuthor !== "model";
    this.byId("proposal-outcomes").hidden = this.#shown === null && !played;
  }

  /** @param {number} number */
  #request(number) {
    setText(this.byId("proposal-none"), "");
    if (number >= 1 && number <= (this.#proposals?.length ?? 0)) this.requestState({ proposal: number });
  }

  /**
   * Goes to the next ball, or back to the one before, with another outcome than the one that is looked at.
   * @param {1 | -1} by
   */
  goToOtherOutcome(by) {
    const proposals = this.#proposals;
    if (!this.#visible || !proposals?.length) return;
    const index = this.#requested === null ? 0 : this.#requested - 1;
    const other = otherOutcome(proposals, index, by);
    const words = other === null ? text.panels.proposals.noOther(by) : "";
    setText(this.byId("proposal-none"), words);
    if (other === null) this.announce(words);
    else this.#request(other + 1);
  }

  /** Saves the balls once the model has proposed them; it may still be loading, and what failed is tried again. */
  #save() {
    this.#saves = true;
    this.#callFailure = null;
    if (["off", "failed"].includes(this.#client.status)) this.requestModel();
    if (this.#client.status === "loading") this.announce(text.panels.forecast.loading);
    if (!this.#imagine.maps) this.#imagine.request();
    this.#load();
    this.#saveIfThere();
  }

  /** @param {string} why the balls do not come; when they come later, nobody asks for the file any more */
  #giveUpSaving(why) {
    if (this.#saves) this.announce(why);
    this.#saves = false;
  }

  #saveIfThere() {
    const { loaded } = this.#client;
    if (!this.#saves || !this.session || !this.#proposals || !loaded) return;
    this.#saves = false;
    const task = this.session.about.id ?? this.session.name;
    saveBalls(this.#proposals, { task, seen: this.#imagine.seen ?? false, loaded });
  }

  /** Forgets the proposals: they are another puzzle's or another model's. */
  #drop() {
    this.#call?.abort();
    this.#call = null;
    this.#callFailure = null;
    this.#proposals = null;
    if (this.#shown !== null && this.session?.shown?.preview) this.session.reset();
    this.#shown = null;
    this.#update();
  }

  async #load() {
    const wanted = this.#visible || this.#saves;
    if (!wanted || this.#proposals || this.#call || this.#callFailure || !this.session || !this.#imagine.maps) return;
    const call = (this.#call = new AbortController());
    try {
      const proposals = await this.#client.call("propose", [this.session.puzzle], call.signal);
      if (!call.signal.aborted) this.#proposals = proposals;
    } catch (error) {
      if (!call.signal.aborted) this.#giveUpSaving((this.#callFailure = /** @type {Error} */ (error).message));
    } finally {
      if (this.#call === call) {
        this.#call = null;
        // A run that the person has begun meanwhile goes on.
        if (this.session?.playback.playing && !this.session.shown?.preview) this.#forgetRequest(this.session);
        else this.#show();
        this.#saveIfThere();
      }
    }
  }

  #update() {
    const { session } = this;
    const proposals = this.#proposals;
    // The panel's own box tells of a model that could not be loaded.
    this.byId("proposals-failure").hidden = this.#client.failure !== null;
    this.#trouble.update(this.#client, this.#callFailure, {
      restartModel: () => this.requestModel(),
      repeatCall: () => {
        this.#callFailure = null;
        this.#load();
        this.#update();
      },
    });
    this.byId("proposals").hidden = !proposals || proposals.length === 0;
    this.#tellOutcomes();
    if (!session || !proposals?.length) return this.#updateFacts([]);
    setText(this.byId("proposal-outcomes"), outcomesWords(proposals));
    this.#slider.max = String(proposals.length);
    this.#updateFacts(proposals);
  }

  /** Shows the ball that the address asks for. */
  #show() {
    const { session } = this;
    const number = this.#visible ? this.#requested : null;
    if (session && this.#proposals?.length && number !== null && number !== this.#shown) {
      const proposal = this.#proposals[number - 1];
      if (proposal) {
        // First, because the session tells at once what it shows.
        this.#shown = number;
        const tried = session.attempts.of("model").some(({ ball }) => sameBall(ball, proposal.ball));
        session.preview(number, proposal.ball, tried);
        this.#imaginer.imagine(session.puzzle, proposal.ball);
      } else {
        // The address may ask for more balls than there are.
        this.#forgetRequest(session);
      }
    }
    this.#update();
  }

  /**
   * Something else may be shown than the ball that was looked at.
   * @param {Session} session
   */
  #onSessionChange(session) {
    this.#tellOutcomes();
    const { shown } = session;
    if (this.#shown === null) return;
    const ball = this.#proposals?.[this.#shown - 1]?.ball;
    // A ball of another model may have the same number.
    if (shown?.preview && shown.number === this.#shown && sameBall(shown.ball, ball)) return;
    this.#shown = null;
    this.#requested = null;
    if (this.#proposals) this.#updateFacts(this.#proposals);
    this.#forgetRequest(session);
  }

  /**
   * The address forgets the ball. Not at once: the state that is being applied, or the change that is being told of,
   * reaches all components first. The address may ask for another ball by then.
   * @param {Session} session
   */
  #forgetRequest(session) {
    queueMicrotask(() => {
      const isShown = this.#shown !== null && this.#shown === this.#requested;
      if (session === this.session && !isShown) this.requestState({ proposal: null });
    });
  }

  /** @param {Proposal[]} proposals */
  #updateFacts(proposals) {
    const words = text.panels.proposals;
    const [number, shown] = [this.#shown, this.session?.shown];
    this.byId("proposal-facts").hidden = number === null;
    this.setHidden(this.byId("proposal-close"), number === null);
    this.byId("proposal-hint").hidden = number !== null;
    setText(this.byId("proposal-number"), number === null ? "–" : text.panels.of(number, proposals.length));
    this.#slider.value = String(number ?? 1);
    this.#slider.setAttribute("aria-valuetext", number === null ? words.none : `${number}`);
    if (number === null || !shown) return;
    const proposal = proposals[number - 1];
    setText(this.byId("proposal-ball"), words.place(...proposal.ball));
    setText(this.byId("proposal-outcome"), outcomeWords(shown, !this.#able));
    setText(this.byId("proposal-origin"), originWords(proposal, this.#imagine.maps?.placement));
    this.byId("proposal-imagined").hidden = this.byId("proposal-imagined-term").hidden = !this.#able;
    setText(this.byId("proposal-imagined"), imaginedWords(this.#answer, this.session?.game.sampledPaths()));
  }
}
