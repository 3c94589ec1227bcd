// A page of the lab for each test of a file, and what a visitor reads and does there.

import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, beforeEach, expect } from 'vitest';
import { openBrowser, type Opened } from './browser';

export let opened: Opened;
export let page: Page;
let faults: string[];

/** Opens a page before each test of the file, which no fault may leave. */
export function usePage(): void {
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
}

export const live = () => page.getByRole('status').textContent();

/** A value of the result, by its name: of the first search, or another. */
export async function result(name: string, search = 0): Promise<string | null> {
  return page.locator(`lab-results tr:has(th:text-is("${name}")) td`).nth(search).textContent();
}

/** The middle of a cell on the screen, on the first map of the page. */
export async function pixelOf(x: number, y: number): Promise<{ x: number; y: number }> {
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

export async function drag(from: [number, number], to: [number, number]): Promise<void> {
  const begin = await pixelOf(...from);
  const end = await pixelOf(...to);
  await page.mouse.move(begin.x, begin.y);
  await page.mouse.down();
  await page.mouse.move(end.x, end.y, { steps: 12 });
  await page.mouse.up();
}

export const slider = () => page.getByRole('slider', { name: 'Expansions' });
