// SPDX-License-Identifier: MIT
// The C interface (bindings/c/include/shigusa.h) in one thread, as classes. Every call computes before it
// returns: pages use engine.ts, which has workers do that. Objects made here live outside JavaScript's memory
// until its free().
import { loadModule, loadStarts } from './beside.js';
import { EngineError } from './errors.js';
import createModule, { type ShigusaModule } from './module/shigusa.mjs';
import {
  seriesNames, type Candidate, type CharacterDescription, type CharacterSpec, type EngineFailure, type ExportOptions,
  type Facts, type Generated, type HostNode, type Parameter, type Progress, type SampledName, type Series, type SeriesName,
  type SeriesTable, type Summary, type TableOptions, type Task, type WorkEdit,
} from './types.js';

export { EngineError } from './errors.js';

/** The codes in the order of the C interface's statuses, from 1 on. */
const codes: readonly EngineFailure['code'][] = [
  'invalid_argument', 'not_found', 'parse', 'io', 'unsupported', 'cancelled', 'out_of_memory', 'fault',
];

const abiVersion = 1;

/** Called now and then during a search; true stops it with the best so far. */
export type Watch = (progress: Progress) => boolean | void;

/** Memory of the module that calls hand texts, bytes and results through; given back together. */
class Scratch {
  private readonly pointers: number[] = [];

  constructor(private readonly module: ShigusaModule) {}

  room(size: number): number {
    const pointer = this.module._malloc(Math.max(size, 1));
    if (pointer === 0) throw new EngineError({ code: 'out_of_memory', message: `no memory for ${size} bytes` });
    this.pointers.push(pointer);
    return pointer;
  }

  text(text: string): number {
    const size = this.module.lengthBytesUTF8(text) + 1;
    const pointer = this.room(size);
    this.module.stringToUTF8(text, pointer, size);
    return pointer;
  }

  bytes(bytes: Uint8Array): number {
    const pointer = this.room(bytes.length);
    this.module.HEAPU8.set(bytes, pointer);
    return pointer;
  }

  free(): void {
    for (const pointer of this.pointers.reverse()) this.module._free(pointer);
  }
}

/** The module and what all calls need. */
class Calls {
  constructor(readonly module: ShigusaModule) {}

  /** Runs calls that may fail; their scratch memory is given back in any case. */
  with<T>(work: (scratch: Scratch) => T): T {
    const scratch = new Scratch(this.module);
    try {
      return work(scratch);
    } finally {
      scratch.free();
    }
  }

  check(status: number): void {
    if (status === 0) return;
    const message = this.module.UTF8ToString(this.module._shigusa_message());
    const code = codes[status - 1] ?? 'fault';
    // without memory the text alone is there
    if (code === 'out_of_memory' || code === 'fault') throw new EngineError({ code, message });
    const reason = this.with((scratch) => this.json<EngineFailure['reason'] & object>(scratch, (at) => this.module._shigusa_failure(at)));
    throw new EngineError({ code, message, reason });
  }

  /** The pointer that `call` stores at the address that it gets. */
  made(scratch: Scratch, call: (at: number) => number): number {
    const at = scratch.room(4);
    this.check(call(at));
    return this.word(at);
  }

  word(at: number): number {
    return this.module.HEAPU32[at >>> 2] as number;
  }

  bytes(scratch: Scratch, call: (at: number) => number): Uint8Array {
    return this.taken(this.made(scratch, call));
  }

  /** A copy of the module's bytes, which are given back. */
  taken(bytes: number): Uint8Array {
    const begin = this.module._shigusa_bytes_data(bytes);
    const copy = this.module.HEAPU8.slice(begin, begin + this.module._shigusa_bytes_size(bytes));
    this.module._shigusa_bytes_free(bytes);
    return copy;
  }

  json<T>(scratch: Scratch, call: (at: number) => number): T {
    return JSON.parse(new TextDecoder().decode(this.bytes(scratch, call))) as T;
  }

