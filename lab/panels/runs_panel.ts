// <lab-runs>: the planners that are compared, and what their clock counts.

import { css, html, LitElement, nothing } from 'lit';
import type { Registry } from '../engine/types';
import type { Choice, Pace, State } from '../store/state';
import type { Store } from '../store/store';
import './planner_panel';
import { panelStyle } from './style';

const mostRuns = 4;
/** What a comparison begins with, in this order. */
const suggested = ['dijkstra', 'greedy', 'jps', 'bfs'];

export class RunsPanel extends LitElement {
  static override styles = [panelStyle, css`
    section { padding: 0.9rem 1rem; border-bottom: 1px solid var(--line); }
    lab-planner + button { margin-top: 0.6rem; }
  `];
  static override properties = { store: { attribute: false }, registry: { attribute: false }, state: { attribute: false } };

  declare store: Store;
  declare registry: Registry;
  declare state: State;

  override render() {
    const { runs, pace } = this.state;
    const many = runs.length > 1;
    return html`${runs.map((run, i) => html`
      <section><h2>${many ? `Planner ${i + 1}` : 'Planner'}</h2>
        <lab-planner .registry=${this.registry} .choice=${run} heading="Algorithm"
          @choose=${(event: CustomEvent<Choice>) => this.set(runs.map((each, k) => (k === i ? event.detail : each)))}></lab-planner>
        ${many ? html`<button @click=${() => this.set(runs.filter((_, k) => k !== i))}>Remove ${run.planner}</button>` : nothing}
      </section>`)}
      <section class="stack">
        ${runs.length < mostRuns ? html`<button @click=${this.add}>Compare with another planner</button>` : nothing}
        ${many ? html`<label>One clock counts
          <select @change=${(event: Event) => this.store.set({ pace: (event.target as HTMLSelectElement).value as Pace })}>
            <option value="expansions" ?selected=${pace === 'expansions'}>Expansions</option>
            <option value="time" ?selected=${pace === 'time'}>Time</option>
          </select></label>` : nothing}
      </section>`;
  }

  private add(): void {
    const { runs } = this.state;
    const used = new Set(runs.map(({ planner }) => planner));
    const planner = suggested.find((name) => !used.has(name)) ?? 'astar';
    this.set([...runs, { planner, options: {} }]);
  }

  private set(runs: Choice[]): void {
    if (runs.length !== this.state.runs.length) this.dispatchEvent(new CustomEvent('count'));
    this.store.commit({ runs });
  }
}

customElements.define('lab-runs', RunsPanel);
