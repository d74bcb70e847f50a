// SPDX-License-Identifier: MIT
import type { EngineFailure } from './types.js';

/** What the engine refused. */
export class EngineError extends Error {
  constructor(readonly failure: EngineFailure) {
    super(failure.message);
    this.name = 'EngineError';
  }
}
