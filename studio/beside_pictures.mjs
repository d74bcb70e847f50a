// SPDX-License-Identifier: MIT
// beside_pictures.mjs FOLDER CHARACTER…: characters beside one another in the same postures, to be looked at: a picture of each and a sheet of all.
// A character is a file, or a built-in body with what is asked of it, such as human, human:female:1.5 or human::1.95:130 (sex, stature m, mass kg).
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { basename, join } from 'node:path';
import { drop, launch, openStudio, serve, settled, take } from './tests/support.mjs';

const kStature = 1.741; // m, that the places below are for
const kWidth = 400; // px, of a picture in the sheet

/** What is seen: where hands go, the share of the motion's time, the side. */
const kViews = [
  { name: 'front', hands: { right_hand: [-0.2, 1, 0.35] }, share: 0, side: 'front' },
  { name: 'side', hands: { right_hand: [-0.2, 1, 0.35] }, share: 0, side: 'side' },
  { name: 'three quarters', hands: { right_hand: [-0.2, 1, 0.35] }, share: 0, side: 'threeQuarters' },
  { name: 'bending', hands: { right_hand: [-0.1, 0.05, 0.45] }, share: 1, side: 'threeQuarters' },
  { name: 'bending, side', hands: { right_hand: [-0.1, 0.05, 0.45] }, share: 1, side: 'side' },
  { name: 'reaching up', hands: { right_hand: [-0.2, 2, 0.2] }, share: 1, side: 'front' },
  { name: 'both hands near', hands: { right_hand: [-0.12, 1.2, 0.28], left_hand: [0.12, 1.2, 0.28] }, share: 1, side: 'threeQuarters' },
  { name: 'hand on its way', hands: { right_hand: [-0.25, 1.2, 0.45] }, share: 0.6, side: 'hand' },
];

const [folder, ...characters] = process.argv.slice(2);
if (!folder || characters.length === 0) {
  console.error('usage: node beside_pictures.mjs FOLDER CHARACTER…');
  process.exit(2);
}
await mkdir(folder, { recursive: true });
const site = await serve();
const browser = await launch({ full: true });
const columns = [];
for (const character of characters) columns.push(await photograph(character));
await sheet();
await browser.close();
site.close();

/** The spec of a built-in body; null of a file. */
function builtIn(character) {
  if (!/^\w+(:|$)/.test(character)) return null;
  const [source, sex, stature, mass] = character.split(':');
  return { source, ...(sex && { sex }), ...(stature && { stature_m: Number(stature) }), ...(mass && { mass_kg: Number(mass) }) };
}

async function photograph(character) {
  const { page, context } = await openStudio(browser, site.url, { viewport: { width: 1300, height: 900 } });
  await settled(page);
  const spec = builtIn(character);
  if (!spec) {
    const before = await page.evaluate(() => window.shigusa.document.character.id);
    await drop(page, basename(character), await readFile(character));
    await page.waitForFunction((id) => window.shigusa.document.character.id !== id, before, { timeout: 60_000 });
    await settled(page);
  }
  const pictures = [];
  let asked = null;
  for (const { name, hands, share, side } of kViews) {
    if (hands !== asked) await ask(page, spec, basename(character), hands);
    asked = hands;
    await look(page, side);
    await page.locator('.scrub').evaluate((range, value) => {
      range.value = String(value * 1000);
      range.dispatchEvent(new Event('input'));
    }, share);
    await page.waitForTimeout(500);
    const bytes = await take(page, 'picture');
    pictures.push([name, bytes]);
    await writeFile(join(folder, `${basename(character).replaceAll(':', '-')}-${name.replaceAll(/\W+/g, '-')}.png`), bytes);
  }
  await context.close();
  return [basename(character), pictures];
}

/** Motions for hands at these places, by the body's size. */
async function ask(page, spec, name, hands) {
  const stature = spec?.stature_m ?? await page.evaluate(() => window.shigusa.document.character.description.stature_m);
  const goals = Object.entries(hands).map(([effector, place]) => ({ effector, position_m: place.map((value) => (value * stature) / kStature) }));
  const first = goals[0].position_m[1];
  await drop(page, 'task.json', Buffer.from(JSON.stringify({ character: spec ?? { source: name }, seed: 1, goals })));
  await page.waitForFunction((y) => window.shigusa.document.goals[0].position_m[1] === y && window.shigusa.document.result, first, { timeout: 60_000 });
  await settled(page);
}

async function look(page, side) {
  if (side === 'hand') {
    await page.locator('canvas.view').focus();
    return page.keyboard.press('f');
  }
  await page.click('.view-opener');
  await page.click(`[data-side="${side}"]`);
  return page.keyboard.press('Escape');
}

/** A row for each view, a column for each character. */
async function sheet() {
  const page = await browser.newPage({ viewport: { width: columns.length * (kWidth + 8) + 16, height: 100 } });
  const cells = kViews.flatMap(({ name }, row) => columns.map(([character, pictures]) =>
    `<figure><figcaption>${name}, ${character}</figcaption><img src="data:image/png;base64,${pictures[row][1].toString('base64')}"></figure>`));
  await page.setContent(`<style>body { margin: 8px; display: grid; grid-template-columns: repeat(${columns.length}, ${kWidth}px); gap: 8px; font: 13px sans-serif }
    figure { margin: 0 } img { width: ${kWidth}px; height: ${kWidth}px; object-fit: cover }</style>${cells.join('')}`);
  await page.screenshot({ path: join(folder, 'sheet.png'), fullPage: true });
}
