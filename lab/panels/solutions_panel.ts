// <lab-solutions>: the paths of an anytime search: when each was found, its cost, its bound, and how both fall.

import { css, html, LitElement } from 'lit';
import type { Outcome, Solution } from '../engine/types';
import type { Clock } from '../store/clock';
import './plot';
import type { Plot } from './plot';
import { panelStyle } from './style';
import { number } from './words';

export class SolutionsPanel extends LitElement {
  static override styles = [panelStyle, css`
    table { width: 100%; border-collapse: collapse; font-size: 0.8125rem; font-variant-numeric: tabular-nums; }
    th { font-weight: 400; color: var(--faint); }
    th, td { text-align: right; padding: 0.1rem 0 0.1rem 0.4rem; }
    th:first-child, td:first-child { text-align: left; padding-left: 0; }
    button { min-height: 0; padding: 0.05rem 0.4rem; font-size: 0.8125rem; }
    tr[aria-current=true] td { color: var(--ink); font-weight: 600; }
    td { color: var(--faint); }
  `];
  static override properties = { outcome: { attribute: false }, planner: { type: String }, clock: { attribute: false } };

  declare outcome: Outcome;
  declare planner: string;
  declare clock: Clock;
  /** The step of this search that the clock stands for. */
  stepOf: () => number = () => this.clock.step;

  private quiet: (() => void) | undefined;
  private drawn: Outcome | null = null;
  private plot!: Plot;

  override connectedCallback(): void {
    super.connectedCallback();
    this.quiet = this.clock.listen(() => this.requestUpdate());
  }
  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.quiet?.();
  }

  override render() {
    const { solutions } = this.outcome;
    const shown = this.stepOf();
    const current = solutions.findLastIndex(({ step }) => step <= shown);
    if (this.drawn !== this.outcome) {
      this.drawn = this.outcome;
      this.plot = plotOf(this.outcome);
    }
    return html`<div class="stack">
      <table><thead><tr><th scope="col">Expanded</th><th scope="col">Cost</th><th scope="col">Bound</th></tr></thead>
        <tbody>${solutions.map((solution, i) => html`<tr aria-current=${i === current}>
          <td><button title="Show the search when it found this path" @click=${() => this.seek(solution)}>${number(solution.step, 0)}</button></td>
          <td>${number(solution.cost, 2)}</td><td>${boundInWords(solution.bound)}</td></tr>`)}</tbody></table>
      <lab-plot .plot=${this.plot} label="Cost and lower bound of ${this.planner} over its expansions; the table above has the numbers"></lab-plot>
      <p>No path costs less than the lower bound.</p></div>`;
  }

  private seek({ step }: Solution): void {
    this.dispatchEvent(new CustomEvent('seek', { detail: step }));
  }
}

function boundInWords(bound: number | null): string {
  if (bound === null) return 'none';
  return bound === 1 ? 'cheapest' : `≤ ${number(bound, 3)} × best`;
}

function plotOf({ solutions, steps }: Outcome): Plot {
  const last = solutions.at(-1)!;
  const all = last.step < steps ? [...solutions, { ...last, step: steps }] : solutions;
  return {
    names: ['cost', 'lower bound'], across: 'expansions', up: 'cost', dots: false, steps: true, logarithmic: false,
    data: [all.map(({ step }) => step), all.map(({ cost }) => cost), all.map(({ cost, bound }) => (bound === null ? null : cost / bound))],
  };
}

customElements.define('lab-solutions', SolutionsPanel);
