// SPDX-License-Identifier: MIT
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';

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
  plugins: [bareShaders()],
  worker: { format: 'es' },
  server: { fs: { allow: ['..'] } },
  build: { target: 'es2022', assetsInlineLimit: 0, chunkSizeWarningLimit: 1000 },
});
