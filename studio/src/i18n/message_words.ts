// SPDX-License-Identifier: MIT
// Values within the engine's messages in Japanese: bones, limbs, sides, units and places.

const kWords: Readonly<Record<string, string>> = {
  left: '左', right: '右', 'left ': '左', 'right ': '右', thigh: '大腿', shank: '下腿', 'upper arm': '上腕', forearm: '前腕', arm: '腕', leg: '脚',
  metres: 'メートル', decimetres: 'デシメートル', 'its heel': 'かかと', head: '頭', centimetres: 'センチメートル', millimetres: 'ミリメートル', inches: 'インチ', 'nothing follows': '何も続きません',
  effector: '動かす部位', key: 'キー', word: '語', bone: 'ボーン', format: '形式', axis: '軸', direction: '向き', contact: '立つ足', hand: '手', place: '場所',
  parameter: '値', 'posture parameter': '姿勢の値', value: '値', weight: '重み', task: 'タスク', missing: 'なし', nothing: '何もありません',
  'a comment': 'コメント', 'a CDATA section': 'CDATA 区間', 'the name of a file beside this one': 'このファイルと同じ場所にあるファイルの名前',
  '64 hexadecimal digits, of a file': 'ファイルの 16 進数 64 桁',
  stature: '身長', mass: '体重', seat: '座面の高さ', character: 'キャラクター', goal: '目標', 'joint names': '関節の名前', "the clip's name": 'アニメーション名',
};

/** `joint`: a joint's or limb's name as the page says it. */
export function messageWord(value: string, joint: (name: string) => string): string {
  const known = kWords[value];
  if (known !== undefined) return known;
  const goal = /^goal of (.+)$/.exec(value)?.[1];
  if (goal !== undefined) return `${joint(goal)}の目標`;
  const format = /^the format (\w+)$/.exec(value)?.[1];
  if (format !== undefined) return `${format.toUpperCase()} 形式`;
  const only = /^comes only (.+)$/.exec(value)?.[1];
  if (only !== undefined) return `${messageWord(only, joint)}だけです`;
  const tip = /^the End Site of '(.+)'$/.exec(value)?.[1];
  if (tip !== undefined) return `「${tip}」の先端`;
  const node = /^(?:joint|node \d+) '(.+)'$/.exec(value)?.[1];
  if (node !== undefined) return `「${node}」`;
  // "left leg", "left_upper_leg"
  if (/^(?:left|right)[ _][a-z_ ]+$/.test(value)) return joint(value.replaceAll(' ', '_'));
  return value;
}
