// SPDX-License-Identifier: MIT
// Workers of pages in Node.js: the same messages, by worker_threads.
import { Worker, isMainThread, parentPort } from 'node:worker_threads';

if (!isMainThread) {
  globalThis.self = {
    postMessage: (message, transfer) => parentPort.postMessage(message, transfer),
    set onmessage(handle) {
      parentPort.on('message', (data) => handle({ data }));
    },
  };
  await import('../dist/worker.js');
}

/** What a page's `new Worker` makes, as far as lane.ts uses it. */
export class NodeWorker {
  static started = 0;
  static ended = 0;

  constructor() {
    ++NodeWorker.started;
    this.worker = new Worker(new URL(import.meta.url));
    this.worker.on('message', (data) => this.onmessage?.({ data }));
    this.worker.on('error', (error) => this.onerror?.({ message: error.message, preventDefault() {} }));
  }

  postMessage(message, transfer) {
    this.worker.postMessage(message, transfer);
  }

  terminate() {
    ++NodeWorker.ended;
    void this.worker.terminate();
  }
}
