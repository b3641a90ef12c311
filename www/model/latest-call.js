// Asks for an answer to something that changes all the time: the newest question counts, and those that come while one
// is being answered are left out, except for the last. Knows nothing of what is asked.

/**
 * @template Question
 * @template Answer
 */
export class LatestCall {
  #ask;
  #onAnswer;
  #onFailure;
  /** @type {{ question: Question } | null} */
  #next = null;
  /**
   * Runs while a question is being answered.
   * @type {AbortController | null}
   */
  #call = null;

  /**
   * @param {(question: Question, signal: AbortSignal) => Promise<Answer>} ask
   * @param {(answer: Answer, question: Question) => void} onAnswer
   * @param {(message: string) => void} onFailure
   */
  constructor(ask, onAnswer, onFailure) {
    this.#ask = ask;
    this.#onAnswer = onAnswer;
    this.#onFailure = onFailure;
  }

  /** @param {Question} question */
  async ask(question) {
    this.#next = { question };
    if (this.#call) return;
    const call = (this.#call = new AbortController());
    try {
      for (let next = this.#take(); next; next = this.#take()) {
        const act = await this.#answered(next.question, call.signal);
        if (call.signal.aborted) return;
        act();
      }
    } finally {
      if (this.#call === call) this.#call = null;
    }
  }

  /**
   * Resolves to what has to be done with the answer, or with the failure to get one.
   * @param {Question} question
   * @param {AbortSignal} signal
   */
  async #answered(question, signal) {
    try {
      const answer = await this.#ask(question, signal);
      return () => this.#onAnswer(answer, question);
    } catch (error) {
      // A newer question is asked all the same.
      return () => this.#next || this.#onFailure(/** @type {Error} */ (error).message);
    }
  }

  /** Forgets the question; its answer never comes. */
  stop() {
    this.#call?.abort();
    this.#call = null;
    this.#next = null;
  }

  #take() {
    const next = this.#next;
    this.#next = null;
    return next;
  }
}
