// SPDX-License-Identifier: MIT
// The language that the page speaks.
import { type BodyWords, englishBody, japaneseBody, type TableWords, tableWords } from './body_words';
import type { EngineFailure, Facts, Message } from '../../../bindings/wasm/src/types';
import { recall } from '../kept/memory';
import { fetchPart } from '../offline/part';
import { en, type Key } from './en';
import { englishOf, wordsOf } from './engine_text';
import { lengths, lengthWords } from './lengths';

export type Language = 'en' | 'ja';
export type { Key };

let language: Language = 'en';
let japanese: typeof import('./japanese') | null = null;

/** Fetches the texts of a language, before it is set. */
export async function fetchLanguage(next: Language): Promise<void> {
  if (next === 'ja') japanese ??= await fetchPart(() => import('./japanese'));
}

export function setLanguage(next: Language): void {
  language = next;
  document.documentElement.lang = next;
}

export function spokenLanguage(): Language {
  return language;
}

export function preferredLanguage(): Language {
  const kept = recall('language');
  if (kept === 'en' || kept === 'ja') return kept;
  return navigator.languages.some((name) => name.startsWith('ja')) && navigator.language.startsWith('ja') ? 'ja' : 'en';
}

/** {length} is a length in metres, and {unit} the default unit of lengths. */
export function t(key: Key, values: Record<string, string | number> = {}): string {
  const text = (language === 'ja' ? japanese!.ja : en)[key];
  return text.replace(/\{(\w+)\}/g, (whole, name: string) => {
    const value = values[name] ?? (name === 'unit' ? lengths().name : whole);
    return name === 'length' && typeof value === 'number' ? lengthWords(value) : String(value);
  });
}

function words(): BodyWords {
  return language === 'ja' ? japaneseBody : englishBody;
}

const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** "right_shoulder" in the language's words; unknown names stay unchanged. */
export function jointName(name: string): string {
  const table = words();
  const match = /^(left|right)_(.+)$/.exec(name);
  const rest = match?.[2] ?? name;
  const joint = table.joints[rest] ?? rest.replaceAll('_', ' ');
  return capital(table.join(match ? (table.sides[match[1]!] ?? '') : '', joint));
}

/** "flexion" */
export function axisName(axis: string): string {
  return words().axes[axis] ?? axis.replaceAll('_', ' ');
}

/** "right_knee.flexion" */
export function freedomName(name: string): string {
  const [joint = '', axis = ''] = name.split('.');
  return `${jointName(joint)} ${axisName(axis)}`.trim();
}

/** A name as it stands within a sentence. */
export const inSentence = (name: string): string => name.charAt(0).toLowerCase() + name.slice(1);

/** "squat_deg", "right_knee.flexion.weight", "right_arm.swivel_deg", "bow". */
export function parameterName(name: string): string {
  const table = words();
  if (name.endsWith('.weight')) {
    const parts = name.slice(0, -'.weight'.length).split('.');
    return freedomName(parts.slice(-2).join('.'));
  }
  const parts = name.replace(/_deg$/, '').split('.');
  const last = parts[parts.length - 1] ?? name;
  const match = /^(left|right)_(.+)$/.exec(last);
  const spoken = table.parameters[match?.[2] ?? last];
  if (parts.length > 1) {
    const place = parts.slice(0, -1).map(jointName).join(' ');
    return `${place} ${(spoken ?? last).toLowerCase()}`;
  }
  return spoken ?? jointName(last);
}

export function groupName(group: string): string {
  return words().groups[group] ?? jointName(group);
}

/** The translation of a word of the engine's tables; untranslated words stay unchanged. */
export function engineWord(table: TableWords, word: string): string {
  return words()[table][word] ?? word.replaceAll('_', ' ');
}

let engineFacts: Facts | null = null;

/** Whose sentences are told. */
export function knowEngine(facts: Facts): void {
  engineFacts = facts;
}

/** A sentence of the engine's, as a doubt, in the page's language. */
export function engineText(message: Message): string {
  const { japaneseMessages, messageWord } = japanese ?? {};
  return wordsOf(message, language === 'ja' && japaneseMessages && messageWord
    ? { sentence: (key) => japaneseMessages[key], word: (text) => messageWord(text, jointName) } : englishOf(engineFacts!));
}

/** Why the engine refused. */
export function failureText({ message, reason }: EngineFailure): string {
  if (!reason) return message;
  return engineText(reason.place === '' ? reason.message : { key: 'at_place', values: [reason.place, reason.message], text: message });
}

/** Words of the engine's tables that a language has none for: "criteria: work". */
export async function untranslated(facts: Facts, of: Language): Promise<string[]> {
  await fetchLanguage(of);
  const known = of === 'ja' ? japaneseBody : englishBody;
  const ofTables = Object.entries(tableWords(facts)).flatMap(([table, all]) =>
    all.filter((word) => !(word in known[table as TableWords])).map((word) => `${table}: ${word}`));
  // in English the engine's own sentences are shown
  return of === 'ja' ? [...ofTables, ...facts.messages.filter(({ key }) => !(key in japanese!.japaneseMessages)).map(({ key }) => `messages: ${key}`)] : ofTables;
}

/** How a motion ends: "stoop, turned left". */
export function postureWords(text: string): string {
  const table = words().posture;
  const separator = language === 'ja' ? '・' : ', ';
  return text.split(', ').map((word) => table[word] ?? word).join(separator);
}
