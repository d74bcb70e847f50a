// SPDX-License-Identifier: MIT
// measure.mjs: how long a person waits for the built page: first motions after it opens, with a warm cache, the engine's part of
// drags and of sliders (medians), and what the page loads, gzipped.
import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { drag, launch, openStudio, serve, settled } from './tests/support.mjs';

const kRuns = 5;
const kDrags = 40; // steps of a drag, and of a slider

const median = (values) => values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];
const site = await serve();
const browser = await launch();
const { page } = await openStudio(browser, site.url);
await settled(page);

const first = [];
for (let k = 0; k < kRuns; ++k) {
  await page.goto('about:blank');
  await page.goto(site.url);
  await page.waitForFunction(() => window.shigusa?.document?.result, undefined, { polling: 5 });
  first.push(await page.evaluate(() => performance.now()));
  await settled(page);
}
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
await browser.close();
site.close();

const dist = fileURLToPath(new URL('./dist/', import.meta.url));
let sum = 0;
for (const name of readdirSync(dist, { recursive: true })) {
  if (!/\.(html|js|css|svg|bin)$/.test(name)) continue;
  const size = gzipSync(readFileSync(`${dist}${name}`), { level: 9 }).length;
  sum += size;
  console.log(`${(size / 1000).toFixed(1).padStart(7)} kB ${name}`);
}
console.log(`${(sum / 1000).toFixed(1).padStart(7)} kB without the engine, gzipped`);
