// Files: what was dropped, what it is, and what comes of it. Nothing leaves this machine.

import './files.css';
import type { App } from '../app.ts';
import { row } from '../app.ts';
import type { SceneDocument } from '../document.ts';
import type { Pose } from '../engine/figures.ts';
import type { OpenedFiles } from '../engine/files.ts';
import type { Dof, PosedFigure, Row, ShownMotion } from '../engine/protocol.ts';
import { KINDS, makeOverlay, type Kind } from '../overlay.ts';
import { button, byId, el, later, latest, number } from '../ui/dom.ts';
import { fold } from '../ui/tabs.ts';
import { view, type Data } from '../view.ts';

// The usual filter of positions of people (Hz).
const CUTOFF = 6;
const DEGREE = Math.PI / 180;
// So many findings are shown at once.
const MANY = 3;
// The most bytes of a file.
const MOST = 2 ** 30;
const DRAWN: Record<Kind, string> = { axes: 'axes of joints', masses: 'centres of mass', inertia: 'inertia', soles: 'soles', markers: 'markers' };

// A file, by its way from whatever was dropped.
export interface Given {
  name: string;
  bytes: Uint8Array;
}
type Moments = ShownMotion & { external: string; findings: string[] };

export interface FilesPanel {
  // Opens what somebody chose or dropped.
  open(given: Given[]): Promise<void>;
  // Opens what the page came with: `solaris studio FILE -o …` puts files into it.
  begin(): Promise<void>;
  // Shows what a page of this program holds: JSON.
  page(json: string, title: string): void;
}

