// SPDX-License-Identifier: MIT
// The package as scripts/build_npm packs it, installed into new projects outside of the tree and used from there.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { existsSync } from 'node:fs';
import { cp, mkdir, mkdtemp, readdir, readFile, rm, stat, writeFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { after, test } from 'node:test';
import { promisify } from 'node:util';
import { chromium } from 'playwright-core';

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '../../../..');
const bin = (name) => join(here, 'node_modules', name);
const executablePath = '/usr/bin/chromium-headless-shell';
const skip = !existsSync(executablePath) && `${executablePath} is not there`;

const packed = (await readdir(join(root, 'build/npm'))).filter((name) => name.endsWith('.tgz'));
assert.equal(packed.length, 1, 'scripts/build_npm makes one file');
const tarball = join(root, 'build/npm', packed[0]);
const work = await mkdtemp(join(tmpdir(), 'shigusa-npm-'));
const browser = skip ? undefined : await chromium.launch({ executablePath, args: ['--no-sandbox'] });
after(async () => {
  await browser?.close();
  await rm(work, { recursive: true });
});

/** The output of a program, or its failure with all that it said. */
async function run(folder, program, ...args) {
  try {
    return (await promisify(execFile)(program, args, { cwd: folder, maxBuffer: 1e8 })).stdout;
  } catch (error) {
    throw new Error(`${program} ${args.join(' ')}: ${error.stdout}${error.stderr}`, { cause: error });
  }
}

// installed once; each project has a copy
const first = join(work, 'first');
await mkdir(first);
await writeFile(join(first, 'package.json'), '{"private": true, "type": "module"}');
await run(first, 'npm', 'install', '--offline', '--no-audit', '--no-fund', tarball);

/** A new project with the package, these files, and these packages of the tests' own. */
async function project(name, files, packages = []) {
  const folder = join(work, name);
  await cp(first, folder, { recursive: true });
  for (const [file, text] of Object.entries(files)) await writeFile(join(folder, file), text);
  for (const other of packages) await cp(bin(other), join(folder, 'node_modules', other), { recursive: true });
  return folder;
}

const task = "{ goals: [{ effector: 'right_hand', position_m: [-0.25, 0.55, 0.5] }], seed: 1 }";
const script = `import { createEngine } from 'shigusa';
async function main() {
  const engine = await createEngine();
  const human = await engine.open({ source: 'human' });
  const { summary } = await engine.generate(human, ${task});
  console.log('verdict ' + summary.candidates[0]?.verdict);
}
main().catch((error) => console.log('failed ' + error));
`;
const page = (src) => `<!doctype html><link rel="icon" href="data:,"><title>page</title><script type="module" src="${src}"></script>`;

/** What the script of a page says last. */
async function said(url) {
  const tab = await browser.newPage();
  try {
    const problems = [];
    const last = new Promise((resolve) => tab.on('console', (message) => {
      if (message.type() === 'error' || message.type() === 'warning') problems.push(message.text());
      if (/^(verdict|failed) /.test(message.text())) resolve(message.text());
    }));
    tab.on('pageerror', (error) => problems.push(String(error)));
    await tab.goto(url);
    const late = new Promise((resolve) => setTimeout(resolve, 60000, `nothing within a minute: ${problems.join('; ')}`).unref());
    return await Promise.race([last, late]);
  } finally {
    await tab.close();
  }
}

const types = { html: 'text/html', js: 'text/javascript', mjs: 'text/javascript', tsv: 'text/plain', wasm: 'application/wasm' };
const policy = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'; img-src data:";

async function answer(folder, request, response) {
  const path = decodeURI(new URL(request.url, 'http://localhost').pathname).replace(/\/$/, '/index.html');
  const bytes = await readFile(join(folder, path)).catch(() => undefined);
  response.writeHead(bytes === undefined ? 404 : 200, {
    'content-type': types[path.split('.').at(-1)] ?? 'text/plain', 'content-security-policy': policy,
  });
  response.end(bytes);
}

/** What a page of the folder says that is served under the strictest policy that the package can have. */
async function saidUnderPolicy(folder) {
  const server = createServer((request, response) => void answer(folder, request, response));
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  try {
    return await said(`http://127.0.0.1:${server.address().port}/`);
  } finally {
    server.close();
  }
}

test('Node.js runs the engine and the door as the README has them, which find their files, and ends by itself', async () => {
  const readme = await readFile(join(first, 'node_modules/shigusa/README.md'), 'utf8');
  const [engine, door] = [...readme.matchAll(/^```js\n(.*?)^```$/gms)].map(([, block]) => block);
  const folder = await project('node', { 'engine.js': engine, 'door.js': `const task = ${task};\n${door}` });
  assert.match(await run(folder, process.execPath, 'engine.js'), /^possible [a-z, ]+\n$/);
  assert.match(await run(folder, process.execPath, 'door.js'), /^[a-z, ]+\n$/);
});

test('the package has what it needs and no more, and one version', async () => {
  const folder = join(first, 'node_modules/shigusa');
  assert.deepEqual((await readdir(folder)).sort(), ['LICENSE', 'README.md', 'dist', 'package.json']);
  const { version, ...rest } = JSON.parse(await readFile(join(folder, 'package.json'), 'utf8'));
  assert.ok((await stat(join(folder, 'dist/module/shigusa.wasm'))).size <= 3e6, 'a page waits for it');
  const { openDoor } = await import(join(folder, 'dist/door.js'));
  assert.equal((await openDoor()).version, version);
  assert.doesNotMatch(await readFile(join(folder, 'README.md'), 'utf8'), /\]\((?!https)/, 'a link to what is not in it');
  assert.equal(rest.private ?? rest.devDependencies ?? rest.dependencies, undefined);
});

