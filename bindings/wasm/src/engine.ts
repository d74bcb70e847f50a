// SPDX-License-Identifier: MIT
// The engine of a page: two workers that share one compiled module, each with a copy of the start tables. Searches
// have one for themselves, as an abort ends it; the other one does what must be quick.
import { addressOf, cannotLoadStarts, loadModule, loadStarts } from './beside.js';
import { EngineError } from './errors.js';
import { Lane } from './lane.js';
import { NodeWorker } from './node.js';
import type {
  Character, CharacterSpec, Engine, ExportOptions, Facts, GenerateOptions, Generated, SampledName, Series, Summary, Task,
  WorkEdit,
} from './types.js';

export { EngineError } from './errors.js';
export * from './types.js';

export interface EngineSettings {
  /** Where shigusa.wasm is; else beside this script. */
  moduleUrl?: string | URL;
  /** The module itself, where it is at hand. */
  wasm?: WebAssembly.Module;
  /** Where starts.tsv is, the start points of searches; else beside this script. */
  startsUrl?: string | URL;
  /** Its bytes, where they are at hand. */
  starts?: Uint8Array;
  /** Makes a worker of worker.ts, the module `./worker` of the package. */
  createWorker?: () => Worker;
}

/** Loads the module with its start tables and starts the workers. Fails with an EngineError: `io` where one of the two
 *  cannot be fetched or the address of the tables has something else, `parse` where `starts` are no tables,
 *  `unsupported` where this machine's WebAssembly cannot run the module. */
export async function createEngine(settings: EngineSettings = {}): Promise<Engine> {
  const { moduleUrl, startsUrl } = settings;
  const [wasm, starts] = await Promise.all([
    Promise.resolve(settings.wasm ?? loadModule(moduleUrl)),
    Promise.resolve(settings.starts ?? loadStarts(startsUrl)),
  ]);
  const engine = new WorkerEngine(settings.createWorker ?? createWorker, wasm, starts);
  try {
    await engine.ready();
  } catch (error) {
    engine.dispose();
    // of all that is done until then the tables alone are parsed
    const foreign = settings.starts === undefined && error instanceof EngineError && error.failure.code === 'parse';
    throw foreign ? cannotLoadStarts(error, startsUrl) : error;
  }
  return engine;
}

function createWorker(): Worker {
  const script = new URL('../worker.js', addressOf('shigusa.wasm'));
  if (typeof Worker === 'undefined') return new NodeWorker(script) as unknown as Worker;
  // moved by Vite
  if (script.pathname.includes('/node_modules/shigusa/')) return new Worker(script, { type: 'module', name: 'shigusa' });
  return new Worker(new URL('./worker.js', import.meta.url), { type: 'module', name: 'shigusa' }); // bundlers find it so
}

class WorkerEngine implements Engine {
  private readonly search: Lane;
  private readonly quick: Lane;
  private opened = 0;
  private known: Facts | undefined;

  constructor(makeWorker: () => Worker, wasm: WebAssembly.Module, starts: Uint8Array) {
    this.search = new Lane(makeWorker, wasm, starts);
    this.quick = new Lane(makeWorker, wasm, starts);
  }

  async ready(): Promise<void> {
    this.known = await always(this.quick.run({ call: { kind: 'facts' } }));
  }

  get facts(): Facts {
    return this.known!; // createEngine gives nobody an engine that is not ready
  }

  async open(spec: CharacterSpec, bytes?: Uint8Array): Promise<Character> {
    const id = ++this.opened;
    const data = bytes === undefined ? { id, spec } : { id, spec, bytes };
    try {
      const description = await always(this.quick.run({ call: { kind: 'open', character: id }, character: data }));
      return { ...data, description };
    } catch (error) {
      this.quick.forget(id);
      throw error;
    }
  }

  close(character: Character): void {
    this.search.forget(character.id);
    this.quick.forget(character.id);
  }

  generate(character: Character, task: Task, options: GenerateOptions = {}): Promise<Generated> {
    const { signal, onProgress } = options;
    const progress = onProgress !== undefined;
    return always(this.search.run({
      call: { kind: 'generate', character: character.id, task, progress }, character, signal, onProgress,
    }));
  }

  preview(character: Character, task: Task): Promise<Generated | undefined> {
    return this.quick.run({
      call: { kind: 'generate', character: character.id, task, progress: false }, character, slot: 'preview',
    });
  }

  replay(
    character: Character, summary: Summary, candidate: number, assignments: string[], slot = 'replay',
  ): Promise<Generated | undefined> {
    return this.quick.run({
      call: { kind: 'replay', character: character.id, summary, candidate, assignments }, character, slot,
    });
  }

  replayWork(
    character: Character, summary: Summary, candidate: number, edit: WorkEdit, options: GenerateOptions = {},
  ): Promise<Generated> {
    const { signal, onProgress } = options;
    const progress = onProgress !== undefined;
    return always(this.search.run({
      call: { kind: 'replayWork', character: character.id, summary, candidate, edit, progress },
      character, signal, onProgress,
    }));
  }

  restore(character: Character, summary: Summary, options: GenerateOptions = {}): Promise<Generated> {
    const { signal, onProgress } = options;
    const progress = onProgress !== undefined;
    return always(this.search.run({
      call: { kind: 'restore', character: character.id, summary, progress }, character, signal, onProgress,
    }));
  }

  mirror(character: Character, summary: Summary): Promise<Generated> {
    return always(this.quick.run({ call: { kind: 'mirror', character: character.id, summary }, character }));
  }

  export(
    character: Character, summary: Summary, candidate: number, format: string, options: ExportOptions = {},
  ): Promise<Uint8Array> {
    return always(this.quick.run({
      call: { kind: 'export', character: character.id, summary, candidate, format, options }, character,
    }));
  }

  async sampled<Name extends SampledName>(
    character: Character, summary: Summary, candidate: number, names: readonly Name[], fps: number,
  ): Promise<Record<Name, Series>> {
    const series = await always(this.quick.run({
      call: { kind: 'sampled', character: character.id, summary, candidate, names, fps }, character,
    }));
    return series as Record<Name, Series>;
  }

  scoreClip(name: string, bytes: Uint8Array, options?: object): Promise<object> {
    return always(this.quick.run({ call: { kind: 'score', name, bytes, options } }));
  }

  async memory(): Promise<{ search: number; quick: number }> {
    const of = (lane: Lane): Promise<number> => always(lane.run({ call: { kind: 'memory' } }));
    const [search, quick] = await Promise.all([of(this.search), of(this.quick)]);
    return { search, quick };
  }

  dispose(): void {
    this.search.dispose();
    this.quick.dispose();
  }
}

/** The answer of a call without a slot, which no other call takes the place of. */
async function always<T>(answer: Promise<T | undefined>): Promise<T> {
  return (await answer) as T;
}
