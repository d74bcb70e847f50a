// SPDX-License-Identifier: MIT
// The last change of a project, noted at once where the database may come too late: at the page's end, or before a crash.
import { forget, recall, remember } from './memory';
import type { Project } from './projects';
import type { Work } from './work';

const kMost = 1_500_000; // letters; browsers have room for some five million of all the page's notes

const keyOf = (id: string): string => `journal.${id}`;

export interface Noted {
  readonly project: Project; // as it was kept before the change
  readonly work: unknown; // to be read with care
}

/** Notes a work that is to be the project's next revision; one that is too large takes the place of none. */
export function note(project: Project, work: Work): void {
  const { picture: _, ...small } = project;
  const text = JSON.stringify({ project: small, work });
  if (text.length > kMost) strike(project.id);
  else remember(keyOf(project.id), text);
}

/** What was noted and has not been kept: of a project at that revision, 0 of one that is not kept. */
export function noted(id: string, revision: number): Noted | null {
  const text = recall(keyOf(id));
  if (text === null) return null;
  try {
    const { project, work } = JSON.parse(text) as Noted;
    // of a later revision where a save that was on its way is lost
    return project.id === id && typeof project.name === 'string' && project.revision >= revision ? { project, work } : null;
  } catch {
    return null;
  }
}

export const strike = (id: string): void => forget(keyOf(id));
