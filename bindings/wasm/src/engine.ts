// SPDX-License-Identifier: MIT
// The engine of a page: two workers that share one compiled module, each with a copy of the start tables. Searches
// have one for themselves, as an abort ends it; the other one does what must be quick.
import { EngineError } from './errors.js';
import { Lane } from './lane.js';
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
  /** Makes a worker of worker.ts. */
  createWorker?: () => Worker;
}

/** Loads the module with its start tables and starts the workers. Fails with an EngineError: `io` where one of the two
 *  cannot be fetched or the address of the tables has something else, `parse` where `starts` are no tables,
 *  `unsupported` where this machine's WebAssembly cannot run the module. */
export async function createEngine(settings: EngineSettings = {}): Promise<Engine> {
  const startsUrl = settings.startsUrl ?? new URL('./module/starts.tsv', import.meta.url);
  const [wasm, starts] = await Promise.all([
    Promise.resolve(settings.wasm ?? compile(settings.moduleUrl ?? new URL('./module/shigusa.wasm', import.meta.url))),
    Promise.resolve(settings.starts ?? fetchBytes(startsUrl)),
  ]);
  const engine = new WorkerEngine(settings.createWorker ?? createWorker, wasm, starts);
  try {
    await engine.ready();
  } catch (error) {
    engine.dispose();
    // of all that is done until then the tables alone are parsed
    const foreign = settings.starts === undefined && error instanceof EngineError && error.failure.code === 'parse';
    throw foreign ? cannotLoad(startsUrl, error) : error;
  }
  return engine;
}

function createWorker(): Worker {
  return new Worker(new URL('./worker.js', import.meta.url), { type: 'module', name: 'shigusa' });
}

async function compile(url: string | URL): Promise<WebAssembly.Module> {
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
  if (new Uint8Array(bytes)[0] === 0x3c) throw cannotLoad(url, 'a page came instead (with Vite: optimizeDeps.exclude)');
  try {
    return await WebAssembly.compile(bytes);
  } catch (error) {
    throw cannotRun(error);
  }
}

async function fetchBytes(url: string | URL): Promise<Uint8Array> {
  try {
    return new Uint8Array(await (await fetched(url)).arrayBuffer());
  } catch (error) {
    throw cannotLoad(url, error);
  }
}

async function fetched(url: string | URL): Promise<Response> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`status ${response.status}`);
  return response;
}

function cannotLoad(url: string | URL, error: unknown): EngineError {
  return new EngineError({ code: 'io', message: `cannot load ${url}: ${said(error)}` });
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
