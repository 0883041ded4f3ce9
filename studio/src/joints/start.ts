// Poses by hand: what is written of them, and how far a drag reaches.

import type { Edit } from '../document.ts';
import { plain, position, quote } from './ron.ts';
import { coordinatesOf, isWhole } from './said.ts';
import type { JointState } from './state.ts';

// Coordinates of q that differ from those of the text, as edits of its start.
export function startEdits({ joints, q }: JointState, before: number[]): Edit[] {
  const places = coordinatesOf(joints, q.length);
  return joints.flatMap(({ name, dofs }): Edit[] => {
    if (isWhole(dofs)) {
      const [at, count] = places.get(name) ?? [0, 0];
      const now = q.slice(at, at + count);
      // A free joint stays where it is: only turns are written.
      if (count !== 4 || now.every((value, i) => Math.abs(value - before[at + i]) < 1e-9)) return [];
      return [{ path: ['start', quote(name)], value: `Quaternion(${now.map((part) => plain(part, 8)).join(', ')})` }];
    }
    return dofs
      .filter(({ coordinate }) => coordinate !== null && Math.abs(q[coordinate] - before[coordinate]) > 1e-7)
      .map((dof) => ({ path: ['start', quote(dof.name)], value: position(q[dof.coordinate!], dof.turns) }));
  });
}

// How many joints give way to a drag at a link: up to the shoulder or the hip, or three.
export function limbOf({ joints, links }: JointState, link: number): number {
  let count = 0;
  for (let at: number | null = link; at !== null; at = links[at]?.parent ?? null) {
    const joint = joints.find(({ link: name }) => name === links[at!]?.name);
    if (joint && joint.dofs.length > 0) count += 1;
    if (joint && /(shoulder|hip)$/.test(joint.name)) return count;
  }
  return 3;
}
