// SPDX-License-Identifier: MIT
// Colours of the three-dimensional view; those of the page around it are in styles/theme.css.
import { Color } from 'three';

/** The colours that a choice of theme comes to on this machine. */
export function shownTheme(theme: 'auto' | 'light' | 'dark'): 'light' | 'dark' {
  if (theme !== 'auto') return theme;
  return matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
}

export interface Palette {
  skin: Color;
  joints: Color;
  compared: Color;
  tag: string; // of a sign over a figure
  comparedTag: string;
  floor: Color;
  grid: Color;
  shadow: number; // opacity
  sky: Color;
  ground: Color;
  goal: Color;
  idle: Color;
  path: Color;
  comparedPath: Color;
  mass: Color;
  support: Color;
  missing: Color;
  ghost: Color;
  ruler: Color;
  /** From slow to fast, in even steps of lightness, for people who cannot distinguish the hues. */
  speed: readonly Color[];
  light: number; // of the key light
  rim: number; // of the light from behind
  ambient: number;
}

export const palettes: Record<'light' | 'dark', Palette> = {
  light: {
    skin: new Color('#dedad3'),
    joints: new Color('#7b858e'),
    compared: new Color('#7fa8c9'), tag: '#6b6459', comparedTag: '#3d6f97',
    floor: new Color('#e9ecee'),
    grid: new Color('#9aa5ad'),
    shadow: 0.28,
    sky: new Color('#ffffff'),
    ground: new Color('#b9b2a8'),
    goal: new Color('#e8762c'),
    idle: new Color('#5b7f95'),
    path: new Color('#e8762c'),
    comparedPath: new Color('#3b7fb5'),
    mass: new Color('#2f8f6b'),
    support: new Color('#2f8f6b'),
    missing: new Color('#c62d42'),
    ghost: new Color('#4f7f9e'),
    ruler: new Color('#4a5963'),
    speed: ['#63bfe1', '#7193df', '#955dbc', '#a02262', '#790d14'].map((colour) => new Color(colour)),
    light: 2.3,
    rim: 0.7,
    ambient: 1.35,
  },
  dark: {
    skin: new Color('#cfcbc4'),
    joints: new Color('#6d7780'),
    compared: new Color('#6f9cc2'), tag: '#7d766b', comparedTag: '#3d6f97',
    floor: new Color('#20262b'),
    grid: new Color('#66727c'),
    shadow: 0.5,
    sky: new Color('#dfe8f0'),
    ground: new Color('#4a4640'),
    goal: new Color('#ff9146'),
    idle: new Color('#7fa9c2'),
    path: new Color('#ff9146'),
    comparedPath: new Color('#6cb2ea'),
    mass: new Color('#58c79b'),
    support: new Color('#58c79b'),
    missing: new Color('#ff6b7d'),
    ghost: new Color('#8fb9d6'),
    ruler: new Color('#aebbc4'),
    speed: ['#385db8', '#a55bc5', '#f46a86', '#ffa167', '#f0e765'].map((colour) => new Color(colour)),
    light: 2.0,
    rim: 1.6,
    ambient: 0.85,
  },
};
