// SPDX-License-Identifier: MIT
// The engine's package, until it is beside this one.
declare module '@shigusa/engine' {
  import type { Engine } from '../../../bindings/wasm/src/types';
  export function createEngine(): Promise<Engine>;
}
