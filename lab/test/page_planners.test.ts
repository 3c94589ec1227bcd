// Planners, their charts, and what follows their paths.

import { describe, expect, test } from 'vitest';
import { page, result, slider, usePage } from './page';

usePage();

describe('the page', () => {
  test('chooses planners and options from the registry', async () => {
    await page.getByLabel('Algorithm').selectOption('dijkstra');
    await page.getByText(/^dijkstra: found a path of cost 89.3553/).waitFor({ state: 'attached' });
    expect(Number((await result('Expanded'))!.replace(',', ''))).toBeGreaterThan(540);
    await page.getByText('Options', { exact: true }).click();
    await page.getByLabel('Connectivity').selectOption('4');
    await page.getByText(/^dijkstra: found a path of cost 1/).waitFor({ state: 'attached' });
  });

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
});
