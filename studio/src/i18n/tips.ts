// SPDX-License-Identifier: MIT
// Sentences on the effect of sliders and habits, one for each.
import { freedomName, jointName, spokenLanguage } from './index';

/** {place}: the limb or the joint that the parameter is of. */
interface Tips {
  readonly parameters: Readonly<Record<string, string>>;
  readonly weight: string;
  readonly criteria: Readonly<Record<string, string>>;
  readonly habits: Readonly<Record<string, string>>;
}

const english: Tips = {
  parameters: {
    squat: 'How far the knees end bent.',
    lean: 'How far the trunk ends tilted forwards from the hips.',
    round: 'How much the back rounds; below 0 it hollows.',
    twist: 'How far the trunk ends turned: above 0 to the left.',
    elbow: 'How far this elbow ends bent.',
    swivel: 'How far the elbow points out from the body; the hand stays where it is.',
    wrist: 'How far this wrist ends bent.',
    delay: 'How long the body waits before it takes its posture, as a share of the motion.',
    bow: 'How far the hand leaves the straight line: above 0 forwards, below 0 backwards.',
    skew: 'Where the hand’s curve is widest: above 0 nearer to the start, below 0 nearer to the end.',
    sway: 'How far the hand swings out to the side; below 0 inwards.',
    contraction: 'How much shorter {place} ends: knees or elbows bend more.',
    final: 'The angle that {place} ends with.',
    side: 'How far the trunk ends bent to the side.',
    turn: 'How far the trunk ends turned.',
    switch: 'When the first posture gives way to the second, as a share of the motion.',
    support: 'How hard the resting hand presses, as a share of the body’s weight; below 0 it stays free.',
  },
  weight: 'How stiff {place} is: the larger, the less it moves, and other joints do more.',
  criteria: {
    joint_range: 'Counts joints that come near their limits or pass them.',
    balance: 'Counts a body that leans away from above its feet.',
    torque: 'Counts joints that work hard beside their strength, over the whole motion.',
    balance_zone: 'Counts a centre of mass near or beyond the edge of the feet.',
    discomfort: 'Counts joints that are far from their easy middle.',
    joint_acceleration: 'Counts sudden starts and stops of joints.',
    work: 'Counts the work of lifting and braking, all joints together.',
    low_back: 'Counts the load on the lowest joint of the back.',
    head: 'Counts a head that hangs low, and eyes that cannot reach the goal.',
    collision: 'Counts arms that pass through the body and parts that pass through things.',
    centre_of_pressure: 'Counts moments at which the floor would have to press outside the feet.',
    feasibility: 'Counts the worst moment beyond the body’s strength or beyond its feet.',
    coordination: 'Counts knees that bend more or less than people’s do under such a trunk.',
    hand_curve: 'Counts a hand whose way differs from people’s, who curve it a little.',
    trunk_travel: 'Counts a shoulder that goes farther than the goal needs, or less far.',
    mass_ahead: 'Counts a body whose weight does not go along with the hands as people’s does.',
    jolts: 'Counts jolts: sudden changes of effort from one moment to the next.',
  },
  habits: {
    natural: 'Natural: knees and trunk bend as most people’s do.',
    half: 'Half squat: the knees bend as much as the trunk leans.',
    squat: 'Squat: the knees bend much, and the trunk stays up.',
    stoop: 'Stoop: the knees stay almost straight, and the trunk leans.',
    learned: 'Learned: the numbers in the task’s file.',
  },
};

const japanese: Tips = {
  parameters: {
    squat: '終わりの膝の曲がり具合です。',
    lean: '上体を股関節から前へ倒す角度です。',
    round: '背中の丸まり具合です。マイナスでは反ります。',
    twist: '上体をひねる角度です。プラスで左を向きます。',
    elbow: '終わりの肘の曲がり具合です。',
    swivel: '手の位置を変えずに、肘を体から外へ張る角度です。',
    wrist: '終わりの手首の曲がり具合です。',
    delay: '姿勢が変わり始めるまでの待ち時間です（動作全体に対する割合）。',
    bow: '手の軌道を直線からふくらませます。プラスで前へ、マイナスで後ろへふくらみます。',
    skew: '軌道のふくらみの位置です。プラスで始め寄り、マイナスで終わり寄りになります。',
    sway: '手の軌道を外側へふくらませます。マイナスで内側になります。',
    contraction: '{place}をどれだけ縮めるかです。大きいほど膝や肘が曲がります。',
    final: '{place}の終わりの角度です。',
    side: '上体を横へ倒す角度です。',
    turn: '上体を回す角度です。',
    switch: '前半の姿勢から後半の姿勢へ切り替わる時点です（動作全体に対する割合）。',
    support: '支える手が押す力です（体重に対する割合）。マイナスでは手をつきません。',
  },
  weight: '{place}の硬さです。大きいほど動かず、ほかの関節が補います。',
  criteria: {
    joint_range: '関節が可動域の限界に近づくことや、超えることを減点します。',
    balance: '体が足の真上から傾くことを減点します。',
    torque: '動作全体で、関節が筋力に対して大きな力を出すことを減点します。',
    balance_zone: '重心が足裏の縁に近づくことや、外へ出ることを減点します。',
    discomfort: '関節が楽な角度から離れることを減点します。',
    joint_acceleration: '関節の急な動き出しや急な停止を減点します。',
    work: '持ち上げや制動で全関節がする仕事を減点します。',
    low_back: '腰のいちばん下の関節にかかる負担を減点します。',
    head: '頭が低く垂れることや、目が目標を追えないことを減点します。',
    collision: '腕が体を、体が物を突き抜けることを減点します。',
    centre_of_pressure: '足の外で床に支えてもらわないとできない瞬間を減点します。',
    feasibility: '筋力や足裏の範囲を最も超える瞬間を減点します。',
    coordination: '上体の傾きに対して、膝の曲がりが人と違うことを減点します。',
    hand_curve: '少し弧を描く人の手の動きと違うことを減点します。',
    trunk_travel: '肩が必要以上に動くことや、動きが足りないことを減点します。',
    mass_ahead: '人のように手と一緒に体重が移らないことを減点します。',
    jolts: '力が一瞬で大きく変わる、がくんとした動きを減点します。',
  },
  habits: {
    natural: '自然：多くの人と同じように、膝と上体を曲げます。',
    half: '中腰：上体の傾きと同じだけ、膝を曲げます。',
    squat: 'しゃがむ：膝を大きく曲げ、上体を起こしておきます。',
    stoop: 'かがむ：膝をほとんど曲げず、上体を倒します。',
    learned: '学習した癖：タスクのファイルにある数値に従います。',
  },
};

const tips = (): Tips => (spokenLanguage() === 'ja' ? japanese : english);

/** The effect of a parameter; "" without a description. */
export function parameterTip(name: string): string {
  const parts = name.replace(/^later\./, '').replace(/(_deg|\.weight)$/, '').split('.');
  if (name.endsWith('.weight')) return tips().weight.replace('{place}', freedomName(parts.slice(-2).join('.')).toLowerCase());
  const last = (parts.pop() ?? '').replace(/^(left|right)_/, '');
  const place = parts.length > 1 ? freedomName(parts.join('.')) : jointName(parts[0] ?? '');
  return (tips().parameters[last] ?? '').replace('{place}', place.toLowerCase());
}

export function criterionTip(name: string): string {
  return tips().criteria[name] ?? '';
}

export function habitTip(name: string): string {
  return tips().habits[name] ?? '';
}
