// <lab-tools>: what the pointer does on the map; undo and redo.

import { css, html, LitElement, nothing } from 'lit';
import type { Tool } from '../store/state';
import type { Store } from '../store/store';
import { panelStyle } from './style';

const tools: { tool: Tool; label: string; title: string }[] = [
  { tool: 'wall', label: 'Wall', title: 'Drag over cells to make obstacles; begin on an obstacle to remove some (W)' },
  { tool: 'cost', label: 'Cost', title: 'Drag over cells to make them cost more (C)' },
  { tool: 'erase', label: 'Erase', title: 'Drag over cells to free them (E)' },
  { tool: 'break', label: 'Break-point', title: 'Choose a cell: playing stops where it is expanded (B on the map sets it at the cursor)' },
  { tool: 'look', label: 'Move map', title: 'Drag to move the map; the wheel or two fingers zoom (M)' },
];

export class ToolsPanel extends LitElement {
  static override styles = [panelStyle, css`
    :host { display: flex; gap: 0.35rem; align-items: center; flex-wrap: wrap; }
    .group { display: flex; }
    .group button { border-radius: 0; margin-left: -1px; }
    .group button:first-child { border-radius: 6px 0 0 6px; margin: 0; }
    .group button:last-child { border-radius: 0 6px 6px 0; }
    label { display: flex; align-items: center; gap: 0.4rem; }
    input { width: 4.2rem !important; }
  `];
  static override properties = { store: { attribute: false } };

  declare store: Store;
  private quiet: (() => void) | undefined;

  override connectedCallback(): void {
    super.connectedCallback();
    this.quiet = this.store.listen(() => this.requestUpdate());
  }
  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.quiet?.();
  }

  override render() {
    const { tool, brush, cost } = this.store.state;
    return html`
      <div class="group" role="radiogroup" aria-label="Tool">
        ${tools.map((each) => html`
          <button role="radio" aria-checked=${tool === each.tool} title=${each.title}
            @click=${() => this.store.set({ tool: each.tool })}>${each.label}</button>`)}
      </div>
      ${tool === 'look' || tool === 'break' ? nothing : html`<label>Brush
        <input type="number" min="1" max="64" .value=${String(brush)}
          @change=${(event: Event) => this.store.set({ brush: numberIn(event, 1, 64) })}></label>`}
      ${tool !== 'cost' ? nothing : html`<label>Cost
        <input type="number" min="2" max="254" .value=${String(cost)}
          @change=${(event: Event) => this.store.set({ cost: numberIn(event, 2, 254) })}></label>`}
      <div class="group">
        <button title="Undo (Ctrl+Z)" ?disabled=${!this.store.canUndo} @click=${() => this.store.undo()}>Undo</button>
        <button title="Redo (Ctrl+Shift+Z)" ?disabled=${!this.store.canRedo} @click=${() => this.store.redo()}>Redo</button>
      </div>`;
  }
}

function numberIn(event: Event, least: number, most: number): number {
  const value = Math.round(Number((event.target as HTMLInputElement).value));
  return Math.min(Math.max(Number.isFinite(value) ? value : least, least), most);
}

customElements.define('lab-tools', ToolsPanel);
