// SPDX-License-Identifier: MIT
// Node.js as a page: its files and its threads. It is asked for its modules when it is there, as an import would
// be followed by bundlers, and by pages.
import { EngineError } from './errors.js';
import type { FromWorker, ToWorker } from './messages.js';

interface Port<In, Out> {
  postMessage(message: Out, transfer?: Transferable[]): void;
  on(event: 'message', handle: (message: In) => void): void;
  on(event: 'error', handle: (error: Error) => void): void;
}

interface Thread extends Port<FromWorker, ToWorker> {
  ref(): void;
  unref(): void;
  terminate(): Promise<number>;
}

interface NodeModules {
  'node:fs/promises': { readFile(path: URL): Promise<Uint8Array<ArrayBuffer>> };
  'node:worker_threads': {
    parentPort: Port<ToWorker, FromWorker> | null;
    Worker: new (script: URL, options: { execArgv: string[] }) => Thread;
  };
}

/** A module of Node.js; undefined in pages, and before Node.js 20.16. */
export function nodeModule<Name extends keyof NodeModules>(name: Name): NodeModules[Name] | undefined {
  const { process } = globalThis as { process?: { getBuiltinModule?(name: string): unknown } };
  return process?.getBuiltinModule?.(name) as NodeModules[Name] | undefined;
}

/** A thread, as lane.ts uses a page's worker. It keeps the process alive while it owes an answer, and no longer. */
export class NodeWorker {
  onmessage: ((event: { data: FromWorker }) => void) | null = null;
  onerror: ((event: { message: string; preventDefault(): void }) => void) | null = null;
  private readonly thread: Thread;

  constructor(script: URL) {
    const threads = nodeModule('node:worker_threads');
    if (threads === undefined) {
      const message = 'there are no workers here: Node.js has them from 20.16 on; openDoor needs none';
      throw new EngineError({ code: 'unsupported', message });
    }
    this.thread = new threads.Worker(script, { execArgv: [] });
    this.thread.unref();
    this.thread.on('message', (data) => {
      if (data.type !== 'progress') this.thread.unref();
      this.onmessage?.({ data });
    });
    this.thread.on('error', ({ message }) => this.onerror?.({ message, preventDefault() {} }));
  }

  postMessage(message: ToWorker): void {
    this.thread.postMessage(message, []);
    if (message.type === 'call') this.thread.ref();
  }

  terminate(): void {
    void this.thread.terminate();
  }
}
