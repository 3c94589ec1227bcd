// How the page is laid out.

import { css } from 'lit';

export const appStyle = css`
  :host { display: grid; grid-template-rows: auto 1fr auto; height: 100dvh; background: var(--page); }
  header { display: flex; align-items: center; gap: 1.5rem; padding: 0.6rem 1rem; border-bottom: 1px solid var(--line); flex-wrap: wrap; }
  h1 { font-size: 1rem; font-weight: 650; margin: 0; }
  main { display: grid; grid-template-columns: 1fr 20rem; min-height: 0; }
  .views { display: grid; gap: 1px; min-width: 0; min-height: 0; background: var(--line); grid-template: 1fr / 1fr; }
  .views[data-count='2'] { grid-template: 1fr 1fr / 1fr; }
  .views[data-count='3'], .views[data-count='4'] { grid-template: 1fr 1fr / 1fr 1fr; }
  figure { margin: 0; display: grid; grid-template-rows: 1fr; position: relative; min-width: 0; min-height: 0; background: var(--map); }
  figcaption { position: absolute; z-index: 1; left: 0.6rem; top: 0.5rem; padding: 0.1rem 0.5rem; border-radius: 4px;
    font-size: 0.8125rem; background: var(--page); color: var(--ink); pointer-events: none; }
  figcaption span { margin-left: 0.4rem; color: var(--faint); font-variant-numeric: tabular-nums; }
  .reason { position: absolute; z-index: 1; left: 0.75rem; right: 0.75rem; bottom: 0.75rem; padding: 0.5rem 0.75rem; border-radius: 6px;
    border-left: 4px solid var(--current); background: var(--page); color: var(--ink); pointer-events: none; }
  .space { flex: 1; }
  aside { overflow-y: auto; border-left: 1px solid var(--line); }
  footer { padding: 0.6rem 1rem; border-top: 1px solid var(--line); }
  .live { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
  .notice { position: fixed; z-index: 2; top: 3.75rem; left: 50%; transform: translateX(-50%); max-width: min(40rem, 90vw); margin: 0;
    display: flex; align-items: start; gap: 0.75rem; padding: 0.5rem 0.5rem 0.5rem 0.75rem; border-radius: 6px; overflow-wrap: anywhere;
    border: 1px solid var(--line); border-left: 4px solid var(--current); background: var(--page); color: var(--ink); }
  .wait { padding: 2rem; }
  @media (max-width: 760px) {
    :host { height: auto; min-height: 100dvh; }
    main { grid-template-columns: 1fr; }
    .views { height: 46dvh; }
    .views[data-count='3'], .views[data-count='4'] { height: 56dvh; }
    figcaption span { display: none; }
    aside { border-left: 0; border-top: 1px solid var(--line); overflow: visible; }
    footer { position: sticky; bottom: 0; background: var(--page); }
    header { gap: 0.6rem; padding: 0.5rem 0.75rem; }
    /* The title and the link in one row, the tools below. */
    lab-tools { order: 1; flex-basis: 100%; }
  }
`;