test('publint has nothing to say', async () => {
  const { publint } = await import('publint');
  const { formatMessage } = await import('publint/utils');
  const pkgDir = join(first, 'node_modules/shigusa');
  const { messages } = await publint({ pkgDir, pack: false, strict: true });
  const pkg = JSON.parse(await readFile(join(pkgDir, 'package.json'), 'utf8'));
  assert.deepEqual(messages.map((message) => formatMessage(message, pkg)), []);
});

test('are the types wrong? No', async () => {
  // the package is of ES modules alone: `require` and the resolution of Node.js 10 are not asked for
  await run(work, process.execPath, bin('@arethetypeswrong/cli/dist/index.js'), tarball, '--profile', 'esm-only', '--no-emoji');
});

for (const [compiler, tsc] of [['5', 'typescript5/bin/tsc'], ['7', 'typescript/bin/tsc']]) {
  test(`TypeScript ${compiler} knows its types, by the resolutions nodenext and bundler`, async () => {
    const folder = await project(`types${compiler}`, {
      'main.ts': `import { createEngine, EngineError, type Summary, type Task } from 'shigusa';
import { openDoor, type Door } from 'shigusa/door';
import 'shigusa/worker';
import wasm from 'shigusa/shigusa.wasm';
import starts from 'shigusa/starts.tsv';
const task: Task = ${task};
const addresses: string[] = [wasm, starts];
const door: Door = await openDoor();
using result = door.generate(null, task);
const summary: Summary = result.read().summary;
const engine = await createEngine({ moduleUrl: wasm, startsUrl: starts });
// @ts-expect-error: no such effector's place
const wrong: Task = { goals: [{ effector: 'right_hand', position_m: 'there' }] };
export { addresses, engine, EngineError, summary, wrong };
`,
    });
    for (const [module, resolution] of [['nodenext', 'nodenext'], ['esnext', 'bundler']]) {
      await run(folder, process.execPath, bin(tsc), '--strict', '--noEmit', '--target', 'es2022', '--lib', 'es2022,esnext.disposable,dom',
        '--module', module, '--moduleResolution', resolution, 'main.ts');
    }
  });
}

test('a plain module of a page needs no bundler', { skip }, async () => {
  const folder = await project('plain', {
    'index.html': page('main.js'), 'main.js': script.replace("'shigusa'", "'./node_modules/shigusa/dist/engine.js'"),
  });
  assert.equal(await saidUnderPolicy(folder), 'verdict possible');
});

for (const vite of ['vite7', 'vite8']) {
  test(`a page by ${vite}, in development and built`, { skip }, async () => {
    const { build, createServer: serve } = await import(vite);
    const folder = await project(vite, { 'index.html': page('/main.js'), 'main.js': script });
    const config = { root: folder, configFile: false, logLevel: 'error' };
    const server = await serve({ ...config, server: { host: '127.0.0.1', port: 0 } });
    try {
      await server.listen();
      assert.equal(await said(server.resolvedUrls.local[0]), 'verdict possible');
    } finally {
      await server.close();
    }
    await build(config);
    assert.equal(await saidUnderPolicy(join(folder, 'dist')), 'verdict possible');
  });
}

test('a page by webpack 5, with a worker of its own', { skip }, async () => {
  const { default: webpack } = await import('webpack');
  const folder = await project('webpack', {
    'main.js': script.replace('createEngine()',
      "createEngine({ createWorker: () => new Worker(new URL('./own_worker.js', import.meta.url), { type: 'module' }) })"),
    'own_worker.js': "import 'shigusa/worker';\n",
  });
  const stats = await promisify(webpack)({
    mode: 'production', context: folder, entry: './main.js', output: { path: join(folder, 'dist') }, performance: false,
  });
  assert.deepEqual([...stats.compilation.errors, ...stats.compilation.warnings].map(String), []);
  await writeFile(join(folder, 'dist/index.html'), page('main.js'));
  assert.equal(await saidUnderPolicy(join(folder, 'dist')), 'verdict possible');
});

const model = join(root, '../shared/characters/VRM-Addon-for-Blender__debug_robot.vrm');
const noModel = !existsSync(model) && 'no VRM in ../shared/characters';

test('the page of examples/three_vrm plays a motion on a VRM', { skip: skip || noModel }, async () => {
  const { createServer: serve } = await import('vite8');
  const folder = await project('three_vrm', {}, ['three', '@pixiv']);
  await cp(join(root, 'examples/three_vrm'), folder, { recursive: true });
  await cp(model, join(folder, 'public/model.vrm'));
  const server = await serve({ root: folder, configFile: false, logLevel: 'error', server: { host: '127.0.0.1', port: 0 } });
  const tab = await browser.newPage();
  try {
    await server.listen();
    await tab.goto(`${server.resolvedUrls.local[0]}?model=model.vrm`);
    const words = () => tab.textContent('#said');
    await tab.waitForFunction(() => / from the ball$|rror/.test(document.querySelector('#said').textContent));
    const pictures = process.env.SHIGUSA_PICTURES; // a folder, to look at it
    if (pictures !== undefined) await tab.screenshot({ path: join(pictures, 'three_vrm.png') });
    const [, verdict, distance] = /^(\w+): .*; the wrist is (\d+) cm from the ball$/.exec(await words()) ?? [];
    assert.equal(verdict, 'possible', await words());
    assert.ok(Number(distance) <= 15, await words());
  } finally {
    await tab.close();
    await server.close();
  }
});
