// SPDX-License-Identifier: MIT
// The engine's names of joints and parameters, the words of its tables, and its words for postures, as people say them.
import type { Facts } from '../../../bindings/wasm/src/types';

/** The words of the engine's tables that the page shows. */
export function tableWords(facts: Facts): Record<TableWords, string[]> {
  const names = (rows: readonly { name: string }[]): string[] => rows.map(({ name }) => name);
  return {
    criteria: names(facts.criteria), presets: names(facts.presets), habits: names(facts.habits), bodies: names(facts.bodies), sexes: facts.sexes,
    formats: names(facts.formats.filter(({ written }) => written)), jointNames: names(facts.joint_names), timing: names(facts.timing.filter(({ of }) => of === 'task')),
  };
}

export type TableWords = 'criteria' | 'presets' | 'habits' | 'bodies' | 'sexes' | 'formats' | 'jointNames' | 'timing';

export interface BodyWords extends Record<TableWords, Record<string, string>> {
  sides: Record<string, string>;
  joints: Record<string, string>;
  axes: Record<string, string>;
  parameters: Record<string, string>;
  groups: Record<string, string>;
  posture: Record<string, string>;
  join: (side: string, rest: string) => string;
}

export const englishBody: BodyWords = {
  sides: { left: 'left', right: 'right' },
  joints: {
    ankle: 'ankle', knee: 'knee', hip: 'hip', hips: 'hips', spine: 'lower back', chest: 'middle back', upper_chest: 'upper back', neck: 'neck', head: 'head',
    clavicle: 'collarbone', shoulder: 'shoulder', elbow: 'elbow', wrist: 'wrist', hand: 'hand', foot: 'foot', toes: 'toes', trunk: 'trunk',
    upper_arm: 'upper arm', lower_arm: 'forearm', upper_leg: 'thigh', lower_leg: 'shank', arm: 'arm', leg: 'leg', legs: 'legs', arms: 'arms',
    thigh: 'thigh', shank: 'shank', forearm: 'forearm', pelvis: 'pelvis', jaw: 'jaw', floor: 'floor',
  },
  axes: {
    flexion: 'flexion', abduction: 'abduction', rotation: 'rotation', inversion: 'inversion', lateral: 'side bend',
    elevation: 'elevation', protraction: 'protraction', deviation: 'deviation',
  },
  parameters: {
    squat: 'Squat', lean: 'Lean', round: 'Round back', twist: 'Twist', elbow: 'Elbow', swivel: 'Elbow out', wrist: 'Wrist',
    delay: 'Start later', bow: 'Arc ahead', skew: 'Arc early or late', sway: 'Arc sideways', contraction: 'Bend', final: 'Final angle', side: 'Side bend', switch: 'Change at', turn: 'Turn',
  },
  groups: {
    posture: 'Posture', path: 'Path of the hand', trunk: 'Trunk', legs: 'Legs', arms: 'Arms', right_leg: 'Right leg', left_leg: 'Left leg',
    right_arm: 'Right arm', left_arm: 'Left arm', head: 'Head',
  },
  criteria: {
    joint_range: 'Joint limits', balance: 'Upright posture', torque: 'Joint torque', balance_zone: 'Weight above the feet', discomfort: 'Comfort',
    joint_acceleration: 'Smoothness', work: 'Work', low_back: 'Lower back', head: 'Head and gaze', collision: 'Collision', centre_of_pressure: 'Pressure within the feet', feasibility: 'Within strength',
    coordination: 'Coordination', hand_curve: 'Curve of the hand', trunk_travel: 'Still trunk', mass_ahead: 'Weight goes along', jolts: 'No jolts',
  },
  presets: { flat: 'whole body', human: 'trunk first', paper: 'as published', layers: 'trunk first, as published' },
  habits: { natural: 'natural', half: 'half squat', squat: 'squat', stoop: 'stoop' },
  bodies: { human: 'Person', full_body: 'Person, simple', half_body: 'One arm and one leg' },
  sexes: { male: 'male', female: 'female' },
  formats: { glb: 'GLB', vrma: 'VRMA', bvh: 'BVH', csv: 'CSV', npz: 'NPZ', svg: 'Strip, SVG', png: 'Strip, PNG', pdf: 'Strip, PDF', task: 'Task, JSON', result: 'Result, JSON' },
  timing: {
    ease: 'Right: quick to begin and gentle to end. Left: slow to begin.', gaze_lead: 'How much earlier the head turns to the goal than people’s does, as a share of the time.',
  },
  jointNames: { own: 'as here', mixamo: 'Mixamo', unreal: 'Unreal', humanik: 'HumanIK' },
  posture: {},
  join: (side, rest) => (side === '' ? rest : `${side} ${rest}`),
};

