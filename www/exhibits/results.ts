// "How good are the models?": the page's models on the test tasks of one fold, with a link for each failure; how often
// their predicted chances come true; and, separately, means over ten folds compared with published results.

import { html, nothing } from "lit-html";
import { calibrationChart } from "./charts.ts";
import { loadText, puzzleAddress, show } from "./exhibit.ts";
import { AGENTS, resultsCsv } from "./results-file.ts";
import type { TemplateResult } from "lit-html";
import type { Agent, ModelResults, Results } from "./results-file.ts";

/** Filters for the listed tasks, by the number of the ball that first solved them. */
const FILTERS = {
  all: () => true,
  failures: (first: number | null) => first === null,
  late: (first: number | null) => first === null || first > 10,
  first: (first: number | null) => first === 1,
};

const text = await loadText();
const words = text.results;
let state: {
  readonly results: Results | null;
  readonly failure: string | null;
  readonly model: number;
  readonly agent: Agent;
  readonly filter: keyof typeof FILTERS;
} = { results: null, failure: null, model: 0, agent: "online", filter: "all" };

function change(part: Partial<typeof state>): void {
  state = { ...state, ...part };
  view();
}

async function begin(): Promise<void> {
  change({ failure: null });
  try {
    const response = await fetch(new URL("assets/results.json", import.meta.url));
    if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
    const results: Results = await response.json();
    const asked = new URLSearchParams(location.search).get("model");
    change({
      results,
      model: Math.max(
        results.models.findIndex(({ name }) => name === asked),
        0,
      ),
    });
  } catch (error) {
    change({ failure: (error as Error).message });
  }
}

function view(): void {
  const { results, failure } = state;
  show(
    text,
    words.title,
    html`<p>${words.about}</p>
      ${failure === null ? nothing : html`<p class="trouble" role="alert">${words.failed(failure)} <button @click=${begin}>${text.retry}</button></p>`}
      ${results ? html`${here(results)} ${means(results.compared)}` : nothing}`,
  );
}

/** The page's models, on one fold. */
function here({ models }: Results): TemplateResult {
  const model = models[state.model]!;
  const agents = AGENTS.filter((agent) => model.first_solved[agent]);
  const agent = agents.includes(state.agent) ? state.agent : agents[0]!;
  const firsts = model.first_solved[agent]!;
  const within = (most: number) => firsts.filter((first) => first !== null && first <= most).length / firsts.length;
  const learned = agent === "paper" || agent === "random" ? agent : model.setup;
  return html`<h2>${words.here}</h2>
    <p class="choices">
      ${select(
        words.model,
        state.model,
        models.map(({ setup, name }, index) => [index, `${words.models[setup]} (${name})`]),
        (model) => change({ model: Number(model) }),
      )}
      ${select(
        words.agent,
        agent,
        agents.map((agent) => [agent, words.agents[agent]]),
        (agent) => change({ agent: agent as Agent }),
      )}
    </p>
    <dl class="figures">
      <div>
        <dt>${words.auccess}</dt>
        <dd>${text.number(model.auccess[agent]!, 1)}</dd>
      </div>
      ${[1, 10, 100].map(
        (most) =>
          html`<div>
            <dt>${words.solved(most)}</dt>
            <dd>${text.percent(within(most), 1)}</dd>
          </div>`,
      )}
    </dl>
    <p>${words.unseen(model.tasks.length)} ${words.auccessHint} <strong>${words.sawMore[learned]}</strong></p>
    <p class="quiet">
      ${words.others}
      ${agents
        .filter((other) => other !== agent)
        .map((other) => `${other} ${text.number(model.auccess[other]!, 1)}`)
        .join(", ")}.
    </p>
    ${tasks(model, firsts)} ${calibration(model)}`;
}

function tasks(model: ModelResults, firsts: readonly (number | null)[]): TemplateResult {
  const all = model.tasks.map((task, index) => ({ task, kind: task.slice(0, 5), first: firsts[index] ?? null }));
  const kinds = [...new Set(all.map(({ kind }) => kind))].map((kind) => {
    const of = all.filter((one) => one.kind === kind);
    return { kind, of, listed: of.filter(({ first }) => FILTERS[state.filter](first)) };
  });
  const shown = kinds.filter(({ listed }) => listed.length > 0);
  return html`<p class="choices">
      ${select(words.show, state.filter, Object.entries(words.filters), (filter) =>
        change({ filter: filter as keyof typeof FILTERS }),
      )}
      <button @click=${save}>${words.csv}</button>
    </p>
    <p>${shown.length ? words.cells : words.none}</p>
    <ul class="tasks">
      ${shown.map(
        ({ kind, of, listed }) =>
          html`<li>
            <h3>
              ${text.kind(kind)}
              <span class="quiet">${words.ofKind(of.filter(({ first }) => first !== null).length, of.length)}</span>
            </h3>
            <ul>
              ${listed.map(({ task, first }) => {
                const name = words.cell(task, first);
                const result = first === null ? "missed" : first === 1 ? "at-once" : "solved";
                return html`<li>
                  <a class=${result} href=${puzzleAddress(task)} title=${name} aria-label=${name}>${first ?? "×"}</a>
                </li>`;
              })}
            </ul>
          </li>`,
      )}
    </ul>`;
}

