// SPDX-License-Identifier: MIT
// The tone of each message over the view: `bad` is red.
import type { Key } from './en';

export type Tone = 'plain' | 'bad';

export const noticeTones = {
  // the search
  cancelled: 'plain', unreachable: 'bad', unturnedBest: 'bad', editMisses: 'bad', onFloor: 'plain', badSeed: 'bad', badRange: 'bad', unknownGoals: 'bad', otherPosture: 'bad',
  // files that come in
  badPacked: 'bad', badLink: 'bad', changedFile: 'bad', unknownFile: 'bad', tooLarge: 'bad', unknownWanted: 'bad', oneAtATime: 'bad', noRoom: 'bad', alsoKept: 'plain', importedLibrary: 'plain',
  // what leaves
  saved: 'plain', linkCopied: 'plain', largeLink: 'bad', pictureTooLarge: 'bad', filmSaved: 'plain', filmCancelled: 'plain', filmHidden: 'plain', noFilm: 'bad',
  // keeping
  openElsewhere: 'plain', keepsNothing: 'bad', storageFull: 'bad', storageFailed: 'bad', fileTooLarge: 'bad',
  // the page
  partFailed: 'bad', pictureBack: 'plain',
} as const satisfies Partial<Record<Key, Tone>>;

export type NoticeKey = keyof typeof noticeTones;
