// <lab-planner>: the planner of a search, its options from the registry, and what it guarantees.

import { html, LitElement, nothing } from 'lit';
import type { PlannerInfo, Registry } from '../engine/types';
import type { Choice } from '../store/state';
import { optionField, sentence, withOption } from './option_field';
import { panelStyle } from './style';

export class PlannerPanel extends LitElement {
  static override styles = panelStyle;
  static override properties = {
    registry: { attribute: false },
    choice: { attribute: false },
    heading: { type: String },
  };

  declare registry: Registry | null;
  declare choice: Choice;
  declare heading: string;

  override render() {
    const planner = this.registry?.planners.find(({ name }) => name === this.choice.planner);
    if (!this.registry || !planner) return nothing;
    return html`
      <div class="stack">
        <label>${this.heading}
          <select @change=${this.choosePlanner}>
            ${this.registry.planners.map(({ name, summary, needsIndex }) => html`
              <option value=${name} ?selected=${name === planner.name}
                title=${summary}>${name}${needsIndex ? ' (builds an index)' : ''}</option>`)}
          </select>
        </label>
        <p>${sentence(planner.summary)}</p>
        ${planner.options.length === 0 ? nothing : html`
          <details>
            <summary>Options</summary>
            <div class="stack">${planner.options.map((option) => optionField(option, this.choice.options[option.name],
              (value) => this.choose({ ...this.choice, options: withOption(this.choice.options, option.name, value) })))}</div>
          </details>`}
        <details>
          <summary>Guarantee and paper</summary>
          <div class="stack">${notes(planner).map((note) => html`<p>${note}</p>`)}</div>
        </details>
      </div>`;
  }

  private choosePlanner(event: Event): void {
    this.choose({ planner: (event.target as HTMLSelectElement).value, options: {} });
  }

  private choose(choice: Choice): void {
    this.dispatchEvent(new CustomEvent('choose', { detail: choice }));
  }
}

function notes(planner: PlannerInfo): string[] {
  return [
    sentence(planner.idea),
    `Guarantee: ${sentence(planner.guaranteeText)}`,
    sentence(planner.when),
    sentence(planner.citation),
  ].filter((note) => note !== '');
}

customElements.define('lab-planner', PlannerPanel);
