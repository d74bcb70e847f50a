// SPDX-License-Identifier: MIT
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

// The folder may be served from any path, so nothing in it is named from the root.
export default defineConfig({
  base: './',
  resolve: {
    alias: {
      '@shigusa/engine': fileURLToPath(new URL('../bindings/wasm/src/engine.ts', import.meta.url)),
    },
  },
  worker: { format: 'es' },
  server: { fs: { allow: ['..'] } },
  build: { target: 'es2022', assetsInlineLimit: 0, chunkSizeWarningLimit: 1000 },
});