  /** The result of a call that is watched. */
  watched(watch: Watch | undefined, call: (watch: number) => number): DoorResult {
    const { module } = this;
    let thrown: { error: unknown } | undefined;
    // nothing may be thrown through the module, which would not unwind
    module.report = (fraction, evaluations, best_score) => {
      try {
        return watch?.({ fraction, evaluations, best_score }) === true;
      } catch (error) {
        thrown = { error };
        return true;
      }
    };
    try {
      const result = new DoorResult(this, call(watch === undefined ? 0 : module._shigusa_script_watch()));
      if (thrown === undefined) return result;
      result.free();
    } catch (error) {
      if (thrown === undefined) throw error;
    }
    throw thrown.error;
  }
}

/** An object in the module's memory, until it is freed: by free(), or where a block with `using` ends. */
abstract class Owned {
  constructor(protected readonly calls: Calls, private address: number) {}

  get pointer(): number {
    if (this.address === 0) throw new EngineError({ code: 'invalid_argument', message: `this ${this.kind} was freed` });
    return this.address;
  }

  protected abstract readonly kind: string;
  protected abstract release(pointer: number): void;

  /** Gives its memory back; a second time does nothing. */
  free(): void {
    if (this.address !== 0) this.release(this.address);
    this.address = 0;
  }

  [Symbol.dispose](): void {
    this.free();
  }
}

/** A body with what its file tells. */
export class DoorCharacter extends Owned {
  protected readonly kind = 'character';

  describe(): CharacterDescription {
    return this.calls.with((scratch) =>
      this.calls.json<CharacterDescription>(scratch, (at) =>
        this.calls.module._shigusa_character_describe(this.pointer, at)));
  }

  protected release(pointer: number): void {
    this.calls.module._shigusa_character_free(pointer);
  }
}

/** The outcome of a task: candidates with their motions. Candidates count from 1. */
export class DoorResult extends Owned {
  protected readonly kind = 'result';

  get candidates(): number {
    return this.calls.module._shigusa_result_candidates(this.pointer);
  }

  /** summary.json as the command line writes it, less the names of files. */
  summaryText(): string {
    return this.calls.with((scratch) => new TextDecoder().decode(
      this.calls.bytes(scratch, (at) => this.calls.module._shigusa_result_describe(this.pointer, at))));
  }

  parameters(candidate: number): Parameter[] {
    return this.calls.with((scratch) => this.calls.json<Parameter[]>(scratch, (at) =>
      this.calls.module._shigusa_result_parameters(this.pointer, candidate, at)));
  }

  /** Those of the motion of one action (from 1) of a piece of work; none where nothing moves. */
  actionParameters(candidate: number, action: number): Parameter[] {
    return this.calls.with((scratch) => this.calls.json<Parameter[]>(scratch, (at) =>
      this.calls.module._shigusa_result_action_parameters(this.pointer, candidate, action, at)));
  }

  /** A copy, which outlives the result. */
  series(candidate: number, name: SeriesName): Series {
    const { module } = this.calls;
    return this.calls.with((scratch) => {
      const at = scratch.room(12);
      this.calls.check(module._shigusa_result_series(
        this.pointer, candidate, seriesNames.indexOf(name), at, at + 4, at + 8));
      const begin = this.calls.word(at) >>> 3;
      const frames = this.calls.word(at + 4);
      const columns = this.calls.word(at + 8);
      return { frames, columns, values: module.HEAPF64.slice(begin, begin + frames * columns) };
    });
  }

  /** A series at `fps` frames a second, as files have them. */
  sampled(candidate: number, name: SampledName, fps: number): Series {
    return this.calls.with((scratch) => {
      const size = scratch.room(8);
      const table = this.calls.bytes(scratch, (at) => this.calls.module._shigusa_result_series_at(
        this.pointer, candidate, seriesNames.indexOf(name), fps, at, size, size + 4));
      return {
        frames: this.calls.word(size), columns: this.calls.word(size + 4), values: new Float64Array(table.buffer as ArrayBuffer),
      };
    });
  }

