// What is measured of a run of a scene.

import { row } from '../app.ts';
import type { Row } from '../engine/protocol.ts';
import type { RanScene } from '../engine/scenes.ts';

export function ranRows({ report, remarks, duration }: RanScene): Row[] {
  const { method, why, energy } = report as unknown as { method: string; why: string; energy: Record<string, number> };
  const found: Row[] = [row('Duration', duration, 's'), { label: 'Method', value: '', unit: '', note: `${method}: ${why}` }];
  for (const [name, value] of Object.entries(energy ?? {})) {
    if (typeof value !== 'number' || !name.endsWith('_j')) continue;
    const plainName = name.slice(0, -2).replaceAll('_', ' ');
    found.push(row(plainName[0].toUpperCase() + plainName.slice(1), value, 'J', 3));
  }
  for (const remark of remarks) found.push({ label: '', value: '', unit: '', note: remark });
  return found;
}
