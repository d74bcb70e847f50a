// SPDX-License-Identifier: MIT
// Starts the engine, where the browser can run it.
import { createEngine } from '@shigusa/engine';
import type { Engine, EngineFailure } from '../../../bindings/wasm/src/types';

/** A module with one function that makes a vector: valid only where WebAssembly has SIMD. */
const kSimdProbe = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
]);

export type Support = 'ok' | 'no-wasm' | 'no-simd' | 'no-webgl';

export function browserSupport(): Support {
  if (typeof WebAssembly === 'undefined' || typeof Worker === 'undefined') return 'no-wasm';
  if (!WebAssembly.validate(kSimdProbe)) return 'no-simd';
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('webgl2');
  if (context === null) return 'no-webgl';
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return 'ok';
}

export async function connect(): Promise<Engine> {
  return createEngine();
}

/** What went wrong, for a person; null where they stopped it themselves. */
export function failureOf(error: unknown): EngineFailure | null {
  if (error instanceof DOMException && error.name === 'AbortError') return null;
  if (error instanceof Error && error.name === 'AbortError') return null;
  if (typeof error === 'object' && error !== null && 'failure' in error) {
    const failure = (error as { failure: EngineFailure }).failure;
    return failure.code === 'cancelled' ? null : failure;
  }
  return { code: 'fault', message: error instanceof Error ? error.message : String(error) };
}
