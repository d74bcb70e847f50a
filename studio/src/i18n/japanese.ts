// SPDX-License-Identifier: MIT
// All that the page says in Japanese alone, which is fetched when it is asked for.
export { ja } from './ja';
export { messageWord } from './message_words';
export { japaneseMessages } from './messages_ja';
