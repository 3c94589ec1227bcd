// <wend-lab>: the page: wires the store, the clock, the searches, the views and the panels.

import { html, LitElement, nothing } from 'lit';
import { Runner } from '../engine/runner';
import type { Layer, Registry } from '../engine/types';
import { Clock } from '../store/clock';
import { centreOf, specOf, type Choice, type Recipe, type State } from '../store/state';
import { Store, type Stroke } from '../store/store';
import { Camera } from '../view/camera';
import '../view/map_view';
import type { MapView, Pointed } from '../view/map_view';
import { dark, light } from '../view/palette';
import { appStyle } from './app_style';
import './facts';
import './map_panel';
import './planner_panel';
import { panelStyle } from './style';
import './tools_panel';
import './transport';
import { cellInWords, duration, number, outcomeInWords } from './words';

const layers: { layer: Layer; label: string }[] = [
  { layer: '', label: 'Expanded and frontier' },
  { layer: 'expansion', label: 'Order of expansion' },
  { layer: 'g', label: 'g: cost from the start' },
  { layer: 'h', label: 'h: estimate to the goal' },
  { layer: 'f', label: 'f: priority' },
  { layer: 'cost', label: 'Cost to go' },
  { layer: 'clearance', label: 'Clearance' },
];

const firstRecipe: Recipe = { generator: 'rooms', options: {}, width: 61, height: 35, seed: 3 };

export class App extends LitElement {
  static override styles = [panelStyle, appStyle];

  private readonly store = new Store();
  private readonly clock = new Clock();
  private readonly camera = new Camera();
  private readonly scheme = matchMedia('(prefers-color-scheme: dark)');
  private readonly calm = matchMedia('(prefers-reduced-motion: reduce)');
  private module: WebAssembly.Module | null = null;
  private registry: Registry | null = null;
  private runners: Runner[] = [];
  private pointed: Pointed | null = null;
  private message = '';
  private dragging = false;
  private play = false;
  private unfitted = true;

