// SPDX-License-Identifier: MIT
// The view settings chosen in the View menu, as one plain object for JSON.

export const kMostGhosts = 8;
/** Focal lengths of lenses for a full frame, 36 mm × 24 mm. */
export const kShortestFocal_mm = 18;
export const kLongestFocal_mm = 200;
export const kUsualFocal_mm = 42;

export interface ViewSettings {
  readonly ghosts: number; // figures along the motion's time, 0 to kMostGhosts
  readonly orthographic: boolean;
  readonly focal_mm: number;
  readonly ruler: boolean; // beside the figure, as high as it is
  readonly path: boolean; // the effectors' paths with their speed as a colour
}

const isSwitch = (value: unknown): boolean => typeof value === 'boolean';

/** What each setting may be: links and files bring views that others may have changed. */
const kAllowed: { readonly [Name in keyof ViewSettings]: (value: unknown) => boolean } = {
  ghosts: (value) => Number.isInteger(value) && Number(value) >= 0 && Number(value) <= kMostGhosts,
  orthographic: isSwitch,
  focal_mm: (value) => typeof value === 'number' && value >= kShortestFocal_mm && value <= kLongestFocal_mm,
  ruler: isSwitch,
  path: isSwitch,
};

/** The setting of a stored view that is not allowed; undefined where all are. */
export function wrongSetting(view: Readonly<Record<string, unknown>>): string | undefined {
  return Object.entries(kAllowed).find(([name, allowed]) => view[name] !== undefined && !allowed(view[name]))?.[0];
}

export const initialView: ViewSettings = { orthographic: false, focal_mm: kUsualFocal_mm, ruler: false, ghosts: 0, path: false };
