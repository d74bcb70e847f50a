// SPDX-License-Identifier: MIT
// All that the page says in Japanese alone, which is fetched when it is asked for.
export { EngineTexts, wordlessMessages } from './engine_text';
export { ja } from './ja';
export { messageWord } from './message_words';
