// <lab-side>: all panels beside the maps. What they ask for goes to the page, by its Actions.

import { css, html, LitElement, nothing } from 'lit';
import type { Extras } from '../engine/extras';
import type { Searches } from '../engine/searches';
import type { Layer, Registry } from '../engine/types';
import type { Lesson } from '../exercises/lesson';
import type { ScenarioQuery } from '../formats/moving_ai';
import type { Clock } from '../store/clock';
import { firstRecipe } from '../store/maps';
import type { Recipe } from '../store/state';
import type { Store } from '../store/store';
import type { Pointed } from '../view/map_view';
import { endsOfQuery } from './desk';
import './charts_panel';
import './exercise_panel';
import './facts';
import './file_panel';
import './follow_panel';
import type { Saved } from './file_panel';
import './layers_panel';
import './map_panel';
import './results';
import './robot_panel';
import './runs_panel';
import './solutions_panel';
import { panelStyle } from './style';
import { cellInWords } from './words';

/** What the panels ask of the page. */
export interface Actions {
  /** Shows the whole map once it is laid out. */
  fitSoon(): void;
  make(recipe: Recipe): void;
  openFiles(files: File[]): void;
  save(what: Saved): void;
  say(message: string): void;
  /** Shows a search after this number of expansions. */
  seek(run: number, step: number): void;
  share(): void;
  shape(footprint: string): void;
  show(layer: Layer): void;
  /** The step of the search that a cell was asked about. */
  stepOfPointed(): number;
}

export class Side extends LitElement {
  static override styles = [panelStyle, css`
    section { padding: 0.9rem 1rem; border-bottom: 1px solid var(--line); }
    section:last-child { border: 0; }
    a { font-size: 0.8125rem; color: var(--accent); }
  `];
  static override properties = {
    store: { attribute: false }, clock: { attribute: false }, registry: { attribute: false }, searches: { attribute: false }, lesson: { attribute: false }, extras: { attribute: false },
    actions: { attribute: false }, queries: { attribute: false }, pointed: { attribute: false }, version: { type: String },
  };

  declare store: Store;
  declare clock: Clock;
  declare registry: Registry;
  declare searches: Searches;
  declare lesson: Lesson;
  declare extras: Extras;
  declare actions: Actions;
  declare queries: ScenarioQuery[];
  declare pointed: Pointed | null;
  /** Changes with every state and answer. */
  declare version: string;

  override render() {
    const { state } = this.store;
    const { map, exercise } = state;
    if (!map) return nothing;
    const secret = exercise === 'heuristic' && !this.lesson.solved;
    return html`
      ${exercise !== '' ? this.exercise() : nothing}
      ${secret ? nothing : html`
        <lab-runs .store=${this.store} .registry=${this.registry} .state=${state} @count=${() => this.actions.fitSoon()}></lab-runs>`}
      <section><h2>Result</h2>
        <lab-results .runners=${this.searches.runners} .runs=${state.runs} version=${this.version}></lab-results>
        ${this.searches.busy ? html`<button @click=${() => this.searches.stop()}>Stop the search</button>` : nothing}
      </section>
      ${state.runs.map(({ planner }, i) => this.solutions(planner, i))}
      <section><h2>Under the pointer</h2>${this.cellFacts(secret)}</section>
      ${secret ? nothing : html`<section><h2>Colours</h2>
        <lab-layers .store=${this.store} .state=${state} .range=${this.searches.runners[0]?.range ?? null}
          @show=${(event: CustomEvent<Layer>) => this.actions.show(event.detail)}></lab-layers></section>`}
      <section><h2>Charts</h2>
        <lab-charts .searches=${this.searches} .state=${state} version=${this.version}
          @asked=${(event: CustomEvent<number>) => this.actions.say(`${event.detail} random queries are answered.`)}></lab-charts></section>
      <section><h2>Robot and path</h2>
        <lab-robot .store=${this.store} .registry=${this.registry} .state=${state} .widest=${this.extras.widest}
          @shape=${(event: CustomEvent<string>) => this.actions.shape(event.detail)}></lab-robot></section>
      <section><h2>Following</h2>
        <lab-follow .store=${this.store} .registry=${this.registry} .state=${state} .extras=${this.extras} version=${this.version}></lab-follow></section>
      <section><h2>Map</h2>
        <lab-map-panel .registry=${this.registry} .recipe=${map.recipe ?? firstRecipe}
          name="${map.name}, ${map.width} × ${map.height} cells"
          @make=${(event: CustomEvent<Recipe>) => this.actions.make(event.detail)}></lab-map-panel></section>
      <section><h2>Files</h2>
        <lab-files .queries=${this.queries}
          @open=${(event: CustomEvent<File[]>) => this.actions.openFiles(event.detail)}
          @query=${(event: CustomEvent<number>) => this.store.commit(endsOfQuery(this.queries[event.detail]!))}
          @save=${(event: CustomEvent<Saved>) => this.actions.save(event.detail)}></lab-files></section>
      ${exercise === '' ? this.exercise() : nothing}
      ${document.getElementById('wend-wasm') ? nothing : html`<section><a href="./licences.html">Licences</a></section>`}`;
  }

  private exercise() {
    return html`<section><h2>Exercise</h2>
      <lab-exercise .store=${this.store} .lesson=${this.lesson} exercise=${this.store.state.exercise} version=${this.version}
        @share=${() => this.actions.share()}></lab-exercise></section>`;
  }

  /** Of an anytime planner. */
  private solutions(planner: string, run: number) {
    const outcome = this.searches.runners[run]?.outcome;
    if (!outcome || outcome.solutions.length === 0) return nothing;
    return html`<section><h2>Paths of ${planner}</h2>
      <lab-solutions .outcome=${outcome} .planner=${planner} .clock=${this.clock} .stepOf=${() => this.searches.stepOf(run, this.store.state)}
        @seek=${(event: CustomEvent<number>) => this.actions.seek(run, event.detail)}></lab-solutions></section>`;
  }

  private cellFacts(secret: boolean) {
    if (!this.pointed) return html`<p>Point at a cell, or move to the map with Tab and use the arrow keys.</p>`;
    const { cell, info } = this.pointed;
    const lines = cellInWords(cell, info, this.actions.stepOfPointed());
    // What would answer the question is not shown.
    return html`<lab-facts .lines=${secret ? lines.filter(([name]) => !/^[hf],/.test(name)) : lines}></lab-facts>`;
  }
}

customElements.define('lab-side', Side);
