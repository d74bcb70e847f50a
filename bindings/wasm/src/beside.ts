// SPDX-License-Identifier: MIT
// The files beside the scripts: the module and its start tables. Bundlers find them by the expressions
// `new URL('…', import.meta.url)`, as they are written here.
import { EngineError } from './errors.js';
import { nodeModule } from './node.js';

/** Where a file of module/ is. */
export function addressOf(file: 'shigusa.wasm' | 'starts.tsv'): URL {
  const url = file === 'starts.tsv'
    ? new URL('./module/starts.tsv', import.meta.url)
    : new URL('./module/shigusa.wasm', import.meta.url);
  // Vite up to 7, in development, moves the scripts of packages to node_modules/.vite/deps, and not what is beside them
  const [, packages] = /^(.*\/node_modules\/)\.vite\/deps\w*\//.exec(url.href) ?? [];
  return packages === undefined ? url : new URL(`shigusa/dist/module/${file}`, packages);
}

/** Fetches and compiles the module, from beside the scripts where no address is given. */
export async function loadModule(url: string | URL = addressOf('shigusa.wasm')): Promise<WebAssembly.Module> {
  let bytes: ArrayBuffer;
  try {
    const response = await fetched(url);
    // while it comes, where the server tells its type
    if (response.headers.get('content-type')?.startsWith('application/wasm') === true) {
      return await WebAssembly.compileStreaming(Promise.resolve(response));
    }
    bytes = await response.arrayBuffer();
  } catch (error) {
    if (error instanceof WebAssembly.CompileError) throw cannotRun(error);
    throw cannotLoad(url, error);
  }
  // "<": a page, as servers of single pages answer for files that they do not have
  if (new Uint8Array(bytes)[0] === 0x3c) throw cannotLoad(url, "a page came instead (with Vite: optimizeDeps: { exclude: ['shigusa'] })");
  try {
    return await WebAssembly.compile(bytes);
  } catch (error) {
    throw cannotRun(error);
  }
}

/** The bytes of the start tables, from beside the scripts where no address is given. */
export async function loadStarts(url: string | URL = addressOf('starts.tsv')): Promise<Uint8Array> {
  try {
    return new Uint8Array(await (await fetched(url)).arrayBuffer());
  } catch (error) {
    throw cannotLoad(url, error);
  }
}

/** The failure where what came from the tables' address are no tables. */
export function cannotLoadStarts(error: unknown, url: string | URL = addressOf('starts.tsv')): EngineError {
  return cannotLoad(url, error);
}

async function fetched(url: string | URL): Promise<Response> {
  const files = String(url).startsWith('file:') ? nodeModule('node:fs/promises') : undefined;
  if (files !== undefined) return new Response(await files.readFile(new URL(url)));
  const response = await fetch(url);
  if (!response.ok) throw new Error(`status ${response.status}`);
  return response;
}

function cannotLoad(url: string | URL, error: unknown): EngineError {
  const hint = String(url).startsWith('file:') && nodeModule('node:fs/promises') === undefined
    ? ' (files are read by Node.js, from 20.16 on; a page needs a server)' : '';
  return new EngineError({ code: 'io', message: `cannot load ${url}: ${said(error)}${hint}` });
}

function cannotRun(error: unknown): EngineError {
  return new EngineError({
    code: 'unsupported',
    message: `WebAssembly here cannot run shigusa, which needs SIMD and exceptions: ${said(error)}`,
  });
}

function said(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
