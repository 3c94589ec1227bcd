// <lab-exercise>: asks the visitor, and keeps score.

import { css, html, LitElement, nothing } from 'lit';
import { budget, wanted } from '../exercises/greedy';
import type { Lesson } from '../exercises/lesson';
import type { Exercise } from '../store/state';
import type { Store } from '../store/store';
import { sentence } from './option_field';
import { panelStyle } from './style';

const titles: [Exercise, string][] = [
  ['next', 'What is expanded next?'],
  ['heuristic', 'Which heuristic is this?'],
  ['greedy', 'Break greedy'],
];

export class ExercisePanel extends LitElement {
  static override styles = [panelStyle, css`.row button { flex: 0 1 auto; }`];
  static override properties = { store: { attribute: false }, lesson: { attribute: false }, exercise: { type: String }, version: { type: String } };

  declare store: Store;
  declare lesson: Lesson;
  declare exercise: Exercise;
  declare version: string;

  override render() {
    if (this.exercise === '') {
      return html`<div class="stack">
        <p>Ask on this map. A shared link opens the exercise too: for class, nothing is sent anywhere.</p>
        ${titles.map(([exercise, title]) => html`<button @click=${() => this.lesson.begin(exercise)}>${title}</button>`)}</div>`;
    }
    const { right, asked, said } = this.lesson.score;
    return html`<div class="stack">
      <p>${this.question()}</p>
      ${this.answers()}
      ${this.exercise === 'greedy' ? nothing : html`<p><strong>${right} of ${asked} right</strong></p>`}
      ${said ? html`<p>${said}</p>` : nothing}
      <div class="row">
        ${this.exercise === 'heuristic' && this.lesson.solved ? html`<button @click=${() => this.lesson.another()}>Another heuristic</button>` : nothing}
        <button @click=${() => this.dispatchEvent(new CustomEvent('share'))}>Link to this exercise</button>
        <button @click=${() => this.store.set({ exercise: '' })}>End the exercise</button></div></div>`;
  }

  private question(): string {
    if (this.exercise === 'next') return `Which cell does ${this.store.state.runs[0]!.planner} expand next? Choose it on the map.`;
    if (this.exercise === 'heuristic') return 'A* has found a path with one of these heuristics. Look at what it expanded: which one was it?';
    return `Paint obstacles so that greedy pays ${wanted} times the cheapest cost or more. You may change ${budget} cells.`;
  }

  private answers() {
    if (this.exercise !== 'heuristic' || this.lesson.solved) return nothing;
    return html`<div class="row">${this.lesson.heuristics.map((name) => html`
      <button @click=${() => this.lesson.heuristic(name)}>${sentence(name, '')}</button>`)}</div>`;
  }
}

customElements.define('lab-exercise', ExercisePanel);
