// <lab-exercise>: asks the visitor what the search does next, and keeps score.

import { html, LitElement, nothing } from 'lit';
import type { Score } from '../exercises/next';
import type { Store } from '../store/store';
import { panelStyle } from './style';

export class ExercisePanel extends LitElement {
  static override styles = panelStyle;
  static override properties = { store: { attribute: false }, score: { attribute: false }, active: { type: Boolean } };

  declare store: Store;
  declare score: Score;
  declare active: boolean;

  override render() {
    if (!this.active) {
      return html`<div class="stack">
        <p>You name the cell, the search answers, and the page keeps score. A shared link opens the exercise too.</p>
        <button @click=${() => this.begin()}>What is expanded next?</button></div>`;
    }
    const { right, asked, said } = this.score;
    return html`<div class="stack">
      <p>Which cell does ${this.store.state.runs[0]!.planner} expand next? Choose it on the map.</p>
      <p><strong>${right} of ${asked} right</strong></p>
      ${said ? html`<p>${said}</p>` : nothing}
      <button @click=${() => this.store.set({ exercise: '' })}>End the exercise</button></div>`;
  }

  private begin(): void {
    this.store.set({ exercise: 'next' });
    this.dispatchEvent(new CustomEvent('begin'));
  }
}

customElements.define('lab-exercise', ExercisePanel);
