// SPDX-License-Identifier: MIT
// The messages between engine.ts and its workers. A worker gets the module and its start tables first, then
// what it must know of characters and calls, one at a time; it answers each call once, after any progress.
import type {
  CharacterDescription, CharacterSpec, EngineFailure, ExportOptions, Facts, Generated, Progress, SampledName,
  Series, Summary, Task, WorkEdit,
} from './types.js';

export type Call =
  | { kind: 'facts' }
  | { kind: 'memory' }
  | { kind: 'open'; character: number }
  | { kind: 'generate'; character: number; task: Task; progress: boolean }
  | { kind: 'replay'; character: number; summary: Summary; candidate: number; assignments: string[] }
  | {
    kind: 'replayWork'; character: number; summary: Summary; candidate: number; edit: WorkEdit; progress: boolean;
  }
  | { kind: 'restore'; character: number; summary: Summary; progress: boolean }
  | { kind: 'mirror'; character: number; summary: Summary }
  | {
    kind: 'export'; character: number; summary: Summary; candidate: number; format: string; options: ExportOptions;
  }
  | {
    kind: 'sampled'; character: number; summary: Summary; candidate: number; names: readonly SampledName[]; fps: number;
  }
  | { kind: 'score'; name: string; bytes: Uint8Array; options: object | undefined };

export interface Answers {
  facts: Facts;
  memory: number;
  open: CharacterDescription;
  generate: Generated;
  replay: Generated;
  replayWork: Generated;
  restore: Generated;
  mirror: Generated;
  export: Uint8Array;
  sampled: Partial<Record<SampledName, Series>>;
  score: object;
}

export type Answer = Answers[Call['kind']];

export type ToWorker =
  | { type: 'start'; wasm: WebAssembly.Module; starts: Uint8Array }
  | { type: 'know'; character: number; spec: CharacterSpec; bytes: Uint8Array | undefined }
  | { type: 'forget'; character: number }
  | { type: 'call'; id: number; call: Call };

export type FromWorker =
  | { type: 'progress'; id: number; progress: Progress }
  | { type: 'done'; id: number; answer: Answer }
  /** `broken`: this worker's module is not to be gone on with. */
  | { type: 'failed'; id: number; failure: EngineFailure; broken: boolean };
