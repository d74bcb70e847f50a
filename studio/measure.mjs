// SPDX-License-Identifier: MIT
// measure.mjs: how long a person waits for the built page: first motions after it opens, with a warm cache, the engine's part of
// drags and of sliders (medians), and what the page loads, gzipped.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { drag, launch, launchAtHome, openStudio, serve, settled } from './tests/support.mjs';
import { weights } from './tests/weight.mjs';

const kRuns = 7;
const kWarmings = 2; // loads until the browser has kept what it compiled
const kDrags = 40; // steps of a drag, and of a slider

const median = (values) => values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];
const site = await serve();

/** From the page's address to the picture that has the motions: ms of each load. */
async function firstMotions() {
  const folder = mkdtempSync(join(tmpdir(), 'shigusa-profile-'));
  const home = await launchAtHome(folder);
  await home.addInitScript(() => {
    if (location.protocol !== 'about:') localStorage.setItem('shigusa.start', 'closed');
    const look = () => {
      if (!window.shigusa?.document?.result) return requestAnimationFrame(look);
      // the picture of this moment is done when the next one begins
      requestAnimationFrame(() => (window.shown = performance.now()));
    };
    requestAnimationFrame(look);
  });
  const page = await home.newPage();
  const all = [];
  for (let k = 0; k < kWarmings + kRuns; ++k) {
    await page.goto('about:blank');
    await page.goto(site.url);
    await page.waitForFunction(() => window.shown);
    all.push(await page.evaluate(() => window.shown));
    await settled(page);
    await page.waitForTimeout(2000); // what comes later is there then
  }
  await home.close();
  rmSync(folder, { recursive: true, force: true });
  return all.slice(kWarmings);
}

const first = await firstMotions();
const browser = await launch({ full: true });
const { page } = await openStudio(browser, site.url);
await settled(page);
await drag(page, 'right_hand', 60, 80, { hold: 60, steps: kDrags });
await settled(page);
await page.click('#tab-adjust');
await page.locator('[data-parameter="squat_deg"]').evaluate(async (range, steps) => {
  for (let k = 1; k <= steps; ++k) {
    range.value = String(Number(range.max) * (0.3 + (0.3 * k) / steps));
    range.dispatchEvent(new Event('input', { bubbles: true }));
    await new Promise((done) => setTimeout(done, 60));
  }
  range.dispatchEvent(new Event('change', { bubbles: true }));
}, kDrags);
await settled(page);
const { dragToPose, sliderToMotion } = await page.evaluate(() => window.shigusa.timings);
const ms = (timings, part) => `${median(timings.map((timing) => timing[part])).toFixed(1)} ms`;
console.log(`first motions, warm: ${(median(first) / 1000).toFixed(2)} s, of ${kRuns}`);
console.log(`drag: engine ${ms(dragToPose, 'engine_ms')}, in all ${ms(dragToPose, 'total_ms')}, of ${dragToPose.length}`);
console.log(`slider: engine ${ms(sliderToMotion, 'engine_ms')}, in all ${ms(sliderToMotion, 'total_ms')}, of ${sliderToMotion.length}`);

let sum = 0;
for (const [name, bytes] of await weights(page)) {
  sum += bytes;
  console.log(`${(bytes / 1000).toFixed(1).padStart(7)} kB ${name}`);
}
console.log(`${(sum / 1000).toFixed(1).padStart(7)} kB of an English page without the engine, gzipped`);
await browser.close();
site.close();
