// SPDX-License-Identifier: MIT
// What of a work must come back when it is opened again.
import { slide } from './support.mjs';

/** The document, its motions and the picture of it, as one text. */
export const kept = (page) => page.evaluate(() => {
  const { document: d, state: s, task } = window.shigusa;
  const values = (candidate) => candidate.parameters.map(({ name, value, locked }) => [name, value, locked]);
  const end = ({ series: { angles } }) => [...angles.values.slice(-angles.columns)];
  const edits = Object.entries(d.edits).map(([index, edit]) => {
    const [motion] = edit.generated.candidates;
    return [index, edit.assignments, values(motion), end(motion)];
  });
  const found = d.result.candidates.map((candidate) => [values(candidate), end(candidate), candidate.summary.score]);
  const { position_m, target_m } = window.shigusa.look();
  const look = [...position_m, ...target_m].map((x) => Number(x.toFixed(6)));
  return JSON.stringify({
    task, found, edits, chosen: d.chosen, compared: d.compared, weights: d.weights, fewer: d.result.summary.fewer_message,
    tab: s.tab, selected: s.selected, overlays: s.overlays, compareMode: s.compareMode, speed: s.speed, look, view: s.view,
  }, null, 1);
});

/** The third motion is chosen and adjusted, another one compared, a criterion weighed, and all seen from elsewhere. */
export async function work(page) {
  const [x, y] = await page.locator('canvas.view').evaluate((canvas) => {
    const box = canvas.getBoundingClientRect();
    return [box.left + 0.9 * box.width, box.top + 0.9 * box.height];
  });
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 120, y - 40, { steps: 4 });
  await page.mouse.up();
  await page.keyboard.press('g');
  await page.keyboard.press('p');
  await page.click('#tab-criteria');
  await slide(page, '[data-criterion="head"]', 0.3);
  await page.keyboard.press('Digit3');
  await page.click('#tab-adjust');
  await slide(page, '[data-parameter="squat_deg"]', 0.4);
  await page.waitForFunction(() => Object.keys(window.shigusa.document.edits).length === 1);
  await page.keyboard.press('Shift+Digit1');
  await page.waitForFunction(() => window.shigusa.document.compared !== null);
}

/** Waits until all is kept in the browser. */
export const saved = (page) => page.waitForFunction(() => window.shigusa.state.saving === 'saved');

/** All records of a store of the browser's database. */
export const records = (page, store) => page.evaluate((name) => new Promise((done) => {
  const request = indexedDB.open('shigusa');
  request.onsuccess = () => {
    const all = request.result.transaction(name).objectStore(name).getAll();
    all.onsuccess = () => {
      request.result.close();
      done(all.result);
    };
  };
}), store);
