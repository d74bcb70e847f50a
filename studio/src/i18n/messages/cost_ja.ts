// SPDX-License-Identifier: MIT
// Of what a motion costs the body.
export const cost: Readonly<Record<string, string>> = {
  lift_number: '{0} です。0 以上にしてください。',
  lift_too_far: '手が足首から遠すぎるため、許容される質量はありません。',
  lift_too_high: '手が高すぎるため、許容される質量はありません。',
  lift_too_long: '上げ下げの距離が長すぎるため、許容される質量はありません。',
  lift_too_turned: '手が正面から 135° を超えて横にあるため、許容される質量はありません。',
  lift_too_often: '毎分 {0} 回はこの作業時間には多すぎるため、許容される質量はありません。',
  lift_between: '毎分 {0} 回の値は表にありません。許容される質量のない行の隣にあるためです。',
  lift_none_allowed: '許容される質量のない持ち上げがあるため、全体の指数はありません。',
  lift_one_hand: '持ち上げの式は両手用ですが、{0} は片手で持っています。',
  lift_sits: '持ち上げの式は立っている人用です。',
  lift_fast: '持ち上げの式はもっと遅い動き用です。手の速さは {0} m/s です。',
  cost_no_neck: 'この体の頭は胴に対して動かないため、首は中立とします。',
  cost_no_wrists: 'この体には手首がないため、中立とします。',
  cost_home_leans: '体の初期姿勢が中立ではないため、すべての角度を 0 とした姿勢を中立とします。',
  cost_rigid_trunk: '胴が曲がらない体のため、L5/S1 のモーメントは股関節まわりから求め、力は分かりません。',
  cost_lacks_parts: 'この体には REBA と RULA が評価する部位がありません。',
  cost_option: '{0} です。{1} にしてください。',
};
