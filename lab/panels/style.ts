// What all panels look like.

import { css } from 'lit';

export const panelStyle = css`
  :host { display: block; color: var(--ink); font: inherit; }
  h2 { margin: 0 0 0.6rem; font-size: 0.8125rem; font-weight: 600; color: var(--faint); }
  label { display: grid; gap: 0.25rem; font-size: 0.8125rem; color: var(--faint); }
  .row { display: flex; gap: 0.5rem; align-items: end; flex-wrap: wrap; }
  .row > * { flex: 1 1 4rem; min-width: 0; }
  .stack { display: grid; gap: 0.6rem; }
  select, input:not([type=range], [type=checkbox], [type=radio]), button {
    font: inherit; font-size: 0.875rem; color: var(--ink); background: var(--field);
    border: 1px solid var(--line); border-radius: 6px; padding: 0.35rem 0.55rem; min-height: 2.1rem;
    box-sizing: border-box; width: 100%;
  }
  button { cursor: pointer; width: auto; }
  button:hover { border-color: var(--faint); }
  button[aria-pressed=true], button[aria-checked=true] { background: var(--accent); border-color: var(--accent); color: var(--on-accent); }
  button:disabled { opacity: 0.45; cursor: default; }
  :focus-visible { outline: 2px solid var(--accent); outline-offset: 1px; }
  input[type=range] { width: 100%; accent-color: var(--accent); margin: 0; }
  input[type=checkbox] { accent-color: var(--accent); flex: none; width: 1rem; height: 1rem; margin: 0; }
  label.check { display: flex; align-items: center; gap: 0.5rem; color: var(--ink); font-size: 0.875rem; }
  p { margin: 0; font-size: 0.8125rem; line-height: 1.5; color: var(--faint); }
  .field { display: grid; gap: 0.2rem; }
  .field p { font-size: 0.75rem; line-height: 1.35; }
  a { color: var(--accent); }
  details summary { cursor: pointer; font-size: 0.8125rem; color: var(--faint); }
  details > * + * { margin-top: 0.6rem; }
`;
