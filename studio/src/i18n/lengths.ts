// SPDX-License-Identifier: MIT
// The unit that lengths are shown and typed in; documents keep metres.

const kUnits = {
  cm: { perMetre: 100, step: 1, digits: 1 },
  in: { perMetre: 1 / 0.0254, step: 0.5, digits: 2 },
} as const;

export type LengthUnit = keyof typeof kUnits;
export const lengthUnits = Object.keys(kUnits) as LengthUnit[];

const kInchesInFoot = 12;

let unit: LengthUnit = 'cm';

export function setLengthUnit(next: LengthUnit): void {
  unit = next;
}

export const isLengthUnit = (text: string | null): text is LengthUnit => text !== null && text in kUnits;

/** The unit's name, and how numbers in it are shown and stepped. */
export function lengths(): { name: LengthUnit; perMetre: number; step: number; digits: number } {
  return { name: unit, ...kUnits[unit] };
}

/** "3.2 cm" */
export function lengthWords(metres: number): string {
  return `${(metres * kUnits[unit].perMetre).toFixed(1)} ${unit}`;
}

/** "174 cm", "5 ft 8.5 in" */
export function statureWords(metres: number): string {
  if (unit === 'cm') return `${(metres * kUnits.cm.perMetre).toFixed(0)} cm`;
  const halves = Math.round(2 * metres * kUnits.in.perMetre); // of an inch
  return `${Math.floor(halves / 2 / kInchesInFoot)} ft ${(halves / 2) % kInchesInFoot} in`;
}
