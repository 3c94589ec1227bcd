// An option or a field from the registry as a control: a box to tick, a list or a number.

import { html } from 'lit';
import type { OptionInfo } from '../engine/types';

/** The control, with what is chosen; empty: nothing. `change` gets the value as the engine takes it, or an empty text for the default. */
export function optionField(option: OptionInfo, chosen: string | undefined, change: (value: string) => void, unit = '') {
  const value = chosen ?? option.default;
  const changed = (text: string) => change(text === option.default ? '' : text);
  const name = sentence(option.name.replaceAll('_', ' '), '') + (unit === '' ? '' : `, ${unit}`);
  if (option.kind === 'flag') {
    return html`<label class="check" title=${option.help}>
      <input type="checkbox" .checked=${value === 'true'}
        @change=${(event: Event) => changed(String((event.target as HTMLInputElement).checked))}>
      ${name}</label>`;
  }
  if (option.kind === 'choice') {
    return html`<label title=${option.help}>${name}
      <select @change=${(event: Event) => changed((event.target as HTMLSelectElement).value)}>
        ${option.default === '' ? html`<option value="" ?selected=${value === ''}>as usual</option>` : ''}
        ${option.choices.map((each) => html`<option ?selected=${each === value}>${each}</option>`)}
      </select></label>`;
  }
  return html`<label title=${option.help}>${name}
    <input type="number" .value=${value} min=${option.least} max=${option.greatest ?? ''}
      step=${option.kind === 'integer' ? 1 : 'any'}
      @change=${(event: Event) => changed((event.target as HTMLInputElement).value)}></label>`;
}

/** Options with another value of one of them; an empty value is its default. */
export function withOption(options: Record<string, string>, name: string, value: string): Record<string, string> {
  const { [name]: _, ...others } = options;
  return value === '' ? others : { ...others, [name]: value };
}

export function sentence(text: string, stop = '.'): string {
  return text === '' ? '' : text[0]!.toUpperCase() + text.slice(1) + (/[.?!]$/.test(text) ? '' : stop);
}
