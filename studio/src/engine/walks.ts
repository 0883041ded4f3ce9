// Walks and runs.

import { Figure, peopleCurves, skinOf, walk, walkRange, type WalkOptions } from '../../dist/engine/engine.js';
import { keepMotion } from './motions.ts';
import type { People, ShownMotion, Who } from './protocol.ts';
import type { Context } from './worker.ts';

// Walkers turn by their heading first, so that any turn can be walked.
export const human = ({ height, mass, age, load, shorterLeg, cane }: Who): Figure => Figure.human(height, mass, age, { load, shorterLeg, cane });

export interface Walked extends ShownMotion {
  // As `GaitOptions::make` tells it.
  report: Record<string, never>;
}

export const walks = {
  // Without the skin.
  walk(_: Context, who: Who, options: WalkOptions, title: string): Walked {
    const figure = human(who);
    try {
      const motion = walk(figure, options);
      const report = motion.report as Record<string, never>;
      return { report, ...keepMotion(motion, title, false) };
    } finally {
      figure.free();
    }
  },
  // People's curves at the pace that is nearest.
  people: (_: Context, speed: number): People => JSON.parse(peopleCurves(speed)),
  skin(_: Context, who: Who): string | null {
    const figure = human(who);
    try {
      return skinOf(figure) ?? null;
    } finally {
      figure.free();
    }
  },
  walkRange(_: Context, who: Who, options: WalkOptions, field: string): number[] | null {
    const figure = human(who);
    try {
      const range = walkRange(figure, options, field);
      return range ? [...range] : null;
    } finally {
      figure.free();
    }
  },
};
