// What a visitor does, in Debian's Chromium on the built page.

import { readFile } from 'node:fs/promises';
import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, test } from 'vitest';
import { openBrowser, type Opened } from './browser';

let opened: Opened;
let page: Page;
let faults: string[];

beforeAll(async () => {
  opened = await openBrowser();
}, 60_000);
afterAll(async () => opened.close());

beforeEach(async () => {
  faults = [];
  // Without motion, a search is shown from its end.
  page = await opened.browser.newPage({ viewport: { width: 1280, height: 800 }, reducedMotion: 'reduce' });
  page.on('pageerror', (fault) => faults.push(String(fault)));
  page.on('requestfailed', (request) => faults.push(request.url()));
  await page.goto(opened.address);
  await page.getByText(/^astar: found/).waitFor({ state: 'attached' });
});
afterEach(async () => {
  expect(faults).toEqual([]);
  await page.close();
});

const live = () => page.getByRole('status').textContent();

/** A value of the result, by its name: of the first search, or another. */
async function result(name: string, search = 0): Promise<string | null> {
  return page.locator(`lab-results tr:has(th:text-is("${name}")) td`).nth(search).textContent();
}

/** The middle of a cell on the screen, on the first map of the page. */
async function pixelOf(x: number, y: number): Promise<{ x: number; y: number }> {
  return page.locator('lab-map').first().evaluate((view, cell) => {
    const { camera, store } = view as unknown as {
      camera: { pixelOf(map: unknown, point: unknown): { x: number; y: number } };
      store: { state: { map: unknown } };
    };
    const pixel = camera.pixelOf(store.state.map, { x: cell.x + 0.5, y: cell.y + 0.5 });
    const box = view.getBoundingClientRect();
    return { x: box.left + pixel.x, y: box.top + pixel.y };
  }, { x, y });
}

async function drag(from: [number, number], to: [number, number]): Promise<void> {
  const begin = await pixelOf(...from);
  const end = await pixelOf(...to);
  await page.mouse.move(begin.x, begin.y);
  await page.mouse.down();
  await page.mouse.move(end.x, end.y, { steps: 12 });
  await page.mouse.up();
}

const slider = () => page.getByRole('slider', { name: 'Expansions' });

