// <wend-lab map="rooms" size="61x35" seed="3" planner="astar dijkstra">: a replay for articles and documentation. Its
// attributes are the parts of a link that is written by hand (store/query_link.ts); several planners or walls have
// blanks between them. Works once it is scrolled into view.

import { css, html, LitElement } from 'lit';
import { load } from '../engine/program';
import { Searches } from '../engine/searches';
import type { Failure } from '../engine/types';
import { Clock } from '../store/clock';
import { readLink } from '../store/link';
import { fromLink } from '../store/maps';
import { queryNames } from '../store/query_link';
import { Store } from '../store/store';
import { Camera } from '../view/camera';
import '../view/map_view';
import type { MapView } from '../view/map_view';
import { dark, light } from '../view/palette';
import { panelStyle } from './style';
import { theme } from './theme';
import './transport';
import { outcomeInWords } from './words';

/** The address of this script: the lab lies beside it. */
const here: string = import.meta.url;

export class Embed extends LitElement {
  static override styles = [panelStyle, theme, css`
    :host { display: block; border: 1px solid var(--line); border-radius: 8px; overflow: hidden; background: var(--page); }
    .views { display: grid; gap: 1px; background: var(--line); grid-template-columns: repeat(auto-fit, minmax(15rem, 1fr)); }
    figure { margin: 0; position: relative; height: 20rem; background: var(--map); }
    lab-map { height: 100%; }
    figcaption { position: absolute; z-index: 1; left: 0.5rem; top: 0.4rem; padding: 0.05rem 0.45rem; border-radius: 4px;
      font-size: 0.8125rem; background: var(--page); color: var(--ink); pointer-events: none; }
    footer { padding: 0.5rem 0.75rem; border-top: 1px solid var(--line); }
    p { margin: 0; padding: 0.5rem 0.75rem; font-size: 0.8125rem; }
    a { color: var(--accent); }
  `];
  private readonly store = new Store();
  private readonly clock = new Clock();
  private readonly camera = new Camera();
  private readonly scheme = matchMedia('(prefers-color-scheme: dark)');
  private readonly recolour = () => this.requestUpdate();
  private readonly observer = new IntersectionObserver((entries) => { if (entries.some(({ isIntersecting }) => isIntersecting)) void this.begin(); });
  private searches: Searches | null = null;
  /** Of its attributes; none before the lab is loaded. */
  private names: string[] = [];
  private fault = '';
  private dragging = false;
  private begun = false;
  private step: number | null = null;
  private frame = 0;
  private quiet: (() => void)[] = [];

  override connectedCallback(): void {
    super.connectedCallback();
    this.observer.observe(this);
    this.scheme.addEventListener('change', this.recolour);
  }
  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.observer.disconnect();
    this.scheme.removeEventListener('change', this.recolour);
    cancelAnimationFrame(this.frame);
    for (const end of this.quiet) end();
    this.quiet = [];
    this.searches?.end();
    this.searches = null;
    this.begun = false;
  }

  /** The link that the attributes stand for. */
  private get link(): string {
    const fields = new URLSearchParams();
    for (const name of this.names) {
      const value = this.getAttribute(name);
      if (value === null) continue;
      const words = name === 'planner' || name === 'wall' ? value.trim().split(/\s+/) : [value];
      for (const word of words) fields.append(name, word);
    }
    return fields.toString();
  }

  private async begin(): Promise<void> {
    if (this.begun) return;
    this.begun = true;
    this.observer.disconnect();
    const programs = await load();
    const { registry } = programs;
    this.names = queryNames(registry);
    const linked = readLink(this.link || 'map=rooms', registry);
    if (typeof linked === 'string') return this.say(`${linked}.`);
    this.searches = new Searches(programs, this.clock, (all) => this.answered(all));
    this.step = linked.step;
    const change = await fromLink(linked, registry, (recipe) => this.searches!.make(recipe));
    if ('error' in change) return this.say(`${(change as Failure).error}.`);
    this.store.set({ ...change, exercise: '' });
    this.quiet = [
      this.store.listen((state, before, stroke) => {
        this.searches?.update(state, before, stroke, this.dragging);
        this.requestUpdate();
      }),
      this.clock.listen(() => this.refresh()),
    ];
    this.searches.request(this.store.state);
    const tick = (now: number) => {
      this.clock.tick(now);
      this.frame = requestAnimationFrame(tick);
    };
    this.frame = requestAnimationFrame(tick);
    this.requestUpdate();
  }

  private answered(all: boolean): void {
    if (all) {
      const { longest } = this.searches!;
      const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
      if (!this.dragging || longest > 0) this.clock.restart(longest, this.step === null && !calm && this.clock.length === 0);
      if (this.step !== null) this.clock.seek(this.step);
      this.step = null;
    }
    this.requestUpdate();
  }

  override render() {
    if (this.fault) return html`<p role="alert">${this.fault}</p>`;
    const { searches, store } = this;
    if (!searches || !store.state.map) return html`<p>The search appears here.</p>`;
    return html`
      <div class="views">${store.state.runs.map(({ planner }, i) => html`<figure><figcaption>${planner}</figcaption>
        <lab-map .store=${store} .clock=${this.clock} .runner=${searches.runners[i]!} .camera=${this.camera} .embedded=${true}
          .colours=${this.scheme.matches ? dark : light} .stepOf=${() => searches.stepOf(i, store.state)}
          label="Map with the search of ${planner}. Drag start, goal and obstacles."
          @camera=${() => this.refresh()} @resized=${() => this.fit()}
          @drag=${(event: CustomEvent<boolean>) => this.drag(event.detail)}></lab-map></figure>`)}</div>
      <footer><lab-transport .clock=${this.clock}></lab-transport></footer>
      <p>${store.state.runs.map(({ planner }, i) => outcomeInWords(planner, searches.runners[i]!.outcome, searches.runners[i]!.failure)).join(' ')}
        <a href=${new URL(`./index.html#${this.link}`, here).href}>Open in the lab</a></p>`;
  }

  override updated(): void {
    this.refresh();
  }

  private drag(active: boolean): void {
    this.dragging = active;
    if (!active) this.searches?.request(this.store.state);
  }

  private fit(): void {
    const view = this.views()[0];
    const { map } = this.store.state;
    if (!view || !map || view.size.width === 0) return;
    this.camera.fit(map, view.size.width, view.size.height);
    this.refresh();
  }

  private views(): MapView[] {
    return [...this.renderRoot.querySelectorAll<MapView>('lab-map')];
  }
  private refresh(): void {
    for (const view of this.views()) view.refresh();
  }

  private say(fault: string): void {
    this.fault = fault;
    this.requestUpdate();
  }
}

customElements.define('wend-lab', Embed);
