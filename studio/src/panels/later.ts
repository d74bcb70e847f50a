// SPDX-License-Identifier: MIT
// The panels that the page opens without. They come once it rests, or as soon as one is asked for.
export { BodyPanel } from './body';
export { PlotsPanel } from './plots';
