// Sharing: the link of what is shown, in the address and on the clipboard.

import { linkOf } from '../store/link';
import type { State } from '../store/state';

/** Puts the link into the address, and on the clipboard if there is one. Returns what to tell the visitor. */
export async function share(state: State, step: number): Promise<string> {
  const link = linkOf(state, step);
  if (link === null) return 'This map is too large for a link. Save it as a file and send that along.';
  const address = `${location.href.split('#')[0]}#${link}`;
  history.replaceState(null, '', `#${link}`);
  try {
    await navigator.clipboard.writeText(address);
    return 'The link is on the clipboard.';
  } catch {
    return 'The link is in the address line of the browser.';
  }
}
