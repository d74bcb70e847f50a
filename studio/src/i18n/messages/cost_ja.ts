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
};
