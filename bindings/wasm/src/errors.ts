// SPDX-License-Identifier: MIT
import type { EngineFailure } from './types.js';

/** A refusal of the engine. */
export class EngineError extends Error {
  constructor(readonly failure: EngineFailure) {
    super(failure.message);
    this.name = 'EngineError';
  }
}