export const japaneseBody: BodyWords = {
  sides: { left: '左', right: '右' },
  joints: {
    ankle: '足首', knee: '膝', hip: '股関節', hips: '腰', spine: '腰椎', chest: '胸椎', upper_chest: '上部胸椎', neck: '首', head: '頭',
    clavicle: '鎖骨', shoulder: '肩', elbow: '肘', wrist: '手首', hand: '手', foot: '足', toes: 'つま先', trunk: '体幹',
    upper_arm: '上腕', lower_arm: '前腕', upper_leg: '大腿', lower_leg: '下腿', arm: '腕', leg: '脚', legs: '両脚', arms: '両腕',
    thigh: '大腿', shank: '下腿', forearm: '前腕', pelvis: '骨盤', jaw: '顎', floor: '床',
  },
  axes: {
    flexion: '屈曲', abduction: '外転', rotation: '回旋', inversion: '内がえし', lateral: '側屈',
    elevation: '挙上', protraction: '前方突出', deviation: '橈尺屈',
  },
  parameters: {
    squat: 'しゃがみ', lean: '前傾', round: '背中の丸め', twist: 'ひねり', elbow: '肘', swivel: '肘の張り', wrist: '手首',
    delay: '開始の遅れ', bow: '軌道のふくらみ（前）', skew: 'ふくらみの位置', sway: '軌道のふくらみ（横）', contraction: '曲げ', final: '最終角', side: '側屈', switch: '切り替え', turn: '回転',
  },
  groups: {
    posture: '姿勢', path: '手の軌道', trunk: '体幹', legs: '脚', arms: '腕', right_leg: '右脚', left_leg: '左脚', right_arm: '右腕', left_arm: '左腕', head: '頭',
  },
  criteria: {
    joint_range: '関節の限界', balance: '直立バランス', torque: '関節トルク', balance_zone: 'バランス', discomfort: '快適さ',
    joint_acceleration: '滑らかさ', work: '仕事量', low_back: '腰の負担', head: '頭と視線', collision: '衝突', centre_of_pressure: '姿勢の安定（立位維持）', feasibility: '力の範囲',
    coordination: '全身の連動', hand_curve: '手の軌道の弧', trunk_travel: '体幹の安定', mass_ahead: '重心の移動', jolts: '急変のなさ',
  },
  presets: { flat: '全身まとめて', human: '体幹から順に', paper: '論文どおり', layers: '体幹から順に（論文どおり）' },
  habits: { natural: '自然', half: '中腰', squat: 'しゃがむ', stoop: 'かがむ' },
  bodies: { human: '人', full_body: '人（簡略）', half_body: '片腕片脚' },
  sexes: { male: '男性', female: '女性' },
  formats: { glb: 'GLB', vrma: 'VRMA', bvh: 'BVH', csv: 'CSV', npz: 'NPZ', svg: '連続図 SVG', png: '連続図 PNG', pdf: '連続図 PDF', task: 'タスク JSON', result: '結果 JSON' },
  timing: {
    ease: '右へ：早く動き出し、ゆっくり終わります。左へ：ゆっくり動き出します。', gaze_lead: '頭が目標を向くのを人より早める量（所要時間に対する割合）。',
  },
  jointNames: { own: 'この画面の名前', mixamo: 'Mixamo', unreal: 'Unreal', humanik: 'HumanIK' },
  posture: {
    squat: 'しゃがむ', stoop: 'かがむ', 'half squat': '中腰', upright: '直立', 'turned left': '左にひねる', 'turned right': '右にひねる',
    'elbow out': '肘を張る', 'elbow in': '肘を締める', 'knees bent': '膝を曲げる', 'straight knees': '膝を伸ばす', leaning: '傾く', sitting: '座る', 'leaning left': '左に傾く',
    'leaning right': '右に傾く', 'on tiptoe': 'つま先立ち', 'heels up': 'かかとを上げる', 'leaning ahead': '前に傾く', 'leaning back': '後ろに傾く', standing: '立つ',
  },
  join: (side, rest) => side + rest,
};
