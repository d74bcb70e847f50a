// SPDX-License-Identifier: MIT
// One colour for each freedom, the same in every motion and plot: the hue is the joint's, the lightness its axis. Left is dashed.
const kHues: Record<string, number> = {
  ankle: 265, knee: 205, hip: 175, spine: 135, chest: 100, upper_chest: 75, neck: 52, head: 28, clavicle: 345, shoulder: 8, elbow: 320, wrist: 290,
};
/** Steps of lightness: none for the axis of a joint that people think of first, one for what is not here. */
const kSteps: Record<string, number> = { flexion: 0, elevation: 0, rotation: 2 };
const kOwnHues = 31; // degrees from one joint that has no place above to the next

export type Side = 'right' | 'left' | 'middle';
export const sides: readonly Side[] = ['right', 'left', 'middle'];

export function sideOf(name: string): Side {
  return name.startsWith('left_') ? 'left' : name.startsWith('right_') ? 'right' : 'middle';
}

/** `index`: of the freedom in the body. */
export function freedomColour(name: string, index: number, dark: boolean): string {
  const [joint = '', axis = ''] = name.replace(/^(left|right)_/, '').split('.');
  const hue = kHues[joint] ?? (kOwnHues * index) % 360;
  const step = kSteps[axis] ?? 1;
  return `hsl(${hue}, ${dark ? 70 - 8 * step : 72 - 10 * step}%, ${dark ? 62 + 9 * step : 36 + 9 * step}%)`;
}
