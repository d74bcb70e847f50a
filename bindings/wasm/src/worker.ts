// SPDX-License-Identifier: MIT
// A worker of the engine's.
import type { ToWorker } from './messages.js';
import { Server } from './server.js';

declare const self: DedicatedWorkerGlobalScope;

const server = new Server((message, transfer) => self.postMessage(message, transfer));
self.onmessage = (event: MessageEvent<ToWorker>) => server.receive(event.data);
