// SPDX-License-Identifier: MIT
import { type Key, t } from '../i18n';
import { h, iconButton } from './dom';

const kKeys: readonly (readonly [string, Key])[] = [
  ['Space', 'keySpace'], ['1 … 9', 'keyDigits'], ['Shift + 1 … 9', 'keyShiftDigits'], [', .', 'keyFrame'],
  ['← → ↑ ↓ PgUp PgDn', 'keyArrows'], ['[ ]', 'keyBrackets'], ['Enter', 'keyEnter'], ['Ctrl + Z / Y', 'keyUndo'], ['Ctrl + S', 'keySave'], ['M', 'keyMirror'], ['V', 'keySides'], ['F', 'keyApproach'], ['Home', 'keyHome'], ['O', 'keyOrthographic'], ['U', 'keyRuler'], ['G', 'keyGhosts'], ['P', 'keyPath'], ['Esc', 'keyEscape'], ['?', 'keyHelp'],
];

export function helpDialog(): HTMLDialogElement {
  const dialog = h('dialog', { class: 'help', 'aria-labelledby': 'help-title' },
    h('header', {}, h('h2', { id: 'help-title' }, t('helpTitle')), iconButton('close', t('close'), () => dialog.close())),
    ...(['help1', 'help2', 'help3', 'help4', 'help5'] as const).map((key) => h('p', {}, t(key))),
    h('h3', {}, t('keys')),
    h('dl', {}, ...kKeys.flatMap(([keys, key]) => [h('dt', {}, ...keys.split(' ').map((part) => (/^[+…/]$/.test(part) ? ` ${part} ` : h('kbd', {}, part)))), h('dd', {}, t(key))])));
  return dialog;
}