  /** Begins with a compiled engine. */
  async begin(module: WebAssembly.Module): Promise<void> {
    this.module = module;
    this.store.listen((state, before, stroke) => this.changed(state, before, stroke));
    this.clock.listen(() => this.refreshViews());
    this.scheme.addEventListener('change', () => this.refreshAll());
    addEventListener('keydown', (event) => this.key(event));
    this.runners = [this.newRunner()];
    this.registry = await this.runners[0]!.engine.call('registry');
    this.play = !this.calm.matches;
    await this.make(firstRecipe, false);
    const frame = (now: number) => {
      this.clock.tick(now);
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  override render() {
    const { state } = this.store;
    if (!this.registry || !state.map) return html`<p class="wait">Loading the planners</p>`;
    const colours = this.scheme.matches ? dark : light;
    return html`
      <header>
        <h1>wend lab</h1>
        <lab-tools .store=${this.store}></lab-tools>
      </header>
      <main>
        <section class="views" aria-label="Map">
          ${state.runs.map((run, i) => html`
            <lab-map .store=${this.store} .clock=${this.clock} .runner=${this.runners[i]!} .camera=${this.camera}
              .colours=${colours} .stepOf=${() => this.stepOf(i)}
              label="Map with the search of ${run.planner}. Arrow keys move the cursor, space paints, S and G set start and goal."
              @camera=${() => this.refreshViews()} @resized=${() => this.fit()}
              @drag=${(event: CustomEvent<boolean>) => this.drag(event.detail)}
              @pointed=${(event: CustomEvent<Pointed | null>) => this.point(event.detail)}></lab-map>`)}
        </section>
        <aside aria-label="Settings">
          ${this.planners(state)}
          <section><h2>Result</h2><lab-facts .lines=${this.results()}></lab-facts>${this.why()}</section>
          <section><h2>Colours</h2>${this.layers(state)}</section>
          <section><h2>Map</h2>
            <lab-map-panel .registry=${this.registry} .recipe=${state.map.recipe ?? firstRecipe} name=${state.map.name}
              @make=${(event: CustomEvent<Recipe>) => this.make(event.detail)}></lab-map-panel>
          </section>
          <section class="cell"><h2>Under the pointer</h2>${this.cellFacts()}</section>
        </aside>
      </main>
      <footer><lab-transport .clock=${this.clock}></lab-transport></footer>
      <p class="live" role="status">${this.message}</p>`;
  }

  override updated(): void {
    if (this.unfitted) this.fit();
    this.refreshViews();
  }

  private planners(state: State) {
    return state.runs.map((run, i) => html`
      <section><h2>Planner</h2>
        <lab-planner .registry=${this.registry} .choice=${run} heading="Algorithm"
          @choose=${(event: CustomEvent<Choice>) => this.choose(i, event.detail)}></lab-planner>
      </section>`);
  }

  private layers(state: State) {
    return html`<div class="stack">
      <label>Show
        <select @change=${(event: Event) => this.show(layers[(event.target as HTMLSelectElement).selectedIndex]!.layer)}>
          ${layers.map(({ layer, label }) => html`<option ?selected=${layer === state.layer}>${label}</option>`)}
        </select>
      </label>
      ${this.legend(state)}
      <label class="check"><input type="checkbox" .checked=${state.arrows}
        @change=${(event: Event) => this.store.set({ arrows: (event.target as HTMLInputElement).checked })}>
        Arrows to parents</label></div>`;
  }

  private legend(state: State) {
    const range = this.runners[0]?.range;
    if (state.layer === '' || !range) {
      return html`<ul class="legend">
        <li><i style="background:var(--expanded)"></i>expanded</li>
        <li><i style="background:var(--frontier)"></i>frontier</li>
        <li><i style="background:var(--current)"></i>last expanded</li>
        <li><i class="line" style="background:var(--path)"></i>path</li></ul>`;
    }
    return html`<div class="ramp"><span>${number(range.least, 1)}</span><i></i><span>${number(range.greatest, 1)}</span></div>`;
  }

  private results(): [string, string][] {
    const outcome = this.runners[0]?.outcome;
    if (!outcome) return [];
    const bound = outcome.bound;
    const lines: [string, string][] = [];
    if (outcome.status === 'found') {
      lines.push(['Cost', number(outcome.cost!, 4)]);
      lines.push(['Guarantee', bound === 1 ? 'no path is cheaper' : typeof bound === 'number' ? `at most ${number(bound)} times the best` : 'none']);
    }
    return [...lines,
      ['Expanded', number(outcome.expanded)], ['Reached', number(outcome.generated)],
      ['Largest frontier', number(outcome.maxFrontier)], ['Time', duration(outcome.seconds)]];
  }

  private why() {
    const runner = this.runners[0];
    const text = runner?.failure?.error ?? runner?.outcome?.message;
    return text ? html`<p class="why">${text}.</p>` : nothing;
  }

  private cellFacts() {
    if (!this.pointed) return html`<p>Point at a cell, or move to the map with Tab and use the arrow keys.</p>`;
    const { cell, info } = this.pointed;
    return html`<lab-facts .lines=${cellInWords(cell, info, this.clock.step)}></lab-facts>`;
  }

  private newRunner(): Runner {
    return new Runner(this.module!, (runner) => this.answered(runner));
  }

  private async make(recipe: Recipe, undoable = true): Promise<void> {
    const generator = this.registry!.generators.find(({ name }) => name === recipe.generator)!;
    const maker = this.newRunner();
    const info = await maker.engine.call('generate', specOf(recipe.generator, recipe.options), recipe.width, recipe.height, recipe.seed);
    if ('error' in info) {
      maker.engine.end();
      return this.say(`${info.error}.`);
    }
    const cells = await maker.engine.call('cells');
    maker.engine.end();
    const corner = generator.freeCorner;
    const change: Partial<State> = {
      map: {
        name: `${recipe.generator}, seed ${recipe.seed}, ${info.width} × ${info.height} cells`,
        width: info.width, height: info.height, frame: info, cells, version: 0, recipe, original: cells.slice(),
      },
      start: centreOf(corner, corner),
      goal: centreOf(info.width - 1 - corner, info.height - 1 - corner),
    };
    this.unfitted = true;
    if (undoable) this.store.commit(change);
    else this.store.set(change);
  }

  private changed(state: State, before: State, stroke?: Stroke): void {
    if (stroke) for (const runner of this.runners) runner.edit(stroke);
    const again = state.map !== before.map || state.start !== before.start || state.goal !== before.goal ||
      state.runs !== before.runs || state.footprint !== before.footprint;
    if (again) this.plan(stroke !== undefined);
    this.requestUpdate();
  }

  private plan(lively = false): void {
    const { state } = this.store;
    state.runs.forEach((run, i) => this.runners[i]!.request(state, run, this.dragging || lively));
  }

  private answered(runner: Runner): void {
    if (!runner.busy) {
      const longest = Math.max(...this.runners.map(({ outcome }) => outcome?.steps ?? 0));
      if (!this.dragging || longest > 0) this.clock.restart(longest, this.play);
      this.play = false;
      this.say(outcomeInWords(this.store.state.runs[0]!.planner, runner.outcome, runner.failure));
    }
    this.requestUpdate();
  }

  private stepOf(_: number): number {
    return this.clock.step;
  }

  private choose(index: number, choice: Choice): void {
    this.store.commit({ runs: this.store.state.runs.map((run, i) => (i === index ? choice : run)) });
  }

  private async show(layer: Layer): Promise<void> {
    this.store.set({ layer });
    await Promise.all(this.runners.map((runner) => runner.show(layer)));
    this.requestUpdate();
  }

  private drag(active: boolean): void {
    this.dragging = active;
    if (!active) this.plan();
  }

  private point(pointed: Pointed | null): void {
    this.pointed = pointed;
    this.requestUpdate();
  }

  private key(event: KeyboardEvent): void {
    const target = event.composedPath()[0] as HTMLElement;
    if (/^(INPUT|SELECT|TEXTAREA)$/.test(target.tagName)) return;
    const control = event.ctrlKey || event.metaKey;
    const key = event.key.toLowerCase();
    if (control && key === 'z') event.shiftKey ? this.store.redo() : this.store.undo();
    else if (control && key === 'y') this.store.redo();
    else if (control || event.altKey) return;
    else if (key === 'p') this.clock.toggle();
    else if (key === '.') this.clock.move(1);
    else if (key === ',') this.clock.move(-1);
    else if (key === 'w') this.store.set({ tool: 'wall' });
    else if (key === 'c') this.store.set({ tool: 'cost' });
    else if (key === 'e') this.store.set({ tool: 'erase' });
    else if (key === 'm') this.store.set({ tool: 'look' });
    else return;
    event.preventDefault();
  }

  private fit(): void {
    const view = this.views()[0];
    const { map } = this.store.state;
    if (!view || !map || view.size.width === 0) return;
    this.unfitted = false;
    this.camera.fit(map, view.size.width, view.size.height);
    this.refreshViews();
  }

  private views(): MapView[] {
    return [...this.renderRoot.querySelectorAll<MapView>('lab-map')];
  }

  private refreshViews(): void {
    for (const view of this.views()) view.refresh();
  }

  private refreshAll(): void {
    this.requestUpdate();
  }

  private say(message: string): void {
    this.message = message;
    this.requestUpdate();
  }
}

customElements.define('wend-lab', App);