function calibration({ calibration }: ModelResults): TemplateResult {
  const { random, candidates } = calibration;
  const cells = ({ balls, solved }: (typeof random)[number]) =>
    html`<td>${text.number(balls)}</td>
      <td>${balls ? text.percent(solved / balls, 1) : "–"}</td>`;
  return html`<h2 id="calibration">${words.calibration}</h2>
    <p>${words.calibrationAbout}</p>
    <div class="calibration">
      <figure>
        ${calibrationChart(calibration, text)}
        <p class="key">
          <span class="random">● ${words.random}</span> <span class="candidates">■ ${words.candidates}</span>
        </p>
      </figure>
      <div class="wide" tabindex="0" role="group" aria-labelledby="calibration">
        <table>
          <thead>
            <tr>
              <th scope="col" rowspan="2">${words.chance}</th>
              <th scope="colgroup" colspan="2">${words.random}</th>
              <th scope="colgroup" colspan="2">${words.candidates}</th>
            </tr>
            <tr>
              ${[1, 2].map(
                () =>
                  html`<th scope="col">${words.balls}</th>
                    <th scope="col">${words.solve}</th>`,
              )}
            </tr>
          </thead>
          <tbody>
            ${random.map(
              (bin, index) =>
                html`<tr>
                  <th scope="row">${words.range(index / random.length, (index + 1) / random.length)}</th>
                  ${cells(bin)}${cells(candidates[index]!)}
                </tr>`,
            )}
          </tbody>
        </table>
      </div>
    </div>`;
}

/** Means over ten folds. */
function means({ ours, published, paper }: Results["compared"]): TemplateResult {
  const measured = ours.filter(([, auccess]) => auccess.some((cell) => cell !== "–"));
  return html`<h2 id="means">${words.means}</h2>
    <p>${words.meansAbout}</p>
    <div class="wide" tabindex="0" role="group" aria-labelledby="means">
      <table>
        <thead>
          <tr>
            <td></td>
            <th scope="col">${words.within}</th>
            <th scope="col">${words.cross}</th>
          </tr>
        </thead>
        <tbody>
          <tr>
            <th scope="rowgroup" colspan="3">${words.ours}</th>
          </tr>
          ${measured.map(([recipe, auccess]) => row(words.recipes[recipe as keyof typeof words.recipes], auccess))}
        </tbody>
        <tbody>
          <tr>
            <th scope="rowgroup" colspan="3">${words.published}</th>
          </tr>
          ${published.map(({ method, source, url, auccess }) => row(html`${method && `${method}, `}<a href=${url}>${source}</a>`, auccess))}
        </tbody>
      </table>
    </div>
    <p class="quiet">
      ${words.sawMoreMark} ${measured.some(([recipe]) => recipe === "memory") ? words.memoryMark : nothing}
    </p>
    ${byKind(paper)}`;
}

function byKind(setups: Results["compared"]["paper"]): TemplateResult {
  const kinds = setups[0]![0].map((_, index) => String(index).padStart(5, "0"));
  return html`<details>
    <summary id="by-kind">${words.byKind}</summary>
    <p>${words.byKindAbout}</p>
    <div class="wide" tabindex="0" role="group" aria-labelledby="by-kind">
      <table>
        <thead>
          <tr>
            <th scope="col" rowspan="2">${words.kindColumn}</th>
            <th scope="colgroup" colspan="2">${words.within}</th>
            <th scope="colgroup" colspan="2">${words.cross}</th>
          </tr>
          <tr>
            ${[1, 2].map(
              () =>
                html`<th scope="col">${words.publishedColumn}</th>
                  <th scope="col">${words.oursColumn}</th>`,
            )}
          </tr>
        </thead>
        <tbody>
          ${kinds.map((kind, index) =>
            row(
              text.kind(kind),
              setups.flatMap(([published, ours]) => [published[index]!, ours[index]!]),
            ),
          )}
        </tbody>
      </table>
    </div>
  </details>`;
}

/** A row of figures as printed, with the same number of decimals. */
function row(name: string | TemplateResult, figures: readonly string[]): TemplateResult {
  const local = (figure: string) =>
    figure.replace(/[\d.]+/g, (digits) => text.number(Number(digits), digits.includes(".") ? 1 : 0));
  return html`<tr>
    <th scope="row">${name}</th>
    ${figures.map((figure) => html`<td>${local(figure)}</td>`)}
  </tr>`;
}

function select(
  label: string,
  chosen: string | number,
  options: readonly (readonly [value: string | number, name: string])[],
  onChange: (value: string) => void,
): TemplateResult {
  return html`<label
    ><span>${label}</span>
    <select @change=${({ target }: Event) => onChange((target as HTMLSelectElement).value)}>
      ${options.map(([value, name]) => html`<option value=${value} ?selected=${value === chosen}>${name}</option>`)}
    </select></label
  >`;
}

function save(): void {
  const csv = resultsCsv(state.results!.models, (task) => text.kind(task));
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([csv], { type: "text/csv" }));
  link.download = "pathlight-results.csv";
  link.click();
  // Wait until the browser has fetched it.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

void begin();
