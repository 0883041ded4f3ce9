// What the scene's text says of degrees of freedom: which name or pattern, with which drives.

import type { Dof, JointOutline } from '../engine/protocol.ts';
import { field, isMeant, type Node } from './ron.ts';

export interface Said {
  text: string;
  // The name or pattern that says it; null: its own name.
  from: string | null;
  // Where it stands.
  span: [number, number] | null;
}

// The closest name wins: its own, its joint's, the last pattern.
export function drivesOf(text: string, tree: Node | null, joint: JointOutline, dof: Dof | null): Said {
  const entries = field(tree, 'drives')?.entries ?? [];
  const meant = (key: string): boolean => isMeant(key, joint.name) || (dof !== null && isMeant(key, dof.name));
  const found =
    entries.find(({ key }) => key === dof?.name) ??
    entries.find(({ key }) => key === joint.name) ??
    entries.findLast(({ key }) => key.includes('*') && meant(key));
  if (!found) return { text: 'Free', from: 'the scene, which says nothing', span: null };
  const own = found.key === (dof ? dof.name : joint.name);
  const { from, to } = found.value;
  return { text: text.slice(from, to), from: own ? null : found.key, span: [from, to] };
}

// Ball and free joints have no coordinates of their own: where theirs begin in q, and how many.
export function coordinatesOf(joints: JointOutline[], length: number): Map<string, [number, number]> {
  const found = new Map<string, [number, number]>();
  let at = 0;
  for (const { name, dofs } of joints) {
    const count = isWhole(dofs) ? dofs.length + 1 : dofs.length;
    found.set(name, [at, count]);
    at += count;
  }
  return at === length ? found : new Map();
}

// A ball joint or a free joint: its velocities are the rates of no coordinate.
export const isWhole = (dofs: Dof[]): boolean => (dofs.length === 3 || dofs.length === 6) && dofs.every(({ coordinate }) => coordinate === null) && dofs[dofs.length - 1].name.endsWith('.wz');
