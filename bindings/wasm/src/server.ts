// SPDX-License-Identifier: MIT
// A worker answers its messages so.
import { openDoor, type Door, type DoorCharacter, type DoorResult } from './door.js';
import { EngineError } from './errors.js';
import type { Answer, Call, FromWorker, ToWorker } from './messages.js';
import type { CharacterSpec, Generated, Summary } from './types.js';

/** Reports of a search that come faster are left out. */
const reportEveryMs = 30;
/** Results kept, so that one that is edited again and again is restored once. */
const mostResults = 2;

interface KnownCharacter {
  spec: CharacterSpec;
  bytes: Uint8Array | undefined;
  opened?: DoorCharacter;
}

interface KeptResult {
  character: number;
  summary: string;
  result: DoorResult;
}

export class Server {
  private door: Promise<Door> = Promise.reject(new Error('the worker was not started'));
  private readonly characters = new Map<number, KnownCharacter>();
  private results: KeptResult[] = []; // the one last used is the last

  constructor(private readonly send: (message: FromWorker, transfer: Transferable[]) => void) {
    this.door.catch(() => {}); // each call gets it
  }

  receive(message: ToWorker): void {
    switch (message.type) {
      case 'start':
        this.door = openDoor(message.wasm, message.starts);
        this.door.catch(() => {});
        break;
      case 'know':
        this.characters.set(message.character, { spec: message.spec, bytes: message.bytes });
        break;
      case 'forget':
        // after the calls that came before
        this.door.then(() => this.forget(message.character), () => {});
        break;
      case 'call':
        void this.answer(message.id, message.call);
    }
  }

  private async answer(id: number, call: Call): Promise<void> {
    try {
      const answer = this.compute(await this.door, id, call);
      this.send({ type: 'done', id, answer }, transferable(answer));
    } catch (error) {
      const failure = error instanceof EngineError
        ? error.failure
        : { code: 'fault' as const, message: error instanceof Error ? error.message : String(error) };
      // a module's memory never shrinks: one that has taken all there is gives it back by its end
      const broken = failure.code === 'fault' || failure.code === 'out_of_memory';
      this.send({ type: 'failed', id, failure, broken }, []);
    }
  }

  private compute(door: Door, id: number, call: Call): Answer {
    switch (call.kind) {
      case 'facts':
        return door.facts();
      case 'memory':
        return door.memoryBytes;
      case 'open':
        return this.character(door, call.character).describe();
      case 'generate': {
        const character = this.character(door, call.character);
        const watch = call.progress ? this.watch(id) : undefined;
        return timed(() => door.generate(character, call.task, watch));
      }
      case 'replay': {
        const result = this.result(door, call.character, call.summary);
        return timed(() => result.replay(call.candidate, call.assignments));
      }
      case 'replayWork': {
        const result = this.result(door, call.character, call.summary);
        const watch = call.progress ? this.watch(id) : undefined;
        return timed(() => result.replayWork(call.candidate, call.edit, watch));
      }
      case 'restore': {
        const character = this.character(door, call.character);
        const watch = call.progress ? this.watch(id) : undefined;
        return timed(() => door.restore(character, call.summary, watch));
      }
      case 'mirror': {
        const result = this.result(door, call.character, call.summary);
        return timed(() => result.mirror());
      }
      case 'export':
        return this.result(door, call.character, call.summary).export(call.candidate, call.format, call.options);
      case 'sampled': {
        const result = this.result(door, call.character, call.summary);
        return Object.fromEntries(call.names.map((name) => [name, result.sampled(call.candidate, name, call.fps)]));
      }
      case 'score':
        return door.scoreClip(call.name, call.bytes, call.options);
    }
  }

  private watch(id: number) {
    let last = -Infinity;
    return (progress: { fraction: number; evaluations: number; best_score: number }) => {
      const now = performance.now();
      if (now - last < reportEveryMs && progress.fraction < 1) return;
      last = now;
      this.send({ type: 'progress', id, progress }, []);
    };
  }

  private character(door: Door, id: number): DoorCharacter {
    const known = this.characters.get(id);
    if (known === undefined) throw new EngineError({ code: 'not_found', message: `character ${id} is closed` });
    known.opened ??= door.character(known.spec, known.bytes);
    return known.opened;
  }

  private result(door: Door, character: number, summary: Summary): DoorResult {
    const text = JSON.stringify(summary);
    const at = this.results.findIndex((kept) => kept.character === character && kept.summary === text);
    const kept = at >= 0
      ? (this.results.splice(at, 1)[0] as KeptResult)
      : { character, summary: text, result: door.restore(this.character(door, character), text) };
    this.results.push(kept);
    while (this.results.length > mostResults) this.results.shift()?.result.free();
    return kept.result;
  }

  private forget(character: number): void {
    for (const kept of this.results) if (kept.character === character) kept.result.free();
    this.results = this.results.filter((kept) => kept.character !== character);
    this.characters.get(character)?.opened?.free();
    this.characters.delete(character);
  }
}

/** Runs `make`, reads all that it made and gives it back. */
function timed(make: () => DoorResult): Generated {
  const begin = performance.now();
  const result = make();
  try {
    return { ...result.read(), engine_ms: performance.now() - begin };
  } finally {
    result.free();
  }
}

/** The large arrays of an answer, which go without a copy. */
function transferable(answer: Answer): Transferable[] {
  if (answer instanceof Uint8Array) return [answer.buffer as ArrayBuffer];
  if (typeof answer !== 'object' || !('engine_ms' in answer)) return [];
  return answer.candidates.flatMap((candidate) =>
    Object.values(candidate.series).map((series) => series.values.buffer as ArrayBuffer));
}
