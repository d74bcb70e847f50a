// SPDX-License-Identifier: MIT
// How the scene is looked at: what a person chose in the View menu. One plain object, which JSON can carry.

export const kMostGhosts = 8;

export interface ViewSettings {
  readonly ghosts: number; // figures along the motion's time, 0 to kMostGhosts
  readonly path: boolean; // the effectors' paths with their speed as a colour
}

export const initialView: ViewSettings = { ghosts: 0, path: false };
