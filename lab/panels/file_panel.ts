// <lab-files>: opens maps and queries, saves the map, the path and pictures.

import { html, LitElement, nothing } from 'lit';
import type { ScenarioQuery } from '../formats/moving_ai';
import { number } from './words';
import { panelStyle } from './style';

export type Saved = 'map' | 'path' | 'png' | 'svg' | 'gif' | 'trace';

export class FilePanel extends LitElement {
  static override styles = panelStyle;
  static override properties = { queries: { attribute: false } };

  declare queries: ScenarioQuery[];

  override render() {
    return html`<div class="stack">
      <label>Open a map (map.yaml with its image, .map, .scen, text, image)
        <input type="file" multiple @change=${this.open}></label>
      ${this.queries.length > 0 ? html`<label>Query of the scenario
        <select @change=${(event: Event) => this.tell('query', (event.target as HTMLSelectElement).selectedIndex)}>
          ${this.queries.slice(0, 2000).map(({ start, goal, length }) => html`
            <option>(${start[0]}, ${start[1]}) to (${goal[0]}, ${goal[1]}), length ${number(length, 2)}</option>`)}
        </select></label>` : nothing}
      <div class="row">
        ${this.button('map', 'Save map')}${this.button('path', 'Path CSV')}
        ${this.button('png', 'PNG')}${this.button('svg', 'SVG')}
        ${this.button('gif', 'GIF')}${this.button('trace', 'Posthoc trace')}</div></div>`;
  }

  private button(what: Saved, label: string) {
    return html`<button @click=${() => this.tell('save', what)}>${label}</button>`;
  }

  private open(event: Event): void {
    const input = event.target as HTMLInputElement;
    this.tell('open', [...(input.files ?? [])]);
    input.value = '';
  }

  private tell(name: string, detail: unknown): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
}

customElements.define('lab-files', FilePanel);
