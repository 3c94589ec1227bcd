// Where the robot cannot be: ways out, closest places, and ends that move.

import { describe, expect, test } from 'vitest';
import { opened, page, result, usePage } from './page';

usePage();

/** A start in the middle of a block, a goal that is walled in. */
const walled = 'map=random:density=0&size=24x14&wall=3,3,8,8&start=6,6&goal=18,6' +
  '&wall=15,3,21,3&wall=15,9,21,9&wall=15,3,15,9&wall=21,3,21,9';

async function open(link: string): Promise<void> {
  await page.goto('about:blank');
  await page.goto(`${opened.address}#${link}`);
  await page.locator('lab-robot details').last().evaluate((asked: HTMLDetailsElement) => { asked.open = true; });
  await page.getByLabel(/^Escape/).waitFor();
}

describe('the page', () => {
  test('leads out of a blocked start and ends at the closest place, if it is asked to', async () => {
    await open(walled);
    await page.getByText(/^the start \(6,6\) is blocked: the cell is an obstacle.* a longest way out of/).first().waitFor();
    await page.getByLabel('Escape, cells').fill('3');
    await page.getByLabel('Escape, cells').press('Enter');
    await page.getByText(/no path from start/).first().waitFor();
    await page.getByLabel('Closest').check();
    await page.getByText('No path reaches the goal cell (18,6); planning to the closest reachable place cell (14,6), 4 cells away.', { exact: true }).waitFor();
    await page.getByText('The start (6,6) is blocked: the cell is an obstacle; the path begins with a way out of 3 cells, to cell (9,6).', { exact: true }).waitFor();
    expect(await result('Way out')).toBe('3 cells');
    expect(await result('Remaining')).toBe('4 cells');
    await page.getByText('way out', { exact: true }).waitFor();
    await page.getByText('distance that remains', { exact: true }).waitFor();
    await page.getByRole('button', { name: 'Undo' }).click();
    await page.getByText('distance that remains', { exact: true }).waitFor({ state: 'detached' });
  });

  test('shares both by a link, and drives along the way out', async () => {
    await open(`${walled}&escape=3&closest=true`);
    await page.getByText(/^astar: found a path/).waitFor({ state: 'attached' });
    const cost = await result('Cost');
    await page.getByLabel('Controller').selectOption('pure_pursuit');
    await page.getByText(/^The robot reached the goal after/).waitFor();
    await page.getByRole('button', { name: 'Share link' }).click();
    await page.getByText(/^The link is/).waitFor({ state: 'attached' });
    const address = page.url();
    expect(address).not.toContain('escape');
    await page.goto('about:blank');
    await page.goto(address);
    await page.getByText(/^astar: found a path/).waitFor({ state: 'attached' });
    expect(await result('Cost')).toBe(cost);
    expect(await result('Way out')).toBe('3 cells');
    expect(await page.getByLabel('Closest').isChecked()).toBe(true);
  });

  test('tells by how much ends move for another robot, and leaves those that a path may lead out of', async () => {
    await open('map=random:density=0&size=24x14&wall=0,0,23,0&wall=0,13,23,13&start=4,1&goal=20,6');
    await page.getByLabel('Shape').selectOption('disc');
    await page.getByRole('alert').filter({ hasText: 'The robot does not fit there: the start is moved by 1 cell.' }).waitFor();
    await open('map=random:density=0&size=24x14&wall=0,0,23,0&wall=0,13,23,13&start=4,1&goal=20,6&escape=2');
    await page.getByLabel('Shape').selectOption('disc');
    await page.getByText(/the path begins with a way out of 1 cell, to cell \(4,2\)/).first().waitFor({ state: 'attached' });
    expect(await page.getByRole('alert').count()).toBe(0);
  });

  test('shows the notes on a map that is probably not meant', async () => {
    const named = (name: string, text: string) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
    await page.getByLabel(/^Open a map/).setInputFiles([
      named('m.yaml', 'image: m.pgm\nresolution: 0.1\norigin: [0, 0, 90]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n'),
      named('m.pgm', 'P2 4 2 255 255 255 255 255 255 0 205 255\n')]);
    await page.getByRole('alert').filter({ hasText: 'm.yaml: the yaw of the origin is read in radians: 90 is more than a full turn; 90 degrees are 1.5708 radians.' }).waitFor();
    await page.getByRole('alert').filter({ hasText: 'm.yaml: grey 205, which map savers write for unknown, counts as free here (1 cell)' }).waitFor();
    await page.getByRole('button', { name: 'Close this message' }).click();
    expect(await page.getByRole('alert').count()).toBe(0);
  });
});
