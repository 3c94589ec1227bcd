// The page as a whole, in Debian's Chromium on what was built: it opens, for everybody, everywhere.

import { readFile } from 'node:fs/promises';
import { describe, expect, test } from 'vitest';
import { live, opened, page, slider, usePage } from './page';

usePage();

describe('the page', () => {
  test('opens with a finished search', async () => {
    expect(await live()).toBe('astar: found a path of cost 89.3553, 540 expanded.');
    expect(await slider().inputValue()).toBe('540');
  });

  test('makes other maps', async () => {
    await page.getByLabel('Kind').selectOption('maze');
    await page.getByText('maze, seed 3').waitFor();
    await page.getByRole('button', { name: 'Another', exact: true }).click();
    await page.getByText('maze, seed 4').waitFor();
  });

  test('opens with little code, and loads the rest when it is asked for', async () => {
    const context = await opened.browser.newContext({ reducedMotion: 'reduce', serviceWorkers: 'block' });
    const visitor = await context.newPage();
    const asked: string[] = [];
    visitor.on('request', (request) => asked.push(new URL(request.url()).pathname));
    const modules = () => asked.filter((path) => path.endsWith('.wasm')).map((path) => /(first|wend)-/.exec(path)?.[1]);
    await visitor.goto(opened.address);
    await visitor.getByText(/^astar: found a path of cost 89.3553/).waitFor({ state: 'attached' });
    expect(modules()).toEqual(['first']);
    await visitor.getByLabel('Algorithm').selectOption('jps');
    await visitor.getByText(/^jps: found a path of cost 89.3553/).waitFor({ state: 'attached' });
    await visitor.getByLabel('Kind').selectOption('office');
    await visitor.getByText('office, seed 3').waitFor();
    await visitor.getByText(/^jps: found/).waitFor({ state: 'attached' });
    expect(modules()).toEqual(['first', 'wend']);
    await context.close();
  });

  test('says that the rest could not be loaded, and loads it when it can', async () => {
    const context = await opened.browser.newContext({ reducedMotion: 'reduce', serviceWorkers: 'block' });
    const visitor = await context.newPage();
    await visitor.goto(opened.address);
    await visitor.getByText(/^astar: found/).waitFor({ state: 'attached' });
    await visitor.route(/wend-[^/]*\.wasm$/, (route) => route.abort());
    await visitor.getByLabel('Show the widest path').check();
    await visitor.getByText(/could not be loaded/).first().waitFor({ state: 'attached' });
    await visitor.unroute(/wend-[^/]*\.wasm$/);
    await visitor.getByLabel('Show the widest path').uncheck();
    await visitor.getByLabel('Show the widest path').check();
    await visitor.getByText(/^A disc of radius 0.5 cells gets through/).waitFor();
    await context.close();
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
