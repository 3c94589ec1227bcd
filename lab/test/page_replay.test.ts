// What a visitor sees of a search.

import { describe, expect, test } from 'vitest';
import { opened, page, pixelOf, slider, usePage } from './page';

usePage();

describe('the page', () => {
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

  test('plays the paths of an anytime planner, bound after bound', async () => {
    await page.goto('about:blank');
    await page.goto(`${opened.address}#map=rooms&size=61x35&seed=2&planner=ara_star`);
    await page.getByText(/^ara_star: found a path of cost 81.0122/).waitFor({ state: 'attached' });
    await page.getByRole('img', { name: /^Cost and lower bound of ara_star/ }).waitFor();
    const rows = page.locator('lab-solutions .stack > table tbody tr');
    expect(await rows.count()).toBeGreaterThan(1);
    const cells = (row: number) => rows.nth(row).locator('td').allTextContents();
    const [first, last] = [await cells(0), await cells(await rows.count() - 1)];
    expect(last.slice(1)).toEqual(['81.01', 'cheapest']);
    expect(Number(first[1])).toBeGreaterThan(81.01);
    const drawn = () => page.locator('lab-map').evaluate((view) => view.shadowRoot!.querySelectorAll('canvas')[1]!.toDataURL());
    const atEnd = await drawn();
    await rows.first().getByRole('button').click();
    expect(await slider().inputValue()).toBe(first[0]!.trim());
    expect(await rows.first().getAttribute('aria-current')).toBe('true');
    await expect.poll(drawn).not.toBe(atEnd);
    const withPath = await drawn();
    // Before the first path there is none.
    await page.getByRole('button', { name: 'One expansion back' }).click();
    await expect.poll(drawn).not.toBe(withPath);
    expect(await page.locator('lab-solutions tr[aria-current=true]').count()).toBe(0);
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

  for (const colours of ['expansion', 'g:', 'h:', 'f:', 'Cost to go', 'Clearance']) {
    test(`shows ${colours}`, async () => {
      const menu = page.getByRole('combobox', { name: 'Show' });
      const label = (await menu.locator('option').allTextContents()).find((text) => text.includes(colours))!;
      await menu.selectOption(label);
      await page.locator('.ramp').waitFor();
    });
  }
});
