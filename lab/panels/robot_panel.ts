// <lab-robot>: the shape of the robot, the headings of start and goal, what a path does where the robot cannot be, and
// smoothing.

import { html, LitElement, nothing } from 'lit';
import type { Failure, FieldInfo, Registry, Widest } from '../engine/types';
import { fieldsOfThePage, type Place, type State } from '../store/state';
import type { Store } from '../store/store';
import { type Rectangle, rectangleOf, rectangleText } from '../view/footprint';
import { optionField, sentence, withOption } from './option_field';
import { panelStyle } from './style';
import { number } from './words';

type Shape = 'point' | 'disc' | 'rectangle' | 'polygon';

const firstPolygon = (unit: number) =>
  [[1, 0.6], [1, -0.6], [-1, -0.6], [-1, 0.6]].map(([x, y]) => `${x! * unit},${y! * unit}`).join('; ');

const firstRectangle = (unit: number): Rectangle => ({ length: 2 * unit, width: 1.2 * unit, ahead: 0 });

export class RobotPanel extends LitElement {
  static override styles = panelStyle;
  static override properties = {
    store: { attribute: false }, registry: { attribute: false }, state: { attribute: false }, widest: { attribute: false },
  };

  declare store: Store;
  declare registry: Registry;
  declare state: State;
  declare widest: Widest | Failure | null;

