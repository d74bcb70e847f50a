// SPDX-License-Identifier: MIT
// character_pictures.mjs FOLDER RESULT…: the first motion of each result as its mesh, to be looked at: a picture for each with three
// views of the start, two moments on the way and the end, arms tinted, goals as balls, the squares of the floor 0.25 m wide.
import { execFileSync } from 'node:child_process';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { basename, join, normalize, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { launch } from './tests/support.mjs';

const kHost = 'http://shigusa/';
const kPage = `<script type="importmap">{ "imports": { "three": "/three/build/three.module.js", "three/addons/": "/three/examples/jsm/" } }</script>
<script type="module" src="/page.mjs"></script>`;

const [folder, ...results] = process.argv.slice(2);
if (!folder || results.length === 0) {
  console.error('usage: node character_pictures.mjs FOLDER RESULT…');
  process.exit(2);
}
await mkdir(folder, { recursive: true });
const browser = await launch({ full: true });
const page = await browser.newPage();
page.on('pageerror', (error) => console.error(String(error)));
let glb = '';
await page.route(`${kHost}**`, async (route) => {
  const path = normalize(new URL(route.request().url()).pathname);
  if (path === '/') return route.fulfill({ contentType: 'text/html', body: kPage });
  const here = (name) => fileURLToPath(new URL(name, import.meta.url));
  const file = path === '/glb' ? glb : path === '/page.mjs' ? here('character_page.mjs') : here(`node_modules${path}`);
  return route.fulfill({ contentType: path === '/glb' ? 'model/gltf-binary' : 'text/javascript', body: await readFile(file) });
});
await page.goto(kHost);
await page.waitForFunction(() => window.draw);
for (const result of results) await photograph(result);
await browser.close();

async function photograph(result) {
  const summary = JSON.parse(await readFile(join(result, 'summary.json')));
  const [candidate] = summary.candidates;
  if (!candidate?.files.glb) return;
  glb = join(result, candidate.files.glb);
  const file = resolve(result, summary.character_file);
  const body = JSON.parse(execFileSync(process.env.SHIGUSA_BINARY, ['body', file, '--json'], { maxBuffer: 1 << 28, stdio: ['ignore', 'pipe', 'ignore'] }));
  const nodeOf = (bone) => body.nodes.find(({ name }) => name === body.humanoid[bone])?.file_node ?? -1;
  const name = `${basename(file)}, ${basename(result)}`;
  const picture = await page.evaluate((motion) => window.draw(motion), {
    title: `${name}: ${summary.candidates.map(({ verdict }) => verdict).join(', ')}; ${candidate.duration_s.toFixed(2)} s`,
    animation: candidate.glb_animation,
    unit_m: candidate.glb_unit_m,
    goals_m: candidate.reached.map(({ goal_m }) => goal_m),
    arms: [['left_upper_arm', 'left_lower_arm', 'left_hand'], ['right_upper_arm', 'right_lower_arm', 'right_hand']].map((bones) => bones.map(nodeOf).filter((node) => node >= 0)),
  });
  if (picture) await writeFile(join(folder, `${name.replaceAll(/[^\w.]+/g, '-')}.png`), Buffer.from(picture.split(',')[1], 'base64'));
}
