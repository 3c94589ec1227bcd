// Links and files.

import { readFile } from 'node:fs/promises';
import { describe, expect, test } from 'vitest';
import { drag, opened, page, result, slider, usePage } from './page';

usePage();

describe('the page', () => {
  test('shares all by a link, which opens at the same step', async () => {
    await page.getByRole('button', { name: 'Compare with another planner' }).click();
    await page.getByText('dijkstra: found').waitFor({ state: 'attached' });
    await drag([3, 3], [3, 8]);
    await drag([59, 33], [15, 15]);
    await expect.poll(() => result('Cost')).not.toBe('89.3553');
    await page.locator('main[aria-busy=false]').waitFor();
    const cost = await result('Cost');
    await slider().fill('123');
    await page.getByRole('button', { name: 'Share link' }).click();
    await page.getByText(/^The link is/).waitFor({ state: 'attached' });
    const address = page.url();
    expect(address.length).toBeGreaterThan(opened.address.length + 50);
    await page.goto('about:blank');
    await page.goto(address);
    await page.getByText('dijkstra: found').waitFor({ state: 'attached' });
    expect(await slider().inputValue()).toBe('123');
    expect(await result('Cost')).toBe(cost);
  });

  test('refuses links that are damaged, and keeps what is there', async () => {
    for (const damaged of ['x', 'AAAA', 'q1bKL0rMS1WyUkosLQEA', '%00', 'a'.repeat(70_000)]) {
      await page.evaluate((text) => { location.hash = text; }, damaged);
      await page.getByText(/^This link is damaged/).waitFor();
      await page.getByRole('button', { name: 'Share link' }).click();
      await page.getByText(/^The link is/).waitFor({ state: 'attached' });
      expect(await result('Cost')).toBe('89.3553');
    }
    await page.goto('about:blank');
    await page.goto(`${opened.address}#map=office&size=100x60`);
    await page.getByText('This link is damaged or was made by another version: its size must be').waitFor();
    await page.getByText('astar: found').waitFor({ state: 'attached' });
    await page.getByRole('button', { name: 'Close this message' }).click();
    expect(await page.getByRole('alert').count()).toBe(0);
  });

  const named = (name: string, text: string) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
  const open = async (...files: { name: string; mimeType: string; buffer: Buffer }[]) =>
    page.getByLabel(/^Open a map/).setInputFiles(files);

  test('opens maps, images and queries', async () => {
    await open(named('small.map', 'type octile\nheight 3\nwidth 5\nmap\n.....\n.@@@.\n.....\n'),
      named('small.scen', 'version 1\n0\tsmall.map\t5\t3\t0\t1\t4\t1\t6\n0\tsmall.map\t5\t3\t0\t0\t4\t0\t4\n'));
    await page.getByText('astar: found a path of cost 6,').waitFor({ state: 'attached' });
    await page.getByLabel('Query of the scenario').selectOption({ index: 1 });
    await page.getByText('astar: found a path of cost 4,').waitFor({ state: 'attached' });
    await open(named('grid.txt', '.#.\n.9.\n...\n'));
    await page.getByText('grid.txt, 3 × 3 cells').waitFor();
    await open(named('m.yaml', 'image: m.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n'),
      named('m.pgm', 'P2 4 2 255 255 255 255 255 255 0 205 255\n'));
    await page.getByText('m.yaml, 4 × 2 cells').waitFor();
    const canvas = await page.locator('lab-map canvas').last().screenshot();
    await open({ name: 'picture.png', mimeType: 'image/png', buffer: canvas });
    await page.getByText(/^picture.png/).waitFor();
    await page.getByRole('button', { name: 'Undo' }).click();
    await page.getByText('m.yaml, 4 × 2 cells').waitFor();
  });

  test('refuses hostile files with a reason, and keeps what is there', async () => {
    const files = [
      named('cut.map', 'type octile\nheight 9\nwidth 9\nmap\n...\n'), named('huge.map', 'type octile\nheight 99999\nwidth 99999\nmap\n'),
      named('wrong.txt', 'hello\n'), named('cut.png', '\x89PNG\r\n\x1a\n'), named('alone.yaml', 'image: gone.pgm\nresolution: 0.1\n'),
      named('empty.txt', ''), named('cut.pgm', 'P5 40 40 255\n'), named('lost.scen', 'version 1\n0\tm\t9\t9\t0\t0\t1\t1\t1\n'),
    ];
    for (const file of files) {
      await open(file);
      await page.getByRole('alert').filter({ hasText: file.name }).waitFor();
      expect(await page.getByText('rooms, seed 3').count()).toBe(1);
      expect(await result('Cost')).toBe('89.3553');
    }
  });

  for (const [button, ending, begin] of [
    ['Save map', '.txt', '#'], ['Path CSV', '.csv', 'x,y,heading'], ['PNG', '.png', '\x89PNG'], ['SVG', '.svg', '<svg'], ['GIF', '.gif', 'GIF89a'], ['Posthoc trace', '.trace.json', '{"version":"1.4.0"'],
  ] as const) {
    test(`saves by ${button}`, async () => {
      const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: button, exact: true }).click()]);
      expect(download.suggestedFilename().endsWith(ending)).toBe(true);
      expect((await readFile(await download.path())).toString('latin1').startsWith(begin)).toBe(true);
    });
  }
});
