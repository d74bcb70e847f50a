// SPDX-License-Identifier: MIT
// The panel that takes a motion away, which comes when it is asked for.
export { TakePanel } from './take';
export { TakeFilm } from './take_film';
export { TakePicture } from './take_picture';
