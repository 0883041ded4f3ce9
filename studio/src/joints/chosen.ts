// The chosen joint: each degree of freedom with its place, its moment and its drives.

import type { Edit, SceneDocument } from '../document.ts';
import type { Engine } from '../engine/client.ts';
import type { Dof, JointOutline } from '../engine/protocol.ts';
import { el, number } from '../ui/dom.ts';
import { slider, type Slider } from '../ui/slider.ts';
import { makeDrives, unitOf, type Drives } from './drives.ts';
import { choose } from './inputs.ts';
import { DEGREE, position, quote } from './ron.ts';
import { drivesOf, isWhole } from './said.ts';
import type { JointState } from './state.ts';

// Of angles without limits, and of slides (m).
const [FAR, WIDE] = [Math.PI, 1];

interface DofView {
  dof: Dof;
  slider: Slider | null;
  moment: HTMLElement;
  drives: Drives;
  hasServo: boolean;
}

export interface Around {
  engine: Engine;
  isLive(): boolean;
  // Another place of a degree of freedom, or another target while it plays live.
  moves(dof: Dof, to: number): Promise<void>;
  write(edits: Edit[]): Promise<void>;
  openText(): void;
}

export interface Chosen {
  element: HTMLElement;
  // Another joint is chosen.
  show(): void;
  // The text says something else of it.
  sync(): void;
  // Places and moments; `running`: of something that moves by itself.
  numbers(running: boolean): void;
  // Whether it can be moved.
  enable(): void;
  forget(): void;
  // Says a fault beside the degree of freedom that it names.
  fault(message: string): void;
  // Says the faults of the text that belong to its drives; gives these.
  faults(): Set<unknown>;
}

