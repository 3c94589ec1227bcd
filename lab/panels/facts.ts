// <lab-facts>: the result of a search, or a cell, as names and values.

import { css, html, LitElement } from 'lit';
import { panelStyle } from './style';

export class Facts extends LitElement {
  static override styles = [panelStyle, css`
    dl { display: grid; grid-template-columns: auto 1fr; gap: 0.3rem 1rem; margin: 0; font-size: 0.875rem; }
    dt { color: var(--faint); }
    dd { margin: 0; text-align: right; font-variant-numeric: tabular-nums; }
  `];
  static override properties = { lines: { attribute: false } };

  declare lines: [string, string][];

  override render() {
    return html`<dl>${this.lines.map(([name, value]) => html`<dt>${name}</dt><dd>${value}</dd>`)}</dl>`;
  }
}

customElements.define('lab-facts', Facts);
