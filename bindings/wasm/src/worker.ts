// SPDX-License-Identifier: MIT
// A worker of the engine's: a page's, or a thread of Node.js.
import type { ToWorker } from './messages.js';
import { nodeModule } from './node.js';
import { Server } from './server.js';

declare const self: DedicatedWorkerGlobalScope;

const thread = typeof self === 'undefined' ? nodeModule('node:worker_threads')?.parentPort : undefined;
const server = new Server((message, transfer) => (thread ?? self).postMessage(message, transfer));
if (thread) thread.on('message', (message) => server.receive(message));
else self.onmessage = (event: MessageEvent<ToWorker>) => server.receive(event.data);
