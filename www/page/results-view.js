// The results page: all test tasks of the shipped models' folds by template, with the attempt that solved each first,
// as links; what others have published; how often the chances that a model gives come true; and the whole as CSV.

import { calibrationChart, calibrationTable } from "./calibration-chart.js";
import { ourRows, paperNets, publishedRows } from "./compared-rows.js";
import { AGENTS, readResults, resultsCsv } from "../model/results.js";
import { text } from "../text/text.js";
import { byId, focusIsLost, passFocus } from "../widgets/dom.js";
import { download } from "../widgets/download.js";

/** @typedef {import("../model/results.js").ModelResults} ModelResults */
/** @typedef {import("../pkg/pathlight.js").Template} Template */
/** @typedef {(task: string, model: string) => string | null} HrefOf */

/**
 * Which tasks are listed, by the attempt that solved them first.
 * @type {Record<string, (first: number | null) => boolean>}
 */
const FILTERS = {
  all: () => true,
  failures: (first) => first === null,
  late: (first) => first === null || first > 10,
  first: (first) => first === 1,
};

export class ResultsView {
  #model = byId(document, "results-model", HTMLSelectElement);
  #agent = byId(document, "results-agent", HTMLSelectElement);
  #filter = byId(document, "results-filter", HTMLSelectElement);
  #templates;
  #hrefOf;
  /**
   * The name of the model whose results are asked for; null for the first.
   * @type {string | null}
   */
  #asked = null;
  /** @type {ModelResults[]} */
  #models = [];

  /**
   * @param {Template[]} templates
   * @param {HrefOf} hrefOf the address of a task with a model; null if the link hides it
   */
  constructor(templates, hrefOf) {
    this.#templates = templates;
    this.#hrefOf = hrefOf;
    this.#model.addEventListener("change", () => this.#onModel());
    for (const select of [this.#agent, this.#filter]) select.addEventListener("change", () => this.#update());
    byId(document, "results-csv").addEventListener("click", () => this.#save());
    byId(document, "results-retry").addEventListener("click", () => this.show(this.#asked));
  }

  /**
   * Shows the results of a model, or of the one that was chosen last, at first the first.
   * @param {string | null} name
   */
  async show(name) {
    this.#asked = name;
    const before = this.#chosen?.name;
    // What had the focus may be out of sight now.
    if (focusIsLost()) byId(document, "results-title").focus();
    const failure = byId(document, "results-failure");
    let compared;
    try {
      ({ models: this.#models, compared } = await readResults());
      passFocus(failure, byId(document, "results-title"));
      failure.hidden = true;
    } catch (error) {
      failure.hidden = false;
      byId(document, "results-failure-words").textContent = /** @type {Error} */ (error).message;
      return;
    }
    // Another was asked for meanwhile.
    if (name !== this.#asked) return;
    byId(document, "results-body").hidden = false;
    byId(document, "results-ours").replaceChildren(...ourRows(compared));
    byId(document, "results-published").replaceChildren(...publishedRows(compared.published));
    const { paper } = compared;
    byId(document, "results-paper").hidden = !paper;
    byId(document, "results-paper").replaceChildren(paper ? paperNets(this.#templates, paper) : "");
    this.#model.replaceChildren(
      ...this.#models.map((one) => new Option(one.name, one.name, false, one.name === (name ?? before))),
    );
    this.#onModel();
  }

  get #chosen() {
    return this.#models[Math.max(this.#model.selectedIndex, 0)];
  }

  #onModel() {
    const chosen = this.#agent.value;
    const agents = AGENTS.filter((agent) => agent in this.#chosen.first_solved);
    const nameOf = (/** @type {(typeof AGENTS)[number]} */ agent) =>
      text.results.namedAgent(agent, text.model.agents[agent]);
    this.#agent.replaceChildren(...agents.map((agent) => new Option(nameOf(agent), agent, false, agent === chosen)));
    this.#update();
  }

  #update() {
    const model = this.#chosen;
    const firsts = model.first_solved[this.#agent.value];
    const passes = FILTERS[this.#filter.value];
    const words = text.results;
    const within = (/** @type {number} */ most) => firsts.filter((first) => first !== null && first <= most).length;
    byId(document, "results-about").textContent = words.about(
      model.name,
      text.model.knows[model.setup],
      model.tasks.length,
    );
    byId(document, "results-summary").textContent = [
      words.outcome([100, 10, 1].map(within), firsts.length),
      words.auccess(model.auccess[this.#agent.value]),
    ].join(" ");
    const others = AGENTS.filter((agent) => agent !== this.#agent.value && agent in model.auccess);
    byId(document, "results-compared").textContent = words.compared(
      others.map((agent) => [agent, model.auccess[agent]]),
    );
    const rows = this.#templates.flatMap((template) => this.#row(template, model, firsts, passes) ?? []);
    byId(document, "results-templates").replaceChildren(...rows);
    byId(document, "results-empty").hidden = rows.length > 0;
    const { calibration } = model;
    byId(document, "calibration-chart").replaceChildren(calibrationChart(calibration));
    byId(document, "calibration-rows").replaceChildren(...calibrationTable(calibration));
  }

  /**
   * The tasks of a template that pass; undefined if none do.
   * @param {Template} template
   * @param {ModelResults} model
   * @param {(number | null)[]} firsts
   * @param {(first: number | null) => boolean} passes
   */
  #row({ id, name }, model, firsts, passes) {
    const all = model.tasks
      .map((task, index) => ({ task, first: firsts[index] }))
      .filter(({ task }) => task.startsWith(id));
    const listed = all.filter(({ first }) => passes(first));
    if (listed.length === 0) return undefined;
    const heading = document.createElement("h3");
    heading.textContent = name;
    const count = document.createElement("span");
    count.className = "count";
    count.textContent = text.results.ofKind(all.filter(({ first }) => first !== null).length, all.length);
    heading.append(" ", count);
    const list = document.createElement("ul");
    list.append(...listed.map((one) => this.#cell(one, model.name)));
    const item = document.createElement("li");
    item.append(heading, list);
    return item;
  }

  /**
   * @param {{ task: string, first: number | null }} result
   * @param {string} model
   */
  #cell({ task, first }, model) {
    const href = this.#hrefOf(task, model);
    const cell = document.createElement(href ? "a" : "span");
    if (href) cell.setAttribute("href", href);
    cell.className = first === null ? "missed" : first === 1 ? "at-once" : "solved";
    cell.textContent = first === null ? "×" : String(first);
    const words = first === null ? text.results.missed(task) : text.results.solved(task, first);
    cell.title = words;
    cell.setAttribute("aria-label", words);
    const item = document.createElement("li");
    item.append(cell);
    return item;
  }

  #save() {
    const names = new Map(this.#templates.map(({ id, name }) => [id, name]));
    const csv = resultsCsv(this.#models, (task) => names.get(task.slice(0, 5)) ?? "");
    download("pathlight-results.csv", new Blob([csv], { type: "text/csv" }));
  }
}
