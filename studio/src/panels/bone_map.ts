// SPDX-License-Identifier: MIT
// Which node of a file is which bone, to be mended by hand.
import type { CharacterSpec } from '../../../bindings/wasm/src/types';
import { jointName, t } from '../i18n';
import type { Document } from '../state/model';
import { button, h, select } from './dom';

/** Folded at first; `change` opens the character anew with another map. */
export function boneMap(
  bones: readonly string[], { spec, description }: Document['character'], change: (more: Partial<CharacterSpec>) => void,
): HTMLDetailsElement {
  const nodes = [...new Set(description.nodes.map((node) => node.name).filter((name) => name !== ''))];
  const changed = new Map<string, string>();
  const apply = button(t('apply'), () => change({ map: { ...spec.map, ...Object.fromEntries(changed) } }), { class: 'primary', disabled: true, 'data-key': 'apply map' });
  const rows = bones.map((bone) => {
    const now = spec.map?.[bone] ?? description.humanoid[bone] ?? '';
    const known = now === '' || nodes.includes(now) ? nodes : [now, ...nodes];
    const choice = select(jointName(bone), [['', t('nothing')], ...known.map((name) => [name, name] as const)], now, (name) => {
      if (name === now || name === '') changed.delete(bone);
      else changed.set(bone, name);
      apply.disabled = changed.size === 0;
    });
    choice.dataset['bone'] = bone;
    return h('tr', {}, h('th', { scope: 'row' }, jointName(bone)), h('td', {}, choice));
  });
  return h('details', {}, h('summary', {}, t('boneMap')),
    h('table', { class: 'bones' }, h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, t('bone')), h('th', { scope: 'col' }, t('node')))), h('tbody', {}, ...rows)),
    h('div', { class: 'buttons' }, apply));
}