describe('the page', () => {
  test('opens with a finished search', async () => {
    expect(await live()).toBe('astar: found a path of cost 89.3553, 540 expanded.');
    expect(await slider().inputValue()).toBe('540');
  });

  test('follows the goal that is dragged, and takes it back', async () => {
    await drag([59, 33], [5, 5]);
    await page.getByText('astar: found a path of cost 5.6569').waitFor({ state: 'attached' });
    await page.getByRole('button', { name: 'Undo' }).click();
    await page.getByText('astar: found a path of cost 89.3553').waitFor({ state: 'attached' });
    await page.getByRole('button', { name: 'Redo' }).click();
    await page.getByText('astar: found a path of cost 5.6569').waitFor({ state: 'attached' });
  });

  test('paints walls, and says why there is no path', async () => {
    await page.getByLabel('Brush').fill('3');
    await page.getByLabel('Brush').press('Enter');
    await drag([4, 1], [4, 9]);
    await page.getByText(/^astar: .*Obstacles separate/).waitFor({ state: 'attached' });
    await page.getByRole('button', { name: 'Undo' }).click();
    await page.getByText('astar: found a path').waitFor({ state: 'attached' });
  });

  test('steps and scrubs both ways', async () => {
    await page.getByRole('button', { name: 'One expansion back' }).click();
    expect(await slider().inputValue()).toBe('539');
    await slider().fill('17');
    expect(await page.getByText('17 of 540 expanded').count()).toBe(1);
    await page.getByRole('button', { name: 'One expansion forward' }).click();
    expect(await slider().inputValue()).toBe('18');
    await page.getByRole('button', { name: 'To the beginning' }).click();
    expect(await slider().inputValue()).toBe('0');
  });

  test('plays to the end, and pauses', async () => {
    await page.getByRole('combobox', { name: 'Speed' }).selectOption('all in 3 s');
    await page.getByRole('button', { name: 'Play' }).click();
    await page.getByRole('button', { name: 'Pause' }).click();
    const paused = Number(await slider().inputValue());
    expect(paused).toBeLessThan(540);
    await page.keyboard.press('p');
    await expect.poll(() => slider().inputValue(), { timeout: 8000 }).toBe('540');
  });

  test('chooses planners and options from the registry', async () => {
    await page.getByLabel('Algorithm').selectOption('dijkstra');
    await page.getByText(/^dijkstra: found a path of cost 89.3553/).waitFor({ state: 'attached' });
    expect(Number((await result('Expanded'))!.replace(',', ''))).toBeGreaterThan(540);
    await page.getByText('Options', { exact: true }).click();
    await page.getByLabel('Connectivity').selectOption('4');
    await page.getByText(/^dijkstra: found a path of cost 1/).waitFor({ state: 'attached' });
  });

  test('tells about the cell under the pointer, and at the cursor', async () => {
    const cell = await pixelOf(2, 2);
    await page.mouse.move(cell.x, cell.y);
    await page.getByText('Cell (2, 2)').waitFor();
    expect(await page.getByText('g, from the start').count()).toBe(1);
    await page.locator('lab-map canvas').last().focus();
    await page.keyboard.press('ArrowDown');
    await page.getByText('Cell (1, 2)').waitFor();
  });

  test('draws no chain of a search that is gone', async () => {
    const chain = () => page.locator('lab-map').evaluate((view) => [...(view as unknown as { info: { chain: Float64Array } | null }).info?.chain ?? []]);
    const cell = await pixelOf(57, 33);
    await page.mouse.move(cell.x, cell.y);
    await page.getByText('Cell (57, 33)').waitFor();
    await page.getByText(/^expanded as number/).waitFor();
    const before = await chain();
    expect(before.length).toBeGreaterThan(9);
    await page.getByLabel('Seed', { exact: true }).fill('9');
    await page.getByLabel('Seed', { exact: true }).press('Enter');
    await page.getByText('rooms, seed 9').waitFor();
    await expect.poll(chain).not.toEqual(before);
    // The pointer stays where it is.
    await page.getByLabel('Seed', { exact: true }).evaluate((field) => (field as HTMLElement).blur());
    await page.keyboard.press('Control+z');
    await expect.poll(chain).toEqual(before);
    await page.getByLabel('Columns').fill('30');
    await page.getByLabel('Columns').press('Enter');
    // That cell is not on the map now.
    await page.getByText('Cell (57, 33)').waitFor({ state: 'detached' });
    expect(await chain()).toEqual([]);
  });

  test('is worked by keyboard alone', async () => {
    await page.locator('lab-map canvas').last().focus();
    for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
    await page.keyboard.press('g');
    await page.getByText('astar: found a path of cost 3,').waitFor({ state: 'attached' });
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press(' ');
    await page.getByText(/^astar: found a path of cost [45]/).waitFor({ state: 'attached' });
    await page.keyboard.press('Control+z');
    await page.getByText('astar: found a path of cost 3,').waitFor({ state: 'attached' });
  });

  test('makes other maps', async () => {
    await page.getByLabel('Kind').selectOption('maze');
    await page.getByText('maze, seed 3').waitFor();
    await page.getByRole('button', { name: 'Another', exact: true }).click();
    await page.getByText('maze, seed 4').waitFor();
  });

  for (const colours of ['expansion', 'g:', 'h:', 'f:', 'Cost to go', 'Clearance']) {
    test(`shows ${colours}`, async () => {
      const menu = page.getByRole('combobox', { name: 'Show' });
      const label = (await menu.locator('option').allTextContents()).find((text) => text.includes(colours))!;
      await menu.selectOption(label);
      await page.locator('.ramp').waitFor();
    });
  }

  test('compares up to four planners on one map', async () => {
    for (const planner of ['dijkstra', 'greedy', 'jps']) {
      await page.getByRole('button', { name: 'Compare with another planner' }).click();
      await page.getByText(`${planner}: found`).waitFor({ state: 'attached' });
    }
    expect(await page.locator('lab-map').count()).toBe(4);
    expect(await page.getByRole('button', { name: 'Compare with another planner' }).count()).toBe(0);
    expect(await result('Cost', 0)).toBe('89.3553');
    expect(await result('Cost', 1)).toBe('89.3553');
    expect(await result('Cost', 3)).toBe('89.3553');
    await page.getByLabel('One clock counts').selectOption('Time');
    await slider().fill('300');
    await page.getByRole('button', { name: 'Remove greedy' }).click();
    expect(await page.locator('lab-map').count()).toBe(3);
  });

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
      await page.getByText(/^This link is damaged/).waitFor({ state: 'attached' });
      await page.getByRole('button', { name: 'Share link' }).click();
      await page.getByText(/^The link is/).waitFor({ state: 'attached' });
      expect(await result('Cost')).toBe('89.3553');
    }
  });

  test('plans for discs and polygons, and for cars', async () => {
    await page.getByLabel('Shape').selectOption('disc');
    // Both ends move to where it fits; back at the wall it does not.
    await page.getByText(/^astar: found/).waitFor({ state: 'attached' });
    await drag([59, 33], [59, 34]);
    await page.getByText(/^astar: The goal .* is blocked/).waitFor({ state: 'attached' });
    await page.getByLabel('Radius').fill('0.5');
    await page.getByLabel('Radius').press('Enter');
    await page.getByText(/^astar: found/).waitFor({ state: 'attached' });
    await page.getByLabel('Shape').selectOption('point');
    await page.getByLabel('Algorithm').selectOption('hybrid_astar');
    await page.getByText(/^hybrid_astar: found/).waitFor({ state: 'attached' });
    await page.getByLabel("The goal's heading counts").check();
    await page.getByText(/^hybrid_astar: found/).waitFor({ state: 'attached' });
  });

  test('smooths the path', async () => {
    await page.getByLabel('Smooth the path').selectOption('gradient');
    await page.getByLabel('Beta').waitFor();
    await page.getByText(/^astar: found/).waitFor({ state: 'attached' });
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
      await page.locator('.live').filter({ hasText: file.name }).waitFor({ state: 'attached' });
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

  test('draws charts of the searches, and of random queries', async () => {
    await page.getByRole('button', { name: 'Compare with another planner' }).click();
    await page.getByText('dijkstra: found').waitFor({ state: 'attached' });
    expect(await page.locator('lab-charts i').count()).toBe(6);
    await page.getByLabel('Random queries').fill('40');
    await page.getByLabel('Random queries').press('Enter');
    await page.getByRole('button', { name: 'Ask them' }).click();
    await page.getByText('40 random queries are answered.').waitFor({ state: 'attached' });
    await page.getByRole('img', { name: /^Expansions of astar, dijkstra for 40 random queries/ }).waitFor();
    expect(await page.locator('lab-charts .stack > table tbody tr').count()).toBe(2);
    await page.getByLabel('Show of each query').selectOption('Time');
    await page.getByRole('img', { name: /^Time of/ }).waitFor();
  });

  test('stops where the break-point is expanded', async () => {
    await page.getByRole('radio', { name: 'Break-point' }).click();
    const cell = await pixelOf(25, 30);
    await page.mouse.click(cell.x, cell.y);
    await page.mouse.move(cell.x + 1, cell.y);
    const expansion = Number(/expanded as number (\d+)/.exec((await page.getByText(/^expanded as number/).textContent())!)![1]);
    await page.getByRole('combobox', { name: 'Speed' }).selectOption('all in 3 s');
    await page.getByRole('button', { name: 'Play' }).click();
    await page.getByRole('button', { name: 'Play' }).waitFor();
    expect(await slider().inputValue()).toBe(String(expansion));
    await page.mouse.click(cell.x, cell.y);
    await page.getByRole('button', { name: 'Play' }).click();
    await expect.poll(() => slider().inputValue(), { timeout: 8000 }).toBe('540');
  });

  test('drives a robot along the path, with gains on sliders', async () => {
    await page.getByLabel('Controller').selectOption('pure_pursuit');
    const told = page.getByText(/^The robot reached the goal after/);
    await told.waitFor();
    const before = await told.textContent();
    await page.getByRole('img', { name: /^Distance of the robot from the path/ }).waitFor();
    await page.getByRole('slider', { name: /^Lookahead:/ }).fill('0.8');
    await expect.poll(() => told.textContent()).not.toBe(before);
    await page.getByRole('button', { name: 'Drive' }).click();
    await expect.poll(() => page.getByRole('slider', { name: 'Moment of the drive' }).inputValue()).not.toBe('0');
    await page.getByRole('button', { name: 'Undo' }).click();
    await expect.poll(() => told.textContent()).toBe(before);
    await page.getByLabel('Controller').selectOption('');
    await told.waitFor({ state: 'detached' });
  });

  test('shows the widest path', async () => {
    await page.getByLabel('Show the widest path').check();
    await page.getByText(/^A disc of radius 0.5 cells gets through, a larger one does not/).waitFor();
  });

  test('asks what is expanded next, and keeps score', async () => {
    await page.getByRole('button', { name: 'What is expanded next?' }).click();
    await page.getByText('0 of 0 right').waitFor();
    const wrong = await pixelOf(30, 17);
    await page.mouse.click(wrong.x, wrong.y);
    await page.getByText('0 of 1 right').waitFor();
    const place = /\((\d+), (\d+)\) is next/.exec((await page.locator('lab-exercise p').allTextContents()).join(' '))!;
    await page.getByRole('button', { name: 'One expansion back' }).click();
    const right = await pixelOf(Number(place[1]), Number(place[2]));
    await page.mouse.click(right.x, right.y);
    await page.getByText('1 of 2 right').waitFor();
    await page.getByRole('button', { name: 'End the exercise' }).click();
    await page.getByRole('button', { name: 'What is expanded next?' }).waitFor();
  });

  test('asks which heuristic it is, without telling', async () => {
    await page.goto(`${opened.address}#map=rooms&size=41x21&seed=3&planner=astar:heuristic=zero&exercise=heuristic`);
    await page.getByText('which one was it?').waitFor();
    expect(await page.getByLabel('Algorithm').count()).toBe(0);
    await page.getByRole('button', { name: 'Manhattan' }).click();
    await page.getByText('0 of 1 right').waitFor();
    await page.getByRole('button', { name: 'Zero' }).click();
    await page.getByText('1 of 2 right').waitFor();
    await page.getByText(/^Right: zero\./).first().waitFor();
    await page.getByRole('button', { name: 'Another heuristic' }).click();
    await page.getByRole('button', { name: 'Octile' }).waitFor();
    await page.getByRole('button', { name: 'End the exercise' }).click();
    expect(await page.getByLabel('Algorithm').count()).toBe(1);
  });

  test('lets a visitor break greedy with a wall', async () => {
    await page.goto(`${opened.address}#map=random:density=0&size=41x21&start=5,10&goal=35,10&exercise=greedy`);
    await page.getByText('Greedy pays 1.00 times the cheapest.').first().waitFor();
    await drag([30, 1], [30, 19]);
    await page.getByText(/Greedy pays 1\.\d+ times the cheapest. 19 of 40 cells changed/).first().waitFor();
    await drag([29, 1], [12, 1]);
    await page.getByText(/37 of 40 cells changed/).first().waitFor();
    await page.getByRole('button', { name: 'Link to this exercise' }).click();
    await page.getByText(/^The link is/).waitFor({ state: 'attached' });
    await page.goto('about:blank');
    await page.goBack();
    await page.getByText('0 of 40 cells changed').first().waitFor();
  });

  for (const colorScheme of ['light', 'dark'] as const) {
    test(`is accessible in ${colorScheme} colours`, async () => {
      await page.emulateMedia({ colorScheme });
      await page.getByText('Options', { exact: true }).click();
      await page.getByLabel('Controller').selectOption('pid');
      await page.getByText(/^The robot reached the goal/).waitFor();
      await page.getByLabel('Random queries').fill('9');
      await page.getByLabel('Random queries').press('Enter');
      await page.getByRole('button', { name: 'Ask them' }).click();
      await page.getByText('9 random queries are answered.').waitFor({ state: 'attached' });
      await page.evaluate(await readFile(new URL('../node_modules/axe-core/axe.min.js', import.meta.url), 'utf8'));
      const found = await page.evaluate(async () => {
        const { axe } = window as unknown as { axe: { run(): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> } };
        return (await axe.run()).violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(' ')}`);
      });
      expect(found).toEqual([]);
    });
  }

  test('works without a network after the first visit, and asks for its own files only', async () => {
    const context = await opened.browser.newContext({ reducedMotion: 'reduce' });
    const visitor = await context.newPage();
    const asked: string[] = [];
    visitor.on('request', (request) => asked.push(request.url()));
    await visitor.goto(opened.address);
    await visitor.evaluate(async () => { await navigator.serviceWorker.ready; });
    await visitor.reload();
    await context.setOffline(true);
    await visitor.reload();
    await visitor.getByText(/^astar: found/).waitFor({ state: 'attached' });
    expect(asked.filter((url) => !url.startsWith(opened.address) && !/^(data|blob):/.test(url))).toEqual([]);
    await context.close();
  });

  test('works as one file from a folder', async () => {
    await page.goto(new URL('../../build/lab/wend-lab.html', import.meta.url).href);
    await page.getByText('astar: found a path of cost 89.3553').waitFor({ state: 'attached' });
  });

  test('names the licences of what it contains', async () => {
    await page.getByRole('link', { name: 'Licences' }).click();
    for (const name of ['lit ', 'fflate ', 'uplot ', 'wasi-libc', 'libc\\+\\+']) {
      expect(await page.getByRole('heading', { name: new RegExp(`^${name}`) }).count()).toBeGreaterThan(0);
    }
  });
});
