// What a visitor changes on the map and of the robot.

import { describe, test } from 'vitest';
import { drag, page, usePage } from './page';

usePage();

describe('the page', () => {
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
});