export function makeFilesPanel(app: App, document_: SceneDocument): FilesPanel {
  // What belongs together: all that was given since the last figure of its own.
  let together: Given[] = [];
  let opened: OpenedFiles | null = null;
  let posed: PosedFigure | null = null;
  let ours = false;

  const said = el('div', { class: 'said', 'aria-live': 'polite' });
  const [about, forces] = [el('div', { class: 'about' }), el('div', { class: 'moments', hidden: true })];
  const overlay = makeOverlay(app, () => ours);
  const kinds = KINDS.map((kind) => {
    const box = el('input', { type: 'checkbox', autocomplete: 'off' });
    box.addEventListener('change', () => overlay.show(kind, box.checked));
    return el('label', { class: 'check' }, box, DRAWN[kind]);
  });

  // --- joint moments
  const ground = el('select', { 'aria-label': 'Forces of the ground', autocomplete: 'off' });
  const cutoff = el('input', { type: 'number', min: 0.5, max: 100, step: 'any', value: CUTOFF, placeholder: 'none', autocomplete: 'off', 'aria-label': 'Filter (Hz)' });
  const found = el('div', { class: 'found', 'aria-live': 'polite' });
  forces.append(
    el('h2', {}, 'Joint moments'),
    el('label', { class: 'choice' }, el('span', {}, 'Ground'), ground),
    el('label', { class: 'choice' }, el('span', {}, 'Filter'), el('span', { class: 'typed' }, cutoff, el('span', { class: 'unit' }, 'Hz'))),
    found,
  );
  const moments = latest(async (again: boolean) => {
    try {
      const asked = cutoff.value === '' ? null : Number(cutoff.value);
      const got = await app.engine.call<Moments>('openedMoments', [ground.value, asked]);
      found.replaceChildren(el('p', { class: 'remark' }, got.external), ...lines(got.findings));
      show(got, momentRows(view.readData(got.data), got, posed?.mass ?? 0), again);
    } catch (error) {
      found.replaceChildren(el('p', { class: 'fault', role: 'alert' }, (error as Error).message));
      if (!again) await recorded();
    }
  });
  const anew = later(300, () => void moments(true));
  ground.addEventListener('change', () => void moments(true));
  cutoff.addEventListener('input', anew);

  async function recorded(): Promise<void> {
    const shown = await app.engine.call<ShownMotion>('openedMotion');
    show(shown, opened!.findings.map(remark), false);
  }

  // Our own motions are of our own figure: so are their masses and markers.
  function show(motion: ShownMotion, rows: Row[], again: boolean): void {
    ours = true;
    mine = true;
    app.clear();
    app.showMotion(motion, rows, { again });
    mine = false;
  }
  let mine = false;
  app.show.onShow(() => {
    if (!mine) ours = false;
  });

  // --- what was dropped
  function roles({ files, faults, findings }: OpenedFiles): Node[] {
    const list = files.map(({ name, what, used }) =>
      el('li', { class: used ? undefined : 'unused' }, el('strong', {}, name), el('span', {}, what), !used && el('em', {}, 'not used')));
    return [
      el('h2', {}, 'What was dropped'),
      el('ul', { class: 'roles' }, ...list),
      ...faults.map((fault) => el('p', { class: 'fault', role: 'alert' }, fault)),
      ...lines(findings),
    ];
  }

  // `held`: what holds the pose, of each degree of freedom (N m, N).
  function summary(figure: PosedFigure, held: number[]): Node[] {
    const limit = ({ lower, upper, turns }: Dof): string => {
      if (lower === null || upper === null) return '';
      const [scale, unit] = turns ? [1 / DEGREE, '°'] : [1, ' m'];
      return ` ${number(lower * scale, 1)} to ${number(upper * scale, 1)}${unit}`;
    };
    const holds = ({ index, turns }: Dof): string => `, held by ${number(held[index], 2)} ${turns ? 'N m' : 'N'}`;
    const file = opened?.files.find(({ what }) => what.startsWith("the figure '"));
    const dofs = figure.joints.reduce((sum, joint) => sum + joint.dofs.length, 0);
    const joints = figure.joints.filter((joint) => joint.dofs.length > 0);
    return [
      el('h2', {}, figure.name),
      el('p', { class: 'sum' }, `${number(figure.mass, 3)} kg, ${figure.links.length} links, ${joints.length} joints that move, ${dofs} degrees of freedom`),
      ...(file ? [button('Pose and drive it', () => drive(file.name, figure), { title: 'As a scene, under Joints' })] : []),
      fold('Joints', joints.length <= 12, el('ul', { class: 'joints' }, ...joints.map((joint) =>
        el('li', {}, el('strong', {}, joint.name), el('span', {}, `moves ${joint.link}`), ...joint.dofs.map((dof) =>
          el('span', { class: 'dof' }, `${dof.name}${limit(dof)}${holds(dof)}`)))))),
      fold('Links', false, el('ul', { class: 'joints' }, ...figure.links.map(({ name, mass }) => el('li', {}, el('strong', {}, name), el('span', {}, `${number(mass, 3)} kg`))))),
      ...lines(figure.findings),
    ];
  }

  // A scene of the figure, which stands still at first.
  function drive(file: string, { name }: PosedFigure): void {
    document_.set(`Scene(
    version: 1,
    figures: {${JSON.stringify(name)}: File(${JSON.stringify(file)})},
    duration: 3.0,
    drives: {
        "*": Frozen,
    },
)
`);
    app.tools.open('joints');
  }

  async function open(given: Given[]): Promise<void> {
    app.tools.open('files');
    if (given.length === 0) return;
    const large = given.find(({ bytes }) => bytes.length > MOST);
    if (large) return app.fault(new Error(`${large.name} is larger than 1 GiB, the most that is read`));
    said.replaceChildren(el('p', { class: 'remark' }, `Opening ${given.length === 1 ? given[0].name : `${given.length} files`} …`));
    try {
      let next = await app.engine.call<OpenedFiles>('openFiles', [given]);
      const alone = next.files.some(({ what }) => /^(the figure '|a body and its motion)/.test(what)) || next.scene !== null || next.page !== null;
      // What has no figure of its own goes with what was there: the new before the old, of which there may be one only.
      const names = new Set(given.map(({ name }) => name));
      const old = alone ? [] : together.filter(({ name }) => !names.has(name));
      together = [...given, ...old];
      if (old.length > 0 && !next.profile) {
        next = await app.engine.call<OpenedFiles>('openFiles', [together]);
        const unused = new Set(next.files.filter(({ used, name }) => !used && !names.has(name)).map(({ name }) => name));
        together = together.filter(({ name }) => !unused.has(name));
        next.files = next.files.filter(({ name }) => !unused.has(name));
      }
      await opens(next);
    } catch (error) {
      said.replaceChildren(el('p', { class: 'fault', role: 'alert' }, (error as Error).message));
    }
  }

  async function opens(next: OpenedFiles): Promise<void> {
    opened = next;
    said.replaceChildren(...roles(next));
    forces.hidden = true;
    about.replaceChildren();
    if (next.page !== null) {
      page(next.page, JSON.parse(next.page).figure ?? 'A page');
      return;
    }
    if (next.scene !== null) {
      document_.set(next.scene);
      app.tools.open('scene');
      return;
    }
    if (next.profile !== null) said.append(el('p', { class: 'remark' }, 'A curve of one degree of freedom: a scene can name it by its file.'));
    if (next.figure === null) return;
    posed = await app.engine.call<PosedFigure>('openedPosed');
    const { moments: held } = await app.engine.call<Pose>('poseTo', [posed.q]);
    about.replaceChildren(...(next.isCloud ? [] : summary(posed, held)));
    if (next.motion === null) {
      mine = true;
      ours = true;
      app.motion = null;
      byId('title').textContent = posed.name;
      app.clear();
      app.show.live(view.readData(posed.data));
      mine = false;
      return;
    }
    if (next.isCloud) return recorded();
    const choices: [string, string][] = [['none', 'no forces from outside']];
    if (next.soles) choices.unshift(['predicted', 'predicted, by the soles']);
    if (next.measured) choices.unshift(['measured', 'measured']);
    ground.replaceChildren(...choices.map(([value, text]) => el('option', { value }, text)));
    ground.value = choices[0][0];
    found.replaceChildren();
    forces.hidden = false;
    await moments(false);
  }

  function page(json: string, title: string): void {
    const data = view.readData(json);
    app.motion = null;
    byId('title').textContent = title;
    document.title = `${title} – Solaris Studio`;
    app.clear();
    app.show.motion(data);
  }

  // --- ways in
  const input = byId<HTMLInputElement>('files');
  const choose = (): void => input.click();
  byId('open').addEventListener('click', choose);
  input.addEventListener('change', () => {
    const chosen = Promise.all([...(input.files ?? [])].map((file) => read(file, file.name)));
    // The same file can be chosen again.
    input.value = '';
    void chosen.then(open).catch(app.fault);
  });
  drops((given) => void given.then(open, app.fault));

  app.tools.add({
    id: 'files',
    title: 'Files',
    element: el(
      'div',
      { class: 'files' },
      el('p', { class: 'remark' }, 'Drop models, motions, forces, markers, scenes or pages anywhere, several together. They never leave this machine.'),
      button('Choose files…', choose),
      said,
      forces,
      fold('Drawn on the figure', true, el('div', { class: 'checks' }, ...kinds)),
      about,
    ),
  });
  return {
    open,
    page,
    async begin() {
      const held = document.getElementById('given');
      if (!held) return;
      const given = JSON.parse(held.textContent ?? '[]') as { name: string; base64: string }[];
      await open(given.map(({ name, base64 }) => ({ name, bytes: Uint8Array.from(atob(base64), (byte) => byte.charCodeAt(0)) })));
    },
  };
}

// Many are folded away, so that what is below is seen.
const lines = (findings: string[]): Node[] => {
  if (findings.length === 0) return [];
  const list = el('ul', { class: 'findings' }, ...findings.map((finding) => el('li', {}, finding)));
  return [findings.length > MANY ? fold(`${findings.length} findings`, false, list) : list];
};
const remark = (note: string): Row => ({ label: '', value: '', unit: '', note });

// The greatest moment of each joint, and when.
function momentRows(data: Data, { external, findings }: Moments, mass: number): Row[] {
  const rows: Row[] = [{ label: 'Forces from outside', value: '', unit: '', note: external }];
  for (const { label, effort } of data.joints) {
    for (const { side, values } of effort?.lines ?? []) {
      let most = 0;
      values.forEach((value, i) => (most = Math.abs(value) > Math.abs(values[most]) ? i : most));
      const perMass = effort!.unit.endsWith('/kg');
      const unit = effort!.unit.replace('/kg', '');
      const where = side === 'middle' ? label : `${label}, ${side}`;
      rows.push(row(`${where}: greatest`, values[most] * (perMass ? mass : 1), unit, 1, `at ${number(data.time[most], 3)} s`));
    }
  }
  return [...rows, ...findings.map(remark)];
}

async function read(file: File, name: string): Promise<Given> {
  if (file.size > MOST) throw new Error(`${name} is larger than 1 GiB, the most that is read`);
  return { name, bytes: new Uint8Array(await file.arrayBuffer()) };
}

// Files dropped anywhere on the page, with those inside of folders.
function drops(act: (given: Promise<Given[]>) => void): void {
  const shade = byId('drop');
  const files = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;
  document.addEventListener('dragover', (event) => {
    if (!files(event)) return;
    event.preventDefault();
    shade.hidden = false;
  });
  document.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) shade.hidden = true;
  });
  document.addEventListener('drop', (event) => {
    shade.hidden = true;
    if (!files(event)) return;
    event.preventDefault();
    // The list is there only while the event is.
    const items = [...event.dataTransfer!.items].filter(({ kind }) => kind === 'file');
    const inside = items.map((item) => {
      const entry = item.webkitGetAsEntry();
      const file = item.getAsFile();
      return entry?.isDirectory ? walk(entry) : Promise.all(file ? [read(file, file.name)] : []);
    });
    act(Promise.all(inside).then((found) => found.flat()));
  });
}

async function walk(entry: FileSystemEntry): Promise<Given[]> {
  const name = entry.fullPath.replace(/^\//, '');
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
    return [await read(file, name)];
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const found: Given[] = [];
  // A folder is told a hundred entries at a time.
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0) return found;
    for (const inner of some.filter((one) => !one.name.startsWith('.'))) found.push(...(await walk(inner)));
  }
}
