// <wend-lab-page>: the page: wires the store, the clock, the searches, the views and the panels.

import { html, LitElement, nothing } from 'lit';
import { Extras } from '../engine/extras';
import type { Programs } from '../engine/program';
import { Searches } from '../engine/searches';
import type { Failure, Layer, Registry } from '../engine/types';
import type { ScenarioQuery } from '../formats/moving_ai';
import { Clock } from '../store/clock';
import { readLink } from '../store/link';
import { firstRecipe, fromLink, fromRecipe } from '../store/maps';
import { endsAtClosest, leadsOut, type Choice, type Recipe, type State } from '../store/state';
import { Store, type Stroke } from '../store/store';
import { Lesson } from '../exercises/lesson';
import { Camera, type Point } from '../view/camera';
import '../view/map_view';
import type { MapView, Pointed } from '../view/map_view';
import { dark, light } from '../view/palette';
import { appStyle } from './app_style';
import { save, stateOfFiles } from './desk';
import type { Saved } from './file_panel';
import { keyed } from './keys';
import { share } from './share';
import './side';
import type { Actions } from './side';
import { panelStyle } from './style';
import { theme } from './theme';
import './tools_panel';
import './transport';
import { movedInWords, number, outcomeInWords } from './words';

export class App extends LitElement implements Actions {
  static override styles = [panelStyle, theme, appStyle];

  private readonly store = new Store();
  private readonly clock = new Clock();
  private readonly camera = new Camera();
  private readonly scheme = matchMedia('(prefers-color-scheme: dark)');
  private readonly calm = matchMedia('(prefers-reduced-motion: reduce)');
  private searches!: Searches;
  private registry: Registry | null = null;
  private pointed: Pointed | null = null;
  /** For screen readers. */
  private message = '';
  /** Shown until the visitor closes it, edits the map or gets the next one. */
  private notice = '';
  private dragging = false;
  private play = false;
  /** The step that a link asks for, once its searches are done. */
  private step: number | null = null;
  private unfitted = true;
  private queries: ScenarioQuery[] = [];
  private extras!: Extras;
  private lesson!: Lesson;
  private drawn = 0;

