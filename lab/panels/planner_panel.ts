// <lab-planner>: the planner of a search, its options from the registry, and what it guarantees.

import { html, LitElement, nothing } from 'lit';
import type { OptionInfo, PlannerInfo, Registry } from '../engine/types';
import type { Choice } from '../store/state';
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
            <div class="stack">${planner.options.map((option) => this.field(option))}</div>
          </details>`}
        <details>
          <summary>Guarantee and paper</summary>
          <div class="stack">${notes(planner).map((note) => html`<p>${note}</p>`)}</div>
        </details>
      </div>`;
  }

  private field(option: OptionInfo) {
    const value = this.choice.options[option.name] ?? option.default;
    const change = (event: Event) => this.setOption(option, (event.target as HTMLInputElement).value);
    if (option.kind === 'flag') {
      return html`<label class="check" title=${option.help}>
        <input type="checkbox" .checked=${value === 'true'}
          @change=${(event: Event) => this.setOption(option, String((event.target as HTMLInputElement).checked))}>
        ${words(option.name)}</label>`;
    }
    if (option.kind === 'choice') {
      return html`<label title=${option.help}>${words(option.name)}
        <select @change=${change}>
          ${option.choices.map((name) => html`<option ?selected=${name === value}>${name}</option>`)}
        </select></label>`;
    }
    return html`<label title=${option.help}>${words(option.name)}
      <input type="number" .value=${value} min=${option.least} max=${option.greatest}
        step=${option.kind === 'integer' ? 1 : 'any'} @change=${change}></label>`;
  }

  private choosePlanner(event: Event): void {
    this.choose({ planner: (event.target as HTMLSelectElement).value, options: {} });
  }

  private setOption(option: OptionInfo, value: string): void {
    const { [option.name]: _, ...others } = this.choice.options;
    const options = value === option.default || value === '' ? others : { ...others, [option.name]: value };
    this.choose({ ...this.choice, options });
  }

  private choose(choice: Choice): void {
    this.dispatchEvent(new CustomEvent('choose', { detail: choice }));
  }
}

function words(name: string): string {
  return sentence(name.replaceAll('_', ' '), '');
}

export function sentence(text: string, stop = '.'): string {
  return text === '' ? '' : text[0]!.toUpperCase() + text.slice(1) + (/[.?!]$/.test(text) ? '' : stop);
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
