// SPDX-License-Identifier: MIT
// The engine's sentences in Japanese by their keys, with {0} where the first value stands; one file for each of
// src/core/messages.
import { characters } from './messages/characters_ja';
import { cost } from './messages/cost_ja';
import { files } from './messages/files_ja';
import { people } from './messages/people_ja';
import { results } from './messages/results_ja';
import { robots } from './messages/robots_ja';
import { tasks } from './messages/tasks_ja';
import { words } from './messages/words_ja';

export const japaneseMessages: Readonly<Record<string, string>> = { ...words, ...people, ...robots, ...files, ...characters, ...cost, ...tasks, ...results };
