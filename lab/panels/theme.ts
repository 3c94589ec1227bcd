// The colours of the page and of <wend-lab>, light and dark. Those of the canvases are in view/palette.ts.

import { css } from 'lit';

export const theme = css`
  :host {
    color-scheme: light dark;
    font: 16px/1.4 system-ui, "Segoe UI", Roboto, "Helvetica Neue", "Liberation Sans", sans-serif;
    --page: #FFFFFF; --map: #F3F4F6; --field: #FFFFFF; --ink: #24272D; --faint: #5A606B; --line: #DADDE3;
    --accent: #0063A3; --on-accent: #FFFFFF;
    --expanded: #9BD0F2; --frontier: #4F8FE0; --current: #D03A86; --path: #0072B2; --goal: #D55E00;
    --ramp: linear-gradient(to right, #FDF3C4, #F6B565, #DE6B5B, #96417F, #3B2A6B);
  }
  @media (prefers-color-scheme: dark) {
    :host {
      --page: #191C22; --map: #14161A; --field: #23272F; --ink: #E4E7EC; --faint: #A9B0BC; --line: #343A45;
      --accent: #62BDF5; --on-accent: #10141A;
      --expanded: #1D4F73; --frontier: #3B86C8; --current: #F25FB0; --path: #62BDF5; --goal: #FF8B45;
      --ramp: linear-gradient(to right, #2B2A55, #4F3A86, #86489A, #C0608F, #E08C7A);
    }
  }
`;
