// How long the page takes from a move of the goal to the picture of the new path, in Chromium. ./run bench lab

import { openBrowser } from './test/browser';

interface View {
  shown: number;
  runner: { version: number };
}
interface Page {
  store: { state: { map: { width: number; height: number; cells: Uint8Array } }; set(change: unknown): void };
  drag(active: boolean): void;
  renderRoot: ParentNode;
}

const moves = 150;

/** Milliseconds of each move of the goal, along a line across the map. */
async function dragTimes(map: string, side: number, planner: string): Promise<number[]> {
  const opened = await openBrowser();
  const page = await opened.browser.newPage({ viewport: { width: 1280, height: 800 }, reducedMotion: 'reduce' });
  await page.goto(`${opened.address}#map=${map}&size=${side}x${side}&seed=5&planner=${planner}`);
  await page.locator('lab-map').waitFor();
  await page.getByText(new RegExp(`^${planner}: `)).waitFor({ state: 'attached', timeout: 60_000 });
  const times = await page.evaluate(async (count) => {
    const lab = document.querySelector('wend-lab-page') as unknown as Page;
    const view = lab.renderRoot.querySelector('lab-map') as unknown as View;
    const { width, height, cells } = lab.store.state.map;
    const channel = new MessageChannel();
    const turn = () => new Promise<void>((done) => {
      channel.port1.onmessage = () => done();
      channel.port2.postMessage(0);
    });
    const all: number[] = [];
    lab.drag(true);
    for (let i = 0; all.length < count && i < 4 * count; ++i) {
      const x = width - 2 - (i % 300);
      const y = Math.floor(height * 0.75) + (i % 50);
      if (cells[y * width + x] === 0) continue;
      const began = performance.now();
      const { version } = view.runner;
      lab.store.set({ goal: { x: x + 0.5, y: y + 0.5, heading: 0 } });
      while (view.shown <= version) await turn();
      all.push(performance.now() - began);
    }
    lab.drag(false);
    return all;
  }, moves);
  await opened.close();
  return times.sort((a, b) => a - b);
}

export async function benchDragging(): Promise<void> {
  for (const map of ['rooms', 'random']) {
    for (const planner of ['astar', 'jps']) {
      const times = await dragTimes(map, 1024, planner);
      const at = (share: number) => times[Math.min(Math.floor(share * times.length), times.length - 1)]!.toFixed(1);
      console.log(`dragging the goal on ${map} of 1024 x 1024, ${planner}: median ${at(0.5)} ms, 99th percentile ${at(0.99)} ms, ${times.length} moves`);
    }
  }
}