  override render() {
    const { footprint, smoother, runs, map } = this.state;
    const shape = shapeOf(footprint);
    const unit = map?.frame.metric ? 'm' : 'cells';
    const turns = runs.some(({ planner }) => this.registry.planners.find(({ name }) => name === planner)?.headings);
    return html`<div class="stack">
      <label>Shape
        <select @change=${this.chooseShape}>
          ${(['point', 'disc', 'rectangle', 'polygon'] as Shape[]).map((name) => html`
            <option value=${name} ?selected=${name === shape}>${sentence(name, '')}</option>`)}
        </select></label>
      ${shape === 'disc' ? html`<label>Radius in ${unit}
        <input type="number" min="0" step="any" .value=${footprint.slice(5)}
          @change=${(event: Event) => this.set(`disc:${Math.max(Number(valueOf(event)), 0)}`)}></label>` : nothing}
      ${shape === 'rectangle' ? this.rectangle(rectangleOf(footprint) ?? firstRectangle(1), unit) : nothing}
      ${shape === 'polygon' ? html`<label>Corners in ${unit}, seen from the base point
        <input .value=${footprint} @change=${(event: Event) => this.set(valueOf(event))}></label>` : nothing}
      ${turns ? html`<div class="row">
        ${this.heading('start', 'Start heading')}
        ${this.heading('goal', 'Goal heading')}</div>
        <label class="check"><input type="checkbox" .checked=${this.state.headings}
          @change=${(event: Event) => this.store.commit({ headings: (event.target as HTMLInputElement).checked })}>
          The goal's heading counts</label>` : nothing}
      <details ?open=${Object.keys(this.state.robotFields).length > 0}>
        <summary>What blocks the robot</summary>
        ${this.fields('robotFields', unit)}</details>
      <details ?open=${Object.keys(this.state.requestFields).length > 0}>
        <summary>What is asked</summary>
        ${this.fields('requestFields', unit)}</details>
      <label>Smooth the path
        <select @change=${(event: Event) => this.store.commit({ smoother: valueOf(event) })}>
          <option value="" ?selected=${smoother === ''}>No</option>
          ${this.registry.smoothers.map(({ name, summary }) => html`
            <option value=${name} title=${summary} ?selected=${smoother.split(':')[0] === name}>${sentence(name, '')}</option>`)}
        </select></label>
      ${this.smootherOptions(smoother)}
      <label class="check"><input type="checkbox" .checked=${this.state.widest}
        @change=${(event: Event) => this.store.set({ widest: (event.target as HTMLInputElement).checked })}>
        Show the widest path</label>
      ${this.state.widest && this.widest ? html`<p>${this.widestInWords(this.widest, unit)}</p>` : nothing}
    </div>`;
  }

  /** For the largest robot that gets through. */
  private widestInWords(widest: Widest | Failure, unit: string): string {
    if ('error' in widest) return sentence(widest.error);
    if (!widest.joined) return 'No robot gets from the start to the goal, not even a point.';
    if (widest.radius === null) return 'No obstacle limits the size of the robot.';
    const { frame } = this.state.map!;
    const scale = frame.metric ? frame.resolution : 1;
    return `A disc of radius ${number(widest.radius * scale, 3)} ${unit} gets through, a larger one does not. Its narrowest place is at ` +
      `cell (${Math.floor(widest.x)}, ${Math.floor(widest.y)}).`;
  }

  private rectangle(sides: Rectangle, unit: string) {
    const input = (label: string, side: keyof Rectangle, least: string) => html`
      <label>${label} in ${unit}
        <input type="number" min=${least} step="any" .value=${String(sides[side])}
          @change=${(event: Event) => this.set(rectangleText({ ...sides, [side]: Number(valueOf(event)) }))}></label>`;
    return html`<div class="row">${input('Length', 'length', '0')}${input('Width', 'width', '0')}</div>
      ${input('Its centre lies ahead of the base point by', 'ahead', '')}`;
  }

  /** A list of the registry; each control says below what it is. */
  private fields(list: 'robotFields' | 'requestFields', unit: string) {
    const given = this.state[list];
    const control = (field: FieldInfo) => html`<div class="field">
      ${optionField(field, given[field.name], (value) => this.store.commit({ [list]: withOption(given, field.name, value) }),
                    field.unit === 'm' ? unit : field.unit)}
      <p>${sentence(field.help)}</p></div>`;
    return html`<div class="stack">${this.registry[list].filter(({ name }) => !fieldsOfThePage.has(name)).map(control)}</div>`;
  }

  private heading(end: 'start' | 'goal', label: string) {
    const degrees = Math.round((this.state[end].heading * 180) / Math.PI);
    return html`<label>${label}, ${degrees}°
      <input type="range" min="-180" max="180" step="5" .value=${String(degrees)}
        @change=${(event: Event) => {
          const place: Place = { ...this.state[end], heading: (Number(valueOf(event)) * Math.PI) / 180 };
          this.store.commit({ [end]: place });
        }}></label>`;
  }

  private smootherOptions(smoother: string) {
    const [name, list] = smoother.split(':');
    const info = this.registry.smoothers.find((each) => each.name === name);
    if (!info) return nothing;
    const given = new Map((list ?? '').split(',').filter((word) => word !== '').map((word) => word.split('=') as [string, string]));
    const set = (option: string, value: string) => {
      given.set(option, value);
      this.store.commit({ smoother: `${name}:${[...given].map((pair) => pair.join('=')).join(',')}` });
    };
    return html`<div class="row">${info.options.filter(({ kind }) => kind === 'number').slice(0, 4).map((option) => html`
      <label title=${option.help}>${sentence(option.name.replaceAll('_', ' '), '')}
        <input type="number" step="any" min=${option.least} max=${option.greatest}
          .value=${given.get(option.name) ?? option.default}
          @change=${(event: Event) => set(option.name, valueOf(event))}></label>`)}</div>`;
  }

  private chooseShape(event: Event): void {
    const shape = valueOf(event) as Shape;
    // Two cells across, to begin with.
    const cell = this.state.map?.frame.metric ? this.state.map.frame.resolution : 1;
    const first: Record<Shape, string> = {
      point: 'point', disc: `disc:${cell}`, rectangle: rectangleText(firstRectangle(cell)), polygon: firstPolygon(cell),
    };
    this.set(first[shape]);
  }

  private set(footprint: string): void {
    this.dispatchEvent(new CustomEvent('shape', { detail: footprint }));
  }
}

export function shapeOf(footprint: string): Shape {
  if (footprint === 'point') return 'point';
  if (footprint.startsWith('disc:')) return 'disc';
  return rectangleOf(footprint) ? 'rectangle' : 'polygon';
}

function valueOf(event: Event): string {
  return (event.target as HTMLInputElement).value;
}

customElements.define('lab-robot', RobotPanel);
