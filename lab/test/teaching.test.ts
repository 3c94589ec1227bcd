// The links of docs/teaching.md open the lab with what they say.

import { readFile } from 'node:fs/promises';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { openBrowser, type Opened } from './browser';
import { root } from './engine';

let opened: Opened;
beforeAll(async () => {
  opened = await openBrowser();
}, 60_000);
afterAll(async () => opened.close());

test('all exercises for class open', async () => {
  const text = await readFile(`${root}docs/teaching.md`, 'utf8');
  const links = [...text.matchAll(/href="\.\.\/lab\/index\.html(#[^"]*)"/g)].map((match) => match[1]!.replaceAll('&amp;', '&'));
  expect(links.length).toBe(8);
  expect(new Set(links).size).toBe(8);
  const asked = { next: 'Choose it on the map.', heuristic: 'which one was it?', greedy: 'You may change 40 cells.' };
  for (const link of links) {
    const page = await opened.browser.newPage({ viewport: { width: 1280, height: 800 } });
    await page.goto(`${opened.address}index.html${link}`);
    const fields = new URLSearchParams(link.slice(1));
    await page.getByText(/: found a path of cost/).waitFor({ state: 'attached' });
    expect(await page.locator('lab-map').count(), link).toBe(Math.max(fields.getAll('planner').length, fields.get('exercise') === 'greedy' ? 2 : 1));
    const exercise = fields.get('exercise') as keyof typeof asked | null;
    if (exercise) await page.getByText(asked[exercise]).waitFor();
    expect(await page.getByRole('slider', { name: 'Expansions' }).inputValue(), link)
      .toMatch(fields.has('step') ? /^0$/ : exercise === 'next' ? /^1$/ : /^\d+$/);
    await page.close();
  }
}, 60_000);
