// What the parts of the panel of joints share.

import type { JointOutline, PosedFigure } from '../engine/protocol.ts';
import type { Outcome } from './drives.ts';
import type { Node } from './ron.ts';

export interface JointState {
  // The scene's text as it was last without faults.
  tree: Node | null;
  joints: JointOutline[];
  links: PosedFigure['links'];
  // Where every coordinate is, and what acts on every degree of freedom.
  q: number[];
  moments: number[];
  // The chosen joint.
  chosen: string | null;
  // What became of the drives in the last run.
  outcomes: Outcome[];
  shows: 'pose' | 'motion' | 'live' | null;
  // The pose of the panel is newer than that of the text.
  ahead: boolean;
}

export const nothing = (): JointState => ({
  tree: null, joints: [], links: [], q: [], moments: [], chosen: null, outcomes: [], shows: null, ahead: false,
});
