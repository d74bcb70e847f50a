// SPDX-License-Identifier: MIT
// One worker and the calls that wait for it. It computes one call at a time, and cannot be spoken to
// meanwhile: to stop it is to end it, and another takes its place.
import { EngineError } from './errors.js';
import type { Answers, Call, FromWorker, ToWorker } from './messages.js';
import type { Character, Progress } from './types.js';

/** A call to the worker, and how it waits. */
export interface Request<C extends Call = Call> {
  call: C;
  character?: Pick<Character, 'id' | 'spec' | 'bytes'>;
  /** Of calls of one slot that wait the newest alone stays; the others come to undefined. */
  slot?: string;
  signal?: AbortSignal | undefined;
  onProgress?: ((progress: Progress) => void) | undefined;
}

interface Job {
  id: number;
  request: Request;
  resolve: (answer: unknown) => void;
  reject: (error: unknown) => void;
  aborted: () => void;
}

export class Lane {
  private worker: Worker | undefined;
  private readonly known = new Set<number>(); // characters that the worker has
  private readonly waiting: Job[] = [];
  private running: Job | undefined;
  private last = 0;
  private disposed = false;

  constructor(
    private readonly createWorker: () => Worker, private readonly wasm: WebAssembly.Module, private readonly starts: Uint8Array,
  ) {
    this.start();
  }

  run<C extends Call>(request: Request<C>): Promise<Answers[C['kind']] | undefined> {
    return new Promise((resolve, reject) => {
      const { signal, slot } = request;
      if (this.disposed) throw disposal();
      if (signal?.aborted) throw abortion();
      const job: Job = {
        id: ++this.last, request, resolve: resolve as Job['resolve'], reject, aborted: () => this.abort(job),
      };
      signal?.addEventListener('abort', job.aborted);
      if (slot !== undefined) {
        for (const stale of this.waiting.filter((other) => other.request.slot === slot)) {
          this.leave(stale);
          stale.resolve(undefined);
        }
      }
      this.waiting.push(job);
      this.next();
    });
  }

  /** Gives back the memory of a character, after the calls that came before. */
  forget(character: number): void {
    if (this.known.delete(character)) this.post({ type: 'forget', character });
  }

  dispose(): void {
    this.disposed = true;
    this.stop();
    const jobs = [...(this.running === undefined ? [] : [this.running]), ...this.waiting];
    for (const job of jobs) {
      this.leave(job);
      job.reject(disposal());
    }
  }

  private start(): Worker {
    const worker = this.createWorker();
    worker.onmessage = (event: MessageEvent<FromWorker>) => this.receive(event.data);
    worker.onerror = (event) => {
      event.preventDefault();
      this.broke(event.message || 'the worker could not be started');
    };
    this.worker = worker;
    this.post({ type: 'start', wasm: this.wasm, starts: this.starts });
    return worker;
  }

  private stop(): void {
    this.worker?.terminate();
    this.worker = undefined;
    this.known.clear();
  }

  private post(message: ToWorker): void {
    this.worker?.postMessage(message);
  }

  private next(): void {
    if (this.running !== undefined) return;
    const job = this.waiting.shift();
    if (job === undefined) return;
    this.running = job;
    try {
      this.send(job);
    } catch (error) { // it holds what no message can carry, such as a function
      this.leave(job);
      job.reject(error);
      this.next();
    }
  }

  private send({ id, request: { call, character } }: Job): void {
    if (this.worker === undefined) this.start();
    if (character !== undefined && !this.known.has(character.id)) {
      const { spec, bytes } = character;
      this.post({ type: 'know', character: character.id, spec, bytes });
      this.known.add(character.id);
    }
    this.post({ type: 'call', id, call });
  }

  private receive(message: FromWorker): void {
    const job = this.running;
    if (job === undefined || job.id !== message.id) return;
    if (message.type === 'progress') {
      job.request.onProgress?.(message.progress);
      return;
    }
    this.leave(job);
    if (message.type === 'done') {
      job.resolve(message.answer);
    } else {
      if (message.broken) this.stop();
      job.reject(new EngineError(message.failure));
    }
    this.next();
  }

  private broke(message: string): void {
    const job = this.running;
    this.stop();
    if (job === undefined) return;
    this.leave(job);
    job.reject(new EngineError({ code: 'fault', message }));
    this.next();
  }

  private abort(job: Job): void {
    const running = job === this.running;
    this.leave(job);
    job.reject(abortion());
    if (!running) return;
    this.stop();
    this.start(); // ready before it is asked for
    this.next();
  }

  private leave(job: Job): void {
    job.request.signal?.removeEventListener('abort', job.aborted);
    if (this.running === job) this.running = undefined;
    const at = this.waiting.indexOf(job);
    if (at >= 0) this.waiting.splice(at, 1);
  }
}

function abortion(): Error {
  return new DOMException('the search was stopped', 'AbortError');
}

function disposal(): Error {
  return new EngineError({ code: 'cancelled', message: 'the engine was closed' });
}
