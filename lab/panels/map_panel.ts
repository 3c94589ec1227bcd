// <lab-map-panel>: a map from a generator, and its seed.

import { css, html, LitElement, nothing } from 'lit';
import type { GeneratorInfo, Registry } from '../engine/types';
import type { Recipe } from '../store/state';
import { sentence } from './option_field';
import { panelStyle } from './style';

export class MapPanel extends LitElement {
  static override styles = [panelStyle, css`.row button { flex: 0 0 auto; }`];
  static override properties = {
    registry: { attribute: false },
    recipe: { attribute: false },
    name: { type: String },
  };

  declare registry: Registry | null;
  declare recipe: Recipe;
  declare name: string;

  override render() {
    const generator = this.generator(this.recipe.generator);
    if (!generator) return nothing;
    return html`
      <div class="stack">
        <label>Kind
          <select @change=${this.chooseKind}>
            ${this.registry!.generators.map(({ name }) => html`
              <option value=${name} ?selected=${name === generator.name}>${sentence(name.replaceAll('_', ' '), '')}</option>`)}
          </select>
        </label>
        <div class="row">
          ${this.number('Columns', 'width', generator.leastWidth, 4096)}
          ${this.number('Rows', 'height', generator.leastHeight, 4096)}
          ${this.number('Seed', 'seed', 0, 4294967295)}
          <button title="The same kind with the next seed" @click=${() => this.make({ seed: this.recipe.seed + 1 })}>Another</button>
        </div>
        <p>${this.name}</p>
      </div>`;
  }

  private number(label: string, key: 'width' | 'height' | 'seed', least: number, most: number) {
    return html`<label>${label}
      <input type="number" min=${least} max=${most} .value=${String(this.recipe[key])}
        @change=${(event: Event) => {
          const value = Math.round(Number((event.target as HTMLInputElement).value));
          this.make({ [key]: Math.min(Math.max(value, least), most) });
        }}></label>`;
  }

  private generator(name: string): GeneratorInfo | undefined {
    return this.registry?.generators.find((generator) => generator.name === name);
  }

  private chooseKind(event: Event): void {
    const generator = this.generator((event.target as HTMLSelectElement).value)!;
    this.make({
      generator: generator.name, options: {}, width: generator.defaultWidth, height: generator.defaultHeight,
    });
  }

  private make(change: Partial<Recipe>): void {
    this.dispatchEvent(new CustomEvent('make', { detail: { ...this.recipe, ...change } }));
  }
}

customElements.define('lab-map-panel', MapPanel);
