// <lab-charts>: cost, expansions and time of the searches as bars, and a scatter over random queries on this map.

import { css, html, LitElement, nothing } from 'lit';
import type { Runner } from '../engine/runner';
import { drawQueries, leastCost, sample, summaryOf, type Sample } from '../engine/sampling';
import type { Searches } from '../engine/searches';
import type { State } from '../store/state';
import './plot';
import type { Plot } from './plot';
import { panelStyle } from './style';
import { duration, number } from './words';

type Measure = 'expanded' | 'seconds' | 'cost';
const measures: [Measure, string, (runner: Runner) => number | undefined, (value: number) => string][] = [
  ['expanded', 'Expansions', ({ outcome }) => outcome?.expanded, (value) => number(value, 0)],
  ['cost', 'Cost', ({ outcome }) => outcome?.cost, (value) => number(value, 2)],
  ['seconds', 'Time', ({ outcome }) => outcome?.seconds, duration],
];
const most = 2000;

export class ChartsPanel extends LitElement {
  static override styles = [panelStyle, css`
    dl { display: grid; grid-template-columns: 5.5rem 1fr auto; gap: 0.2rem 0.5rem; margin: 0; font-size: 0.8125rem; align-items: center; }
    dt { color: var(--faint); overflow: hidden; text-overflow: ellipsis; }
    dd { margin: 0; font-variant-numeric: tabular-nums; text-align: right; }
    h3 { grid-column: 1 / -1; margin: 0.3rem 0 0; font-size: 0.8125rem; font-weight: 400; color: var(--faint); }
    i { height: 0.7rem; border-radius: 0 3px 3px 0; background: var(--path); min-width: 1px; }
    table { width: 100%; border-collapse: collapse; font-size: 0.8125rem; font-variant-numeric: tabular-nums; }
    th { font-weight: 400; text-align: left; color: var(--faint); }
    td, thead th + th { text-align: right; padding-left: 0.4rem; }
  `];
  static override properties = {
    searches: { attribute: false }, state: { attribute: false }, version: { type: String },
    samples: { state: true }, done: { state: true }, measure: { state: true },
  };

  declare searches: Searches;
  declare state: State;
  declare version: string;
  declare samples: { of: State; all: Sample[] } | null;
  /** Number of finished queries; -1: no run was started. */
  declare done: number;
  declare measure: Measure;
  private count = 200;
  private seed = 1;

  constructor() {
    super();
    this.samples = null;
    this.done = -1;
    this.measure = 'expanded';
  }

  override render() {
    return html`<div class="stack">
      ${this.state.runs.length > 1 ? this.bars() : nothing}
      <div class="row">
        <label>Random queries
          <input type="number" min="1" max=${most} .value=${String(this.count)}
            @change=${(event: Event) => { this.count = Math.min(Math.max(Math.round(Number(valueOf(event))) || 1, 1), most); }}></label>
        <label>Seed of the queries
          <input type="number" min="0" .value=${String(this.seed)}
            @change=${(event: Event) => { this.seed = Math.max(Math.round(Number(valueOf(event))) || 0, 0); }}></label>
      </div>
      ${this.done < 0 ? html`<button @click=${() => this.ask()}>Ask them</button>`
        : html`<button @click=${() => { this.done = -1; }}>Stop: ${this.done} of ${this.count} done</button>`}
      ${this.samples ? this.scatter(this.samples.of, this.samples.all) : nothing}</div>`;
  }

  private bars() {
    const runners = this.searches.runners.filter((_, i) => i < this.state.runs.length);
    return html`<dl>${measures.map(([, title, valueIn, text]) => {
      const values = runners.map(valueIn);
      const greatest = Math.max(...values.map((value) => value ?? 0), 1e-12);
      return html`<h3>${title}</h3>${values.map((value, i) => html`
        <dt>${this.state.runs[i]!.planner}</dt>
        <dd><i style="display:block;width:${(100 * (value ?? 0)) / greatest}%"></i></dd>
        <dd>${value === undefined ? 'none' : text(value)}</dd>`)}`;
    })}</dl>`;
  }

  private scatter(of: State, all: Sample[]) {
    const solved = all.filter(({ answers }) => answers.some((answer) => answer)).sort((a, b) => leastCost(a.answers) - leastCost(b.answers));
    const names = of.runs.map(({ planner }) => planner);
    const [, title] = measures.find(([measure]) => measure === this.measure)!;
    const scale = this.measure === 'seconds' ? 1000 : 1;
    const plot: Plot = {
      names, dots: true, logarithmic: this.measure !== 'cost', across: 'least cost of a path', up: this.measure === 'seconds' ? 'ms' : title.toLowerCase(),
      data: [solved.map(({ answers }) => leastCost(answers)), ...of.runs.map((_, run) => solved.map(({ answers }) => {
        const value = answers[run]?.[this.measure];
        // A logarithm has no place for 0.
        return value === undefined || (value === 0 && this.measure !== 'cost') ? null : value * scale;
      }))],
    };
    return html`
      <label>Show of each query
        <select @change=${(event: Event) => { this.measure = valueOf(event) as Measure; }}>
          ${measures.map(([measure, label]) => html`<option value=${measure} ?selected=${measure === this.measure}>${label}</option>`)}
        </select></label>
      <lab-plot .plot=${plot} label="${title} of ${names.join(', ')} for ${solved.length} random queries; the table below has the medians"></lab-plot>
      <table><thead><tr><th>Median</th><th scope="col">Expanded</th><th scope="col">Time</th><th scope="col">Cost</th></tr></thead>
        <tbody>${names.map((name, run) => {
          const { expanded, seconds, ratio, solved: count } = summaryOf(all, run);
          return count === 0 ? html`<tr><th scope="row">${name}</th><td colspan="3">no path</td></tr>` : html`<tr><th scope="row">${name}</th>
            <td>${number(expanded, 0)}</td><td>${duration(seconds)}</td><td>${number(ratio, 3)} × least</td></tr>`;
        })}</tbody></table>
      <p>${solved.length} of ${all.length} queries have a path.</p>`;
  }

  private async ask(): Promise<void> {
    const { state } = this;
    const queries = drawQueries(state.map!, this.count, this.seed);
    this.done = 0;
    const workers = this.searches.helpers(Math.min(navigator.hardwareConcurrency || 2, 4, queries.length));
    try {
      const all = await sample(workers.map(({ planning }) => planning), state, queries, (done) => {
        if (this.done >= 0) this.done = done;
        return this.done >= 0;
      });
      this.samples = { of: state, all };
    } finally {
      for (const worker of workers) worker.end();
      this.done = -1;
      this.dispatchEvent(new CustomEvent('asked', { detail: this.samples?.all.length ?? 0 }));
    }
  }
}

function valueOf(event: Event): string {
  return (event.target as HTMLInputElement).value;
}

customElements.define('lab-charts', ChartsPanel);