  /** A series with what its columns mean, at any rate and in either place. */
  table(candidate: number, name: SeriesName, options: TableOptions = {}): SeriesTable {
    return this.calls.with((scratch) => {
      const chosen = scratch.text(JSON.stringify(options));
      const kept = scratch.room(4);
      const about = this.calls.json<Omit<SeriesTable, keyof Series>>(scratch, (at) =>
        this.calls.module._shigusa_result_table(
          this.pointer, candidate, seriesNames.indexOf(name), chosen, kept, at));
      const values = new Float64Array(this.calls.taken(this.calls.word(kept)).buffer as ArrayBuffer);
      const frames = about.shape[0] as number;
      return { ...about, frames, columns: about.shape.slice(1).reduce((all, size) => all * size, 1), values };
    });
  }

  /** Candidate 0: all of them in one GLB. */
  export(candidate: number, format: string, options: ExportOptions = {}): Uint8Array {
    return this.calls.with((scratch) => {
      const name = scratch.text(format);
      const chosen = scratch.text(JSON.stringify(options));
      return this.calls.bytes(scratch, (at) =>
        this.calls.module._shigusa_result_export_with(this.pointer, candidate, name, chosen, at));
    });
  }

  /** A candidate's motion anew, with changed parameters: a result of one candidate. */
  replay(candidate: number, assignments: readonly string[]): DoorResult {
    return this.calls.with((scratch) => {
      const list = scratch.text(JSON.stringify(assignments));
      return new DoorResult(this.calls, this.calls.made(scratch, (at) =>
        this.calls.module._shigusa_replay(this.pointer, candidate, list, at)));
    });
  }

  /** A candidate of a piece of work after an edit: one candidate, or several where an action is searched anew. */
  replayWork(candidate: number, edit: WorkEdit, watch?: Watch): DoorResult {
    return this.calls.with((scratch) => {
      const text = scratch.text(JSON.stringify(edit));
      return this.calls.watched(watch, (pointer) => this.calls.made(scratch, (at) =>
        this.calls.module._shigusa_replay_work(this.pointer, candidate, text, pointer, at)));
    });
  }

  mirror(): DoorResult {
    return this.calls.with((scratch) => new DoorResult(this.calls, this.calls.made(scratch, (at) =>
      this.calls.module._shigusa_mirror(this.pointer, at))));
  }

  /** All that can be read of it. */
  read(): Omit<Generated, 'engine_ms'> {
    const summary = JSON.parse(this.summaryText()) as Summary;
    const candidates = summary.candidates.map((candidate, i): Candidate => ({
      summary: candidate,
      parameters: this.parameters(i + 1),
      series: Object.fromEntries(seriesNames.map((name) => [name, this.series(i + 1, name)])) as
        Record<SeriesName, Series>,
    }));
    return { summary, candidates };
  }

  protected release(pointer: number): void {
    this.calls.module._shigusa_result_free(pointer);
  }
}

/** The functions that begin something. */
export class Door {
  private readonly calls: Calls;

  constructor(module: ShigusaModule, starts: Uint8Array) {
    this.calls = new Calls(module);
    const abi = module._shigusa_abi_version();
    if (abi !== abiVersion) throw new Error(`shigusa.wasm has ABI ${abi}; this script is for ${abiVersion}`);
    // without its tables a search would have other results than the native library's
    const set = this.calls.with((scratch) => module._shigusa_script_set_starts(scratch.bytes(starts), starts.length));
    if (set === 0) throw new EngineError({ code: 'parse', message: 'these bytes are no start tables (starts.tsv)' });
  }

  get version(): string {
    return this.calls.module.UTF8ToString(this.calls.module._shigusa_version());
  }

  /** The memory that the module has taken, most of it free again: it never shrinks. */
  get memoryBytes(): number {
    return this.calls.module.HEAPU8.length;
  }

  facts(): Facts {
    return this.calls.with((scratch) => this.calls.json<Facts>(scratch, (at) => this.calls.module._shigusa_facts(at)));
  }

  character(spec: CharacterSpec, bytes?: Uint8Array): DoorCharacter {
    return this.calls.with((scratch) => {
      const text = scratch.text(JSON.stringify(spec));
      const file = bytes === undefined ? 0 : scratch.bytes(bytes);
      return new DoorCharacter(this.calls, this.calls.made(scratch, (at) =>
        this.calls.module._shigusa_character_create(text, file, bytes?.length ?? 0, at)));
    });
  }

