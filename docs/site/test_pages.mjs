// SPDX-License-Identifier: MIT
// test_pages.mjs [--pictures FOLDER] [PAGE…]: opens the built site's pages in Chromium as on a phone and at a desk, in light
// and dark. No page is wider than its screen, fetches anything from elsewhere or reports an error, axe finds nothing serious
// on a page of each kind, and the search finds a name. With --pictures each page looked at is kept as a picture.
import { createRequire } from 'node:module';
import { createServer } from 'node:http';
import { mkdirSync, readdirSync, readFileSync } from 'node:fs';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../', import.meta.url));
const site = join(root, 'build/docs/site');
// the studio's tests have the driver and axe
const require = createRequire(join(root, 'studio/package.json'));
const { chromium } = require('playwright-core');
const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
const screens = [
  { name: 'phone-light', width: 390, height: 844, colorScheme: 'light' },
  { name: 'phone-dark', width: 390, height: 844, colorScheme: 'dark', axe: true },
  { name: 'desk-light', width: 1280, height: 900, colorScheme: 'light', axe: true },
  { name: 'desk-dark', width: 1280, height: 900, colorScheme: 'dark' },
];
/** A page of each kind; the others are opened on one phone alone. */
const kinds = [
  'index.html', 'tutorials/first_motion.html', 'concepts/weighted_ik.html', 'gallery.html', 'gallery/moving.html', 'criteria.html',
  'reliability.html', 'reference/command_line.html', 'reference/typescript.html', 'reference/task.html',
  'reference/cpp/body.html', 'reference/c/index.html',
];
const types = {
  '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml', '.json': 'application/json',
  '.png': 'image/png', '.webp': 'image/webp', '.jpg': 'image/jpeg', '.woff2': 'font/woff2',
};

function serve() {
  const server = createServer((request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
    try {
      const bytes = readFileSync(join(site, path));
      response.writeHead(200, { 'content-type': types[extname(path)] ?? 'application/octet-stream' }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  return new Promise((done) => server.listen(0, '127.0.0.1', () => done(server)));
}

/** Opens pages on a screen; what is wrong with one is a line of text. */
async function opener(browser, origin, screen) {
  const { width, height, colorScheme } = screen;
  const context = await browser.newContext({ viewport: { width, height }, colorScheme, reducedMotion: 'reduce' });
  const page = await context.newPage();
  let wrong = [];
  page.on('pageerror', (error) => wrong.push(String(error)));
  page.on('response', (response) => { if (response.status() >= 400) wrong.push(`there is no ${response.url()}`); });
  page.on('request', (request) => {
    if (!request.url().startsWith(origin) && !/^(data|blob):/.test(request.url())) wrong.push(`fetches ${request.url()}`);
  });
  const open = async (path, { pictures, axe: looksClosely = false } = {}) => {
    wrong = [];
    await page.goto(`${origin}/${path}`);
    const wide = await page.evaluate(() => {
      const { clientWidth, scrollWidth } = document.documentElement;
      if (scrollWidth <= clientWidth) return '';
      const right = (element) => element.getBoundingClientRect().left + Math.max(element.offsetWidth ?? 0, element.scrollWidth);  // with its text
      const scrolls = (element) => element.closest('.md-typeset__scrollwrap, pre, .formula, .md-sidebar') !== null;
      const beyond = [...document.querySelectorAll('main *')].filter((element) => right(element) > clientWidth && !scrolls(element));
      return `${scrollWidth} px wide on a screen of ${clientWidth}: ${beyond.at(-1)?.outerHTML.slice(0, 120)}`;
    });
    if (wide !== '') wrong.push(wide);
    if (looksClosely) wrong.push(...await seriousFindings(page));
    if (pictures) await page.screenshot({ path: join(pictures, `${path.replaceAll('/', '-')}-${screen.name}.png`), fullPage: false });
    return wrong.map((line) => `${path} (${screen.name}): ${line}`);
  };
  return { open, close: () => context.close() };
}

async function seriousFindings(page) {
  await page.evaluate(`${axe}; 0`);
  return page.evaluate(async () => {
    const { violations } = await window.axe.run(document, { resultTypes: ['violations'] });
    return violations.filter(({ impact }) => impact === 'serious' || impact === 'critical')
      .flatMap(({ id, nodes }) => nodes.slice(0, 3).map(({ html, failureSummary }) => `${id}: ${html.slice(0, 160)} ${failureSummary.replaceAll('\n', ' ').slice(0, 200)}`));
  });
}

/** The site's search finds a public name of C++. */
async function searched(browser, origin) {
  const page = await browser.newPage();
  await page.goto(`${origin}/index.html?q=ReachStatus`);
  try {
    await page.locator('.md-search-result__link[href*="cpp/generate.html"][href$="#ReachStatus"]').waitFor({ state: 'attached', timeout: 20_000 });
    return [];
  } catch {
    return ['index.html: a search for ReachStatus does not find it'];
  } finally {
    await page.close();
  }
}

async function main(words) {
  const pictures = words[0] === '--pictures' ? words.splice(0, 2)[1] : undefined;
  if (pictures) mkdirSync(pictures, { recursive: true });
  const all = readdirSync(site, { recursive: true }).filter((path) => path.endsWith('.html')).map((path) => path.replaceAll('\\', '/')).sort();
  const wanted = words.length > 0 ? words : kinds;
  const server = await serve();
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium-headless-shell', args: ['--no-sandbox'] });
  const origin = `http://127.0.0.1:${server.address().port}`;
  const found = wanted.filter((path) => !all.includes(path)).map((path) => `${path}: is not in the site`);
  for (const screen of screens) {
    const { open, close } = await opener(browser, origin, screen);
    for (const path of wanted) if (all.includes(path)) found.push(...await open(path, { pictures, axe: screen.axe }));
    if (words.length === 0 && screen.name === 'phone-light') {
      for (const path of all) if (!wanted.includes(path)) found.push(...await open(path));
    }
    await close();
  }
  if (words.length === 0) found.push(...await searched(browser, origin));
  await browser.close();
  server.close();
  for (const line of found) console.error(line);
  console.log(`${all.length} pages, ${wanted.length} of them looked at closely: ${found.length === 0 ? 'good' : `${found.length} faults`}`);
  process.exit(found.length === 0 ? 0 : 1);
}

await main(process.argv.slice(2));
