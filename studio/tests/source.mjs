// SPDX-License-Identifier: MIT
// Modules of the page's source that need no browser, for tests in Node.
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

/** What a module of `src` exports. */
export async function source(path) {
  const { output: [{ code }] } = await build({
    root: fileURLToPath(new URL('..', import.meta.url)), logLevel: 'error',
    ssr: { noExternal: true }, build: { ssr: `src/${path}`, write: false, rollupOptions: { output: { inlineDynamicImports: true } } },
  });
  return import(`data:text/javascript;base64,${Buffer.from(code).toString('base64')}`);
}
