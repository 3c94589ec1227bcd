// Keys of the whole page. Those of the map are in view/hand.ts.

import type { Clock } from '../store/clock';
import type { Tool } from '../store/state';
import type { Store } from '../store/store';

const tools: Record<string, Tool> = { w: 'wall', c: 'cost', e: 'erase', m: 'look' };

export function keyed(event: KeyboardEvent, store: Store, clock: Clock): void {
  const target = event.composedPath()[0];
  if (target instanceof HTMLElement && /^(INPUT|SELECT|TEXTAREA)$/.test(target.tagName)) return;
  if (event.altKey) return;
  const control = event.ctrlKey || event.metaKey;
  const key = event.key.toLowerCase();
  if (control && key === 'z') event.shiftKey ? store.redo() : store.undo();
  else if (control && key === 'y') store.redo();
  else if (control) return;
  else if (key === 'p') clock.toggle();
  else if (key === '.') clock.move(1);
  else if (key === ',') clock.move(-1);
  else if (tools[key]) store.set({ tool: tools[key] });
  else return;
  event.preventDefault();
}
