// SPDX-License-Identifier: MIT
// panel_pictures.mjs FOLDER: every panel of the built page in both languages, light and dark, at five sizes, to be looked at: a
// picture of each and a sheet of all at one size. Prints what text is cut off or lies over other text, and what axe finds serious
// on a desk and on a phone; fails where anything is found.
import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { launch, openStudio, serve, settled } from './tests/support.mjs';
import { seriousFindings } from './tests/axe.mjs';
import { clippedText } from './tests/clipped.mjs';

const kSizes = [[390, 844], [844, 390], [768, 1024], [1280, 720], [1920, 1080]];
const kTabs = ['goals', 'criteria', 'body', 'plots', 'adjust', 'take'];
const kLanguages = ['en', 'ja'];
const kThemes = ['light', 'dark'];
const kAxeSizes = new Set(['390x844', '1280x720']); // what axe finds hardly goes by the size
const kAcross = { wide: 3, tall: 4 }; // pictures in a row of a sheet
const kSheet = 1800; // px

const folder = process.argv[2];
if (!folder) {
  console.error('usage: node panel_pictures.mjs FOLDER');
  process.exit(2);
}
await mkdir(folder, { recursive: true });
const site = await serve();
const browser = await launch({ full: true });
let findings = 0;

/** What is shown, one after another: its name and how to come there from the one before. */
const kStates = [
  ['start', async () => {}],
  ['hint', async (page) => page.locator('.start > .icon-button').click()],
  ...kTabs.map((tab) => [tab, async (page) => page.locator(`#tab-${tab}`).click()]),
  ['compare', async (page) => page.locator('.card .icon-button.compare').nth(1).click()],
  ['projects', async (page) => page.locator('.project-opener').click()],
  ['view', async (page) => {
    await page.keyboard.press('Escape');
    await page.locator('.view-opener').click();
  }],
  ['help', async (page) => {
    await page.keyboard.press('Escape');
    await page.keyboard.press('Shift+?');
  }],
];

for (const [width, height] of kSizes) {
  for (const language of kLanguages) {
    for (const theme of kThemes) await photograph(width, height, language, theme);
  }
}
await browser.close();
site.close();
if (findings > 0) {
  console.error(`${findings} findings`);
  process.exitCode = 1;
}

async function photograph(width, height, language, theme) {
  const size = `${width}x${height}`;
  const isPhone = Math.min(width, height) < 500;
  const { page, context } = await openStudio(browser, site.url, {
    viewport: { width, height }, locale: language === 'ja' ? 'ja-JP' : 'en-GB', colorScheme: theme, cards: true, hasTouch: isPhone, isMobile: isPhone,
  });
  await settled(page);
  const shots = [];
  for (const [name, act] of kStates) {
    await act(page);
    await page.waitForTimeout(600); // to be drawn
    const bytes = await page.screenshot();
    shots.push([name, bytes]);
    await writeFile(join(folder, `${size}-${language}-${theme}-${name}.png`), bytes);
    const serious = kAxeSizes.has(size) ? await seriousFindings(page, 'body') : [];
    for (const finding of [...await clippedText(page), ...serious]) {
      ++findings;
      console.log(`${size} ${language} ${theme} ${name}: ${finding}`);
    }
  }
  await context.close();
  await sheet(`${size}-${language}-${theme}`, width > height ? kAcross.wide : kAcross.tall, shots);
}

/** All pictures of a size beside one another. */
async function sheet(name, across, shots) {
  const page = await browser.newPage({ viewport: { width: kSheet, height: 100 } });
  const cells = shots.map(([title, bytes]) => `<figure><figcaption>${title}</figcaption><img src="data:image/png;base64,${bytes.toString('base64')}"></figure>`);
  await page.setContent(`<style>body { margin: 8px; display: grid; grid-template-columns: repeat(${across}, 1fr); gap: 8px; font: 14px sans-serif }
    figure { margin: 0 } img { width: 100%; border: 1px solid #888 }</style>${cells.join('')}`);
  await page.screenshot({ path: join(folder, `sheet-${name}.png`), fullPage: true });
  await page.close();
}
