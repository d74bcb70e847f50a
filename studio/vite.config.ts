// SPDX-License-Identifier: MIT
import { createHash } from 'node:crypto';
import { readdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin, transformWithEsbuild } from 'vite';

const pathOf = (file: string): string => fileURLToPath(new URL(file, import.meta.url));

/** Shaders without comments, indents and empty lines. */
function bareShaders(): Plugin {
  const bare = (shader: string): string =>
    shader.replace(/\/\*[^]*?\*\/|\/\/.*/g, '').replace(/\s*\n\s*/g, '\n').replace(/^[^#\n].*/gm, (line) => line.replace(/ ?([*/=<>(){},;]) ?/g, '$1'));
  return {
    name: 'bare-shaders',
    transform: (code, id) => (id.endsWith('.glsl.js') ? { code: code.replace(/`[^`]*`/g, bare), map: null } : null),
  };
}

/** The service worker, told of all files that are beside it. */
function offline(): Plugin {
  const source = pathOf('offline/worker.ts');
  return {
    name: 'offline',
    async writeBundle({ dir = '' }) {
      const found = await readdir(dir, { recursive: true, withFileTypes: true });
      const files = found.filter((entry) => entry.isFile()).map(({ parentPath, name }) => join(parentPath, name).slice(dir.length + 1)).sort();
      const hash = createHash('sha256');
      for (const file of files) hash.update(`${file}\n`).update(await readFile(join(dir, file)));
      const define = {
        kVersion: JSON.stringify(hash.digest('hex').slice(0, 16)), kFiles: JSON.stringify(files.map((file) => (file === 'index.html' ? './' : file))),
      };
      const { code } = await transformWithEsbuild(await readFile(source, 'utf8'), source, { define, minify: true, format: 'iife', target: 'es2022' });
      await writeFile(join(dir, 'offline.js'), code);
    },
  };
}

// The folder may be served from any path, so nothing in it is named from the root. Of three the single modules are taken, so
// that those that few need come with these.
export default defineConfig({
  base: './',
  resolve: {
    alias: [
      { find: '@shigusa/engine', replacement: pathOf('../bindings/wasm/src/engine.ts') },
      { find: /^three$/, replacement: pathOf('node_modules/three/src/Three.js') },
      { find: './webxr/WebXRManager.js', replacement: pathOf('src/view/no_headset.ts') },
    ],
  },
  plugins: [bareShaders(), offline()],
  worker: { format: 'es' },
  server: { fs: { allow: ['..'] } },
  build: { target: 'es2022', assetsInlineLimit: 0, chunkSizeWarningLimit: 1000 },
});