  /** Begins with the compiled engine, and the text of a link. */
  async begin(programs: Programs, link: string): Promise<void> {
    const { registry } = programs;
    this.registry = registry;
    this.searches = new Searches(programs, this.clock, (all) => this.answered(all));
    this.lesson = new Lesson(this.store, this.clock, () => this.searches, registry, (message) => this.say(message));
    this.extras = new Extras(this.searches, this.clock, () => this.requestUpdate());
    this.extras.clock.listen(() => this.refreshViews());
    this.store.listen((state, before, stroke) => this.changed(state, before, stroke));
    this.clock.listen(() => this.refreshViews());
    this.scheme.addEventListener('change', () => this.requestUpdate());
    addEventListener('keydown', (event) => keyed(event, this.store, this.clock));
    addEventListener('hashchange', () => this.open(location.hash.slice(1)));
    this.play = !this.calm.matches;
    if (link === '' || !await this.open(link)) await this.make(firstRecipe, false);
    const frame = (now: number) => {
      this.clock.tick(now);
      this.extras.clock.tick(now);
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  override render() {
    const { state } = this.store;
    if (!this.registry || !state.map) return html`<p class="wait">Loading the planners</p>`;
    return html`
      <header>
        <h1>wend lab</h1>
        <lab-tools .store=${this.store}></lab-tools>
        <span class="space"></span>
        <button @click=${this.share} title="A link to this map, these planners and this step">Share link</button>
      </header>
      <main aria-busy=${this.searches.busy}>
        <section class="views" @dragover=${(event: DragEvent) => event.preventDefault()} @drop=${this.drop}
          data-count=${state.runs.length} aria-label="Maps">
          ${state.runs.map((run, i) => this.view(run, i))}
        </section>
        <aside aria-label="Settings">
          <lab-side .store=${this.store} .clock=${this.clock} .registry=${this.registry} .searches=${this.searches} .lesson=${this.lesson} .extras=${this.extras}
            .actions=${this} .queries=${this.queries} .pointed=${this.pointed} version=${++this.drawn}></lab-side>
        </aside>
      </main>
      <footer><lab-transport .clock=${this.clock}></lab-transport></footer>
      <p class="live" role="status">${this.message}</p>
      ${this.notice && html`<p class="notice" role="alert">${this.notice}
        <button @click=${() => this.notify('')} aria-label="Close this message">×</button></p>`}`;
  }

  override updated(): void {
    if (this.unfitted) this.fit();
    this.refreshViews();
  }

  private view(run: Choice, i: number) {
    const colours = this.scheme.matches ? dark : light;
    const many = this.store.state.runs.length > 1;
    const { failure, outcome } = this.searches.runners[i]!;
    const reason = failure?.error ?? outcome?.message;
    return html`<figure>
      ${many ? html`<figcaption>${run.planner}${outcome?.cost === undefined ? nothing : html`<span>${number(outcome.cost)}, ${number(outcome.expanded)} expanded</span>`}</figcaption>` : nothing}
      ${reason ? html`<p class="reason">${reason}.</p>` : nothing}
      <lab-map .store=${this.store} .clock=${this.clock} .runner=${this.searches.runners[i]!} .camera=${this.camera}
        .headings=${this.turns(run.planner)} .extras=${i === 0 ? this.extras : null}
        .colours=${colours} .stepOf=${() => this.searches.stepOf(i, this.store.state)}
        label="Map with the search of ${run.planner}. Arrow keys move the cursor, space paints, S and G set start and goal."
        @camera=${() => this.refreshViews()} @resized=${() => this.fit()}
        @answer=${(event: CustomEvent<Point>) => this.name(event.detail)}
        @drag=${(event: CustomEvent<boolean>) => this.drag(event.detail)}
        @pointed=${(event: CustomEvent<Pointed | null>) => this.point(event.detail)}></lab-map></figure>`;
  }

  stepOfPointed(): number {
    const index = this.searches.runners.findIndex((runner) => runner === this.pointed?.runner);
    return this.searches.stepOf(index, this.store.state);
  }

  async make(recipe: Recipe, undoable = true): Promise<void> {
    this.queries = [];
    this.take(await fromRecipe(recipe, this.registry!, (each) => this.searches.make(each)), undoable);
  }

  /** Opens a link; says why if it cannot, and leaves all as it is. */
  private async open(link: string): Promise<boolean> {
    const linked = readLink(link, this.registry!);
    if (typeof linked === 'string') {
      this.notify(`${linked}.`);
      return false;
    }
    const change = await fromLink(linked, this.registry!, (each) => this.searches.make(each));
    this.step = 'error' in change ? null : linked.step;
    return this.take(change, this.store.state.map !== null);
  }

  async openFiles(files: File[]): Promise<void> {
    const opened = await stateOfFiles(files, this.store.state);
    if (typeof opened === 'string') return this.notify(`${opened}.`);
    this.queries = opened.queries;
    this.take(opened.change, true);
    this.notify(opened.notes.join(' '));
  }

  seek(run: number, step: number): void {
    this.clock.playing = false;
    this.clock.seek(this.searches.clockOf(run, step, this.store.state));
  }

  /** Another robot. Ends where it does not fit move to where it does, but for those that a path may lead out of or past. */
  async shape(footprint: string): Promise<void> {
    const { state } = this.store;
    const places = await this.searches.runners[0]!.places(state, footprint, this.turns(state.runs[0]!.planner));
    if ('error' in places) return this.store.commit({ footprint });
    const start = leadsOut(state) ? state.start : places.start;
    const goal = endsAtClosest(state) ? state.goal : places.goal;
    this.store.commit({ footprint, start, goal });
    this.notify(movedInWords(state, { start, goal }));
  }

  /** Does a planner know headings? */
  private turns(planner: string): boolean {
    return this.registry!.planners.some(({ name, headings }) => name === planner && headings);
  }

  private drop(event: DragEvent): void {
    event.preventDefault();
    void this.openFiles([...(event.dataTransfer?.files ?? [])]);
  }

  async save(what: Saved): Promise<void> {
    this.notify(await save(what, this.store.state, this.views()[0]));
  }

  /** A new map, unless there is none, for a reason. */
  private take(change: Partial<State> | Failure, undoable: boolean): boolean {
    if ('error' in change) {
      this.notify(`${change.error}.`);
      return false;
    }
    this.unfitted = true;
    if (undoable) this.store.commit(change);
    else this.store.set(change);
    return true;
  }

  private changed(state: State, before: State, stroke?: Stroke): void {
    this.searches.update(state, before, stroke, this.dragging);
    if (stroke) this.notice = '';
    if (!this.searches.busy) void this.extras.ask(state, before);
    this.requestUpdate();
  }

  private answered(all: boolean): void {
    if (all) {
      this.lesson.answered();
      if (this.dragging) this.extras.clear();
      else void this.extras.ask(this.store.state, null);
      const { longest } = this.searches;
      if (!this.dragging || longest > 0) this.clock.restart(longest, this.play && this.step === null);
      if (this.step !== null) this.clock.seek(this.step);
      this.step = null;
      this.play = false;
      this.say(this.store.state.runs.map(({ planner }, i) => {
        const runner = this.searches.runners[i]!;
        return outcomeInWords(planner, runner.outcome, runner.failure);
      }).join(' '));
    }
    this.requestUpdate();
  }

  async show(layer: Layer): Promise<void> {
    this.store.set({ layer });
    await this.searches.show(layer);
    this.requestUpdate();
  }

  private drag(active: boolean): void {
    this.dragging = active;
    if (!active) this.searches.request(this.store.state);
  }

  /** The answer to an exercise. */
  private async name(cell: Point): Promise<void> {
    await this.lesson.cell(cell);
    this.requestUpdate();
  }

  async share(): Promise<void> {
    this.notify(await share(this.store.state, this.clock.step));
  }

  private point(pointed: Pointed | null): void {
    this.pointed = pointed;
    this.requestUpdate();
  }

  fitSoon(): void {
    this.unfitted = true;
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

  say(message: string): void {
    this.message = message;
    this.requestUpdate();
  }

  private notify(notice: string): void {
    this.notice = notice;
    this.requestUpdate();
  }
}

customElements.define('wend-lab-page', App);
