// How long a visitor who opens the page waits for the first picture of the search that it plays, in Chromium.
// ./run bench lab

import { openBrowser } from './test/browser';

const visits = 9;

/** Milliseconds from the request of the page, each with an empty cache. */
async function firstPictures(): Promise<number[]> {
  const opened = await openBrowser();
  const times: number[] = [];
  for (let i = 0; i < visits; ++i) {
    const context = await opened.browser.newContext({ viewport: { width: 1280, height: 800 } });
    const page = await context.newPage();
    await page.goto(opened.address, { waitUntil: 'commit' });
    times.push(await page.evaluate(() => new Promise<number>((done) => {
      const look = () => {
        const lab = document.querySelector('wend-lab-page') as unknown as { renderRoot?: ParentNode } | null;
        const map = lab?.renderRoot?.querySelector('lab-map') as unknown as { shown: number } | null | undefined;
        if (map && map.shown > 0) done(performance.now());
        else requestAnimationFrame(look);
      };
      look();
    })));
    await context.close();
  }
  await opened.close();
  return times.sort((a, b) => a - b);
}

export async function benchFirstReplay(): Promise<void> {
  const times = await firstPictures();
  const [median, most] = [times[Math.floor(times.length / 2)]!, times[times.length - 1]!];
  console.log(`opening the page to the first picture of its search: median ${median.toFixed(0)} ms, most ${most.toFixed(0)} ms, ${visits} visits`);
}
