// <wend-lab> on a page of other things.

import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { openBrowser, type Opened } from './browser';

let opened: Opened;
beforeAll(async () => {
  opened = await openBrowser();
}, 60_000);
afterAll(async () => opened.close());

async function articleWith(element: string): Promise<Page> {
  const page = await opened.browser.newPage({ viewport: { width: 1000, height: 700 }, reducedMotion: 'reduce' });
  await page.goto(`${opened.address}licences.html`);
  await page.evaluate((text) => {
    document.body.innerHTML = `<h1>An article</h1><p>Text</p>${text}<p style="height: 2000px">More</p>`;
    const script = document.createElement('script');
    script.type = 'module';
    script.src = './embed.js';
    document.body.append(script);
  }, element);
  return page;
}

test('shows what its attributes say, and opens it in the lab', async () => {
  const page = await articleWith('<wend-lab map="rooms" size="61x35" seed="3" planner="astar dijkstra"></wend-lab>');
  await page.getByText(/astar: found a path of cost 89.3553, 540 expanded. dijkstra: found a path of cost 89.3553/).waitFor();
  expect(await page.locator('wend-lab lab-map').count()).toBe(2);
  await page.getByRole('button', { name: 'One expansion back' }).click();
  // Scrolling over it scrolls the article.
  const zoom = () => page.locator('lab-map').first().evaluate((view) => (view as unknown as { camera: { zoom: number } }).camera.zoom);
  const before = await zoom();
  await page.locator('lab-map').first().hover();
  await page.mouse.wheel(0, 300);
  await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(0);
  expect(await zoom()).toBe(before);
  await page.getByRole('link', { name: 'Open in the lab' }).click();
  await page.getByText(/^astar: found a path of cost 89.3553.*dijkstra: found a path of cost 89.3553/).waitFor({ state: 'attached' });
  await page.close();
});

test('says what is wrong with its attributes', async () => {
  const page = await articleWith('<wend-lab map="rooms" planner="swirl"></wend-lab>');
  await page.getByText(/unknown planner: swirl/).waitFor();
  await page.close();
});

test('ends its workers when it leaves the page, and begins again when it comes back', async () => {
  const page = await articleWith('<wend-lab map="rooms" size="41x21" seed="1"></wend-lab>');
  await page.getByText(/astar: found/).waitFor();
  expect(page.workers().length).toBe(1);
  await page.evaluate(() => {
    const element = document.querySelector('wend-lab')!;
    element.remove();
    (window as unknown as { kept: Element }).kept = element;
  });
  await expect.poll(() => page.workers().length).toBe(0);
  await page.evaluate(() => {
    const { kept } = window as unknown as { kept: Element };
    document.body.append(kept);
    kept.scrollIntoView();
  });
  await expect.poll(() => page.workers().length).toBe(1);
  await page.getByText(/astar: found/).waitFor();
  await page.close();
});
