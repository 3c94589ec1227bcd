// The exercises.

import { describe, expect, test } from 'vitest';
import { drag, opened, page, pixelOf, usePage } from './page';

usePage();

describe('the page', () => {
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
});
