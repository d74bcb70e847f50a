// SPDX-License-Identifier: MIT
// The tips of the sliders: of a parameter the chosen motion with its least and its greatest value, of a criterion the motions
// that pay least and most for it.
import type { Candidate, Parameter } from '../../../bindings/wasm/src/types';
import { t } from '../i18n';
import { criterionTip, parameterTip } from '../i18n/tips';
import { candidateAt, type Document } from '../state/model';
import type { Studio } from '../state/studio';
import { trial } from '../state/trial';
import { drawSticks } from '../view/stick_drawing';
import { round } from './dom';
import { type End, tipPicture } from './tip_picture';
import type { Tip } from './tooltip';

function endOf({ character }: Document, candidate: Candidate, caption: string): End {
  return { half: drawSticks(character, candidate, 0.5), whole: drawSticks(character, candidate, 1), caption };
}

export function tipOfParameter(studio: Studio, { name, low, high, scale, unit }: Parameter): Tip {
  const caption = (value: number): string => (scale === 'log' ? String(Number(value.toPrecision(2))) : unit === 'deg' ? `${round(value, 0)}°` : round(value));
  return {
    text: parameterTip(name),
    picture: async () => {
      const { document } = studio;
      if (!document) return null;
      const ends = await Promise.all([low, high].map((value, index) => trial(studio, { [name]: String(value) }, index === 0 ? 'low' : 'high')));
      const [least, most] = ends;
      if (!least || !most) return null;
      return tipPicture(document.character, [endOf(document, least, caption(low)), endOf(document, most, caption(high))]);
    },
  };
}

export function tipOfCriterion(studio: Studio, name: string): Tip {
  return {
    text: criterionTip(name),
    picture: async () => {
      const { document } = studio;
      const all = Array.from({ length: document?.result?.candidates.length ?? 0 }, (_, index) => candidateAt(document!, index)!);
      const paid = (candidate: Candidate): number => candidate.summary.criteria[name] ?? Number.NaN;
      const known = all.filter((candidate) => Number.isFinite(paid(candidate))).sort((a, b) => paid(a) - paid(b));
      const [least] = known;
      const most = known[known.length - 1];
      if (!document || !least || !most || paid(most) - paid(least) < 0.005) return null;
      return tipPicture(document.character, [endOf(document, least, t('paysLeast')), endOf(document, most, t('paysMost'))]);
    },
  };
}