export function makeChosen(at: JointState, text: SceneDocument, { engine, isLive, moves, write, openText }: Around): Chosen {
  const details = el('div', { class: 'joint', role: 'region', 'aria-label': 'The chosen joint' });
  let views: DofView[] = [];

  function show(): void {
    const joint = at.joints.find(({ name }) => name === at.chosen);
    views = [];
    if (!joint) {
      details.replaceChildren(el('p', { class: 'remark' }, 'Choose a joint in the list, or click a link in the picture.'));
      return;
    }
    const whole = isWhole(joint.dofs);
    views = joint.dofs.map((dof) => makeView(joint, dof));
    details.replaceChildren(
      el('h2', {}, joint.name),
      el('p', { class: 'remark' }, `carries ${joint.link.replaceAll('_', ' ')}`),
      ...(joint.dofs.length > 1 ? [wholeJoint(joint, whole)] : []),
      ...views.map(({ dof, slider: made, moment, drives }) =>
        el('section', { class: 'dof', 'aria-label': dof.name }, made?.element ?? el('h2', {}, dof.name), moment, ...(whole ? [] : [drives.element])),
      ),
    );
    sync();
  }

  // One mode for all degrees of freedom of a joint; a ball or free joint has no other.
  function wholeJoint(joint: JointOutline, whole: boolean): HTMLElement {
    const said = drivesOf(text.text, at.tree, joint, null);
    const modes: [string, string][] = [['', 'each by itself'], ['Frozen', 'Frozen'], ['Free', 'Free'], ...(whole ? [] : [['Servo', 'Spring, servo'] as [string, string]]), ['others', 'as the others']];
    const mode = choose('Whole joint', modes, whole && said.from === null ? said.text : '', (kind) => {
      const names = whole ? [joint.name] : joint.dofs.map(({ name }) => name);
      void write([
        // What the joint's own name says is said by its parts from now on.
        ...(whole ? [] : [{ path: ['drives', quote(joint.name)], value: null }]),
        ...names.map((name, i) => {
          const servo = (): string => {
            const dof = joint.dofs[i];
            return `Servo(to: ${position(atOf(dof), dof.turns)}, stiffness: ${dof.turns ? '100.0' : '2000.0'}, damping: ${dof.turns ? '10.0' : '200.0'})`;
          };
          return { path: ['drives', quote(name)], value: kind === 'Servo' ? servo() : kind === 'Frozen' || kind === 'Free' ? kind : null };
        }),
      ]);
    });
    return mode.element;
  }

  // Where it is in the pose of the panel, or as the text begins.
  const atOf = (dof: Dof): number => (dof.coordinate === null ? 0 : ((at.ahead ? at.q : text.outline?.q)?.[dof.coordinate] ?? 0));

  function makeView(joint: JointOutline, dof: Dof): DofView {
    const scale = dof.turns ? DEGREE : 1;
    const far = dof.turns ? FAR : WIDE;
    const short = dof.name.startsWith(`${joint.name}.`) ? dof.name.slice(joint.name.length + 1) : dof.name;
    const made =
      dof.coordinate === null
        ? null
        : slider({
            label: short === dof.name ? dof.name : `${joint.name} ${short}`,
            unit: unitOf('position', dof.turns),
            low: Math.round((dof.lower ?? -far) / scale),
            high: Math.round((dof.upper ?? far) / scale),
            step: dof.turns ? 1 : 0.01,
            value: (at.q[dof.coordinate] ?? 0) / scale,
            change(value) {
              const own = value * scale;
              const below = dof.lower !== null && own < dof.lower - 1e-9;
              if (below || (dof.upper !== null && own > dof.upper + 1e-9)) {
                made!.fault(`${dof.name} goes from ${number((dof.lower ?? 0) / scale, 1)} to ${number((dof.upper ?? 0) / scale, 1)} ${unitOf('position', dof.turns)}`);
                return;
              }
              made!.fault(null);
              moves(dof, own).catch((error: Error) => made!.fault(error.message));
            },
          });
    const drives = makeDrives(
      {
        engine,
        names: () => at.joints.flatMap(({ dofs }) => dofs.filter(({ coordinate }) => coordinate !== null).map(({ name }) => name)),
        turns: (name) => at.joints.flatMap(({ dofs }) => dofs).find((one) => one.name === name)?.turns ?? true,
        duration: () => text.outline?.duration ?? 1,
        at: atOf,
        write: (name, value) => write([{ path: ['drives', quote(name)], value }]),
        openText,
      },
      dof,
    );
    return { dof, slider: made, moment: el('p', { class: 'moment' }), drives, hasServo: false };
  }

  function enable({ slider: made, hasServo }: DofView): void {
    if (!made) return;
    const can = !isLive() || hasServo;
    made.element.querySelectorAll('input').forEach((input) => (input.disabled = !can));
    made.element.classList.toggle('target', isLive() && hasServo);
    made.element.title = isLive() ? (hasServo ? 'The target of the servo' : 'Where it is') : 'Where it begins';
  }

  function sync(): void {
    const joint = at.joints.find(({ name }) => name === at.chosen);
    if (!joint) return;
    for (const one of views) {
      const said = drivesOf(text.text, at.tree, joint, one.dof);
      one.drives.set(said.text, said.from);
      one.drives.outcomes(at.outcomes.filter(({ dof }) => dof === one.dof.name));
      one.hasServo = said.text.includes('Servo(');
      enable(one);
    }
    numbers(isLive());
  }

  // Positions and moments of the chosen joint.
  function numbers(running: boolean): void {
    for (const { dof, slider: made, moment, hasServo } of views) {
      if (made && !(running && hasServo)) made.value = (at.q[dof.coordinate!] ?? 0) / (dof.turns ? DEGREE : 1);
      const unit = unitOf('force', dof.turns);
      const where = running && dof.coordinate !== null ? `at ${number(at.q[dof.coordinate] / (dof.turns ? DEGREE : 1), 1)} ${unitOf('position', dof.turns)}, ` : '';
      const value = at.moments[dof.index];
      moment.textContent = value === undefined || at.shows === 'motion' ? '' : `${where}${running ? 'acts with' : 'held by'} ${number(value, 2)} ${unit}`;
    }
  }

  function faults(): Set<unknown> {
    const own = new Set<unknown>();
    for (const { dof, drives } of views) {
      const joint = at.joints.find(({ dofs }) => dofs.includes(dof))!;
      const { span } = drivesOf(text.text, at.tree, joint, dof);
      const here = text.faults.filter(({ from, to }) => span && from >= span[0] && to <= span[1]);
      drives.fault(here.length > 0 ? here.map(({ message }) => message).join('\n') : null);
      here.forEach((fault) => own.add(fault));
    }
    return own;
  }

  return {
    element: details,
    show,
    sync,
    numbers,
    enable: () => views.forEach(enable),
    forget: () => views.forEach(({ drives }) => drives.outcomes([])),
    fault: (message) => views.find(({ dof }) => message.includes(`'${dof.name}'`))?.drives.fault(message),
    faults,
  };
}
