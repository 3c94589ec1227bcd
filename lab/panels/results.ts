// <lab-results>: what the searches found, beside each other.

import { css, html, LitElement } from 'lit';
import type { Runner } from '../engine/runner';
import type { Choice } from '../store/state';
import { sentence } from './option_field';
import { panelStyle } from './style';
import { duration, number } from './words';

type Cell = (runner: Runner) => string;

/** What most paths do not have: rows only where one has it. */
const rarely: [string, Cell][] = [
  ['Way out', ({ outcome }) => outcome?.wayOut?.text ?? ''],
  ['Remaining', ({ outcome }) => (outcome?.remaining?.metres ? outcome.remaining.text : '')],
];
const rows: [string, Cell][] = [
  ['Cost', ({ outcome }) => (outcome?.cost === undefined ? 'none' : number(outcome.cost, 4))],
  ['Guarantee', ({ outcome }) => guarantee(outcome?.bound, outcome?.status)],
  ['Expanded', ({ outcome }) => (outcome ? number(outcome.expanded) : '')],
  ['Reached', ({ outcome }) => (outcome ? number(outcome.generated) : '')],
  ['Largest frontier', ({ outcome }) => (outcome ? number(outcome.maxFrontier) : '')],
  ['Time', ({ outcome }) => (outcome ? duration(outcome.seconds) : '')],
];

function guarantee(bound: number | null | undefined, status?: string): string {
  if (status !== 'found') return 'no path';
  if (bound === 1) return 'cheapest';
  return typeof bound === 'number' ? `≤ ${number(bound)} × best` : 'none';
}

export class Results extends LitElement {
  static override styles = [panelStyle, css`
    table { border-collapse: collapse; width: 100%; font-size: 0.875rem; font-variant-numeric: tabular-nums; }
    th { font-weight: 400; text-align: left; color: var(--faint); padding: 0.15rem 0.5rem 0.15rem 0; }
    thead th { text-align: right; color: var(--ink); overflow-wrap: anywhere; padding-right: 0; padding-left: 0.5rem; }
    td { text-align: right; padding: 0.15rem 0 0.15rem 0.5rem; }
    p { margin-top: 0.6rem; color: var(--ink); }
  `];
  static override properties = { runners: { attribute: false }, runs: { attribute: false }, version: { type: String } };

  declare runners: Runner[];
  declare runs: Choice[];
  declare version: string;

  override render() {
    const shown = this.runners.filter((_, i) => i < this.runs.length);
    const notes = new Set(shown.flatMap(({ outcome }) => outcome?.notes ?? []));
    return html`<table>
      <thead><tr><td></td>${this.runs.map(({ planner }) => html`<th scope="col">${planner}</th>`)}</tr></thead>
      <tbody>${[...rows, ...rarely.filter(([, cell]) => shown.some((runner) => cell(runner) !== ''))].map(([name, cell]) => html`
        <tr><th scope="row">${name}</th>${shown.map((runner) => html`<td>${cell(runner)}</td>`)}</tr>`)}
      </tbody></table>
      ${[...notes].map((note) => html`<p>${sentence(note)}</p>`)}`;
  }
}

customElements.define('lab-results', Results);