  /** The person of a host's skeleton, as of a GLB file that has these nodes; `spec.source` is a name such as "rig.glb". */
  characterOfNodes(spec: CharacterSpec, nodes: readonly HostNode[]): DoorCharacter {
    return this.calls.with((scratch) => {
      const text = scratch.text(JSON.stringify(spec));
      const listed = scratch.text(JSON.stringify({ nodes }));
      return new DoorCharacter(this.calls, this.calls.made(scratch, (at) =>
        this.calls.module._shigusa_character_of_nodes(text, listed, at)));
    });
  }

  /** A result of one candidate of given angles (rad): rows of frames, in the order of the description's joints, at
   *  `fps`; of `task` the criteria and obstacles are taken. */
  resultOfAngles(character: DoorCharacter, angles: readonly (readonly number[])[], fps: number, task?: Task): DoorResult {
    return this.calls.with((scratch) => {
      const columns = angles[0]?.length ?? 0;
      const table = new Float64Array(angles.length * columns);
      for (const [frame, row] of angles.entries()) {
        if (row.length !== columns) throw new RangeError(`frame ${frame} has ${row.length} angles, the first one ${columns}`);
        table.set(row, frame * columns);
      }
      const values = scratch.bytes(new Uint8Array(table.buffer));
      const text = task === undefined ? 0 : scratch.text(JSON.stringify(task));
      return new DoorResult(this.calls, this.calls.made(scratch, (at) => this.calls.module._shigusa_result_of_angles(
        character.pointer, text, values, angles.length, columns, fps, at)));
    });
  }

  /** `task` may be text as well; without a character it has its own, which needs no file. */
  generate(character: DoorCharacter | null, task: Task | string, watch?: Watch): DoorResult {
    return this.calls.with((scratch) => {
      const text = scratch.text(typeof task === 'string' ? task : JSON.stringify(task));
      return this.calls.watched(watch, (pointer) => this.calls.made(scratch, (at) =>
        this.calls.module._shigusa_generate(character?.pointer ?? 0, text, 1, pointer, at)));
    });
  }

  /** A result's motions anew from its JSON; with the character they can leave on its own skeleton. What is stopped
   *  comes to nothing. */
  restore(character: DoorCharacter | null, summary: Summary | string, watch?: Watch): DoorResult {
    return this.calls.with((scratch) => {
      const text = scratch.text(typeof summary === 'string' ? summary : JSON.stringify(summary));
      return this.calls.watched(watch, (pointer) => this.calls.made(scratch, (at) =>
        this.calls.module._shigusa_restore_watched(character?.pointer ?? 0, text, pointer, at)));
    });
  }

  scoreClip(name: string, bytes: Uint8Array, options?: object): object {
    return this.calls.with((scratch) => {
      const title = scratch.text(name);
      const file = scratch.bytes(bytes);
      const chosen = options === undefined ? 0 : scratch.text(JSON.stringify(options));
      return this.calls.json<object>(scratch, (at) =>
        this.calls.module._shigusa_score_clip(title, file, bytes.length, chosen, at));
    });
  }
}

/** Starts the engine in this thread. `wasm`: shigusa.wasm, compiled or its bytes. `starts`: the bytes of starts.tsv
 *  beside it, the start points of searches. Each is loaded from beside the script where it is not given. Fails with an
 *  EngineError: `io` where one cannot be loaded, `parse` where `starts` are no such tables. */
export async function openDoor(wasm?: WebAssembly.Module | Uint8Array<ArrayBuffer>, starts?: Uint8Array): Promise<Door> {
  const [compiled, tables] = await Promise.all([
    Promise.resolve(wasm instanceof Uint8Array ? WebAssembly.compile(wasm) : wasm ?? loadModule()),
    Promise.resolve(starts ?? loadStarts()),
  ]);
  return new Promise((resolve, reject) => {
    createModule({
      instantiateWasm: (imports, received) => {
        WebAssembly.instantiate(compiled, imports).then(received, reject);
        return {};
      },
    }).then((module) => resolve(new Door(module, tables))).catch(reject);
  });
}
