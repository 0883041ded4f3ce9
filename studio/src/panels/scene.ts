// The motion script as text: written, shown as it begins, run, and studied.

import './scene.css';
import type { App } from '../app.ts';
import type { SceneDocument } from '../document.ts';
import type { Engine } from '../engine/client.ts';
import type { PosedFigure } from '../engine/protocol.ts';
import type { Checked, RanScene } from '../engine/scenes.ts';
import { makeEditor, type Completions } from '../scene/editor.ts';
import { EXAMPLES, type Example } from '../scene/examples.ts';
import { faultList } from '../scene/faults.ts';
import { openText, saveText } from '../scene/files.ts';
import { outlineWords } from '../scene/outline.ts';
import { reportRows, type RunReport } from '../scene/report.ts';
import { makeRunner } from '../scene/runner.ts';
import { studyPage } from '../scene/study.ts';
import { fileName } from '../save.ts';
import { button, byId, el, latest } from '../ui/dom.ts';
import { view } from '../view.ts';

export function makeScenePanel(app: App, text: SceneDocument): void {
  const isOpen = (): boolean => app.tools.current() === 'scene';
  const name = (): string => text.outline?.name || 'scene';

  // --- what takes long
  const runner = makeRunner(app);
  const bar = el('progress', { max: 1, 'aria-label': 'How far it has come' });
  const words = el('span', { class: 'words', role: 'status' });
  const stop = button('Stop', () => runner.stop(), { class: 'stop' });
  const work = el('div', { class: 'work', hidden: true }, bar, stop, words);
  const told = el('p', { class: 'remark', role: 'status' });

  async function workOn<T>(what: string, call: string, tell: (soFar: string) => void): Promise<{ engine: Engine; value: T; source: string } | null> {
    if (runner.busy()) return null;
    editor.flush();
    const source = text.text;
    // Where the share of the whole is told, that of each pass is not shown.
    let whole = false;
    bar.removeAttribute('value');
    words.textContent = what;
    told.textContent = '';
    lock(true);
    try {
      const { faults: wrong } = await app.engine.call<Checked>('checkScene', [source]);
      if (wrong.length > 0) {
        told.textContent = 'Not run: mend what is wrong with the text first.';
        editor.goTo(wrong[0].from, wrong[0].from);
        return null;
      }
      const done = await runner.run<T>(call, [source], (share, pass, soFar) => {
        if (soFar !== undefined) tell(soFar);
        if (pass !== null) words.textContent = `${what}, ${pass}`;
        whole ||= share !== null && pass === null;
        if (share !== null && !(whole && pass !== null)) bar.value = share;
      });
      return { ...done, source };
    } catch (error) {
      if ((error as Error).message === 'stopped') told.textContent = 'Stopped.';
      app.fault(error);
      return null;
    } finally {
      lock(false);
    }
  }

  async function run(): Promise<void> {
    const begun = performance.now();
    const done = await workOn<RanScene>('Running', 'runScene', () => {});
    if (!done) return;
    const seconds = (performance.now() - begun) / 1000;
    const { report, remarks } = done.value;
    app.clear();
    ran = done.source;
    app.showMotion(done.value, reportRows(report as unknown as RunReport, remarks, text.outline, seconds), { engine: done.engine });
    if (ran !== text.text) told.textContent = 'Shown is what the text said when it was run.';
  }

  const pages = studyPage(name);
  async function study(): Promise<void> {
    again.hidden = true;
    const done = await workOn<string>('Running by every method', 'studyScene', (page) => {
      pages.show(page, false);
      again.hidden = false;
    });
    if (!done) return;
    pages.show(done.value, true);
    again.hidden = false;
    if (isOpen()) pages.open();
  }

  // --- the text
  const [undo, redo] = [
    button('Undo', () => editor.undo(), { disabled: true, title: 'Ctrl Z' }),
    button('Redo', () => editor.redo(), { disabled: true, title: 'Ctrl Y' }),
  ];
  const editor = makeEditor({
    document: text,
    complete: (source, at) => app.engine.call<Completions>('completeScene', [source, at]),
    run: () => void run(),
    changed(canUndo, canRedo) {
      [undo.disabled, redo.disabled] = [!canUndo, !canRedo];
    },
  });
  const faults = faultList(
    ({ from, to }) => editor.goTo(from, to),
    (fault) => editor.mend(fault),
  );
  const outline = el('div', { 'aria-live': 'polite' });

  const choose = async (example: Example): Promise<void> => {
    examples.open = false;
    const encoder = new TextEncoder();
    for (const [file, content] of Object.entries(example.files ?? {})) await app.engine.call('shelve', [file, encoder.encode(content)]);
    editor.flush();
    text.set(example.text);
  };
  const examples = el(
    'details',
    { class: 'menu examples' },
    el('summary', {}, 'Examples'),
    el('div', { class: 'choices', role: 'group', 'aria-label': 'Examples' }, ...EXAMPLES.map((example) => button(example.title, () => void choose(example).catch(app.fault)))),
  );
  const runs = button('Run', () => void run(), { class: 'main', title: 'Ctrl Enter' });
  const studies = button('Error against run time', () => void study(), { title: 'Runs it by every method, and says which comes how near in which time' });
  const again = button('Show its page', () => pages.open(), { hidden: true });
  const lock = (busy: boolean): void => {
    work.hidden = !busy;
    [runs.disabled, studies.disabled] = [busy, busy];
    if (busy) stop.focus({ preventScroll: true });
  };

  const element = el(
    'div',
    { class: 'scene' },
    el('div', { class: 'tools', role: 'group', 'aria-label': 'What comes of it' }, runs, studies, again),
    work,
    told,
    el(
      'div',
      { class: 'tools', role: 'group', 'aria-label': 'The text' },
      examples,
      button('Open', () => openText('.ron', (opened) => text.set(opened))),
      button('Save', () => {
        editor.flush();
        saveText(fileName(name(), 'ron'), text.text);
      }),
      undo,
      redo,
    ),
    editor.element,
    faults.element,
    outline,
  );
  element.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter' || !(event.ctrlKey || event.metaKey)) return;
    event.preventDefault();
    void run();
  });

  // --- what is written is shown
  let ran = '';
  let links = '';
  const pose = latest(async () => {
    const source = text.text;
    if (!text.outline || !isOpen()) return;
    try {
      const posed = await app.engine.call<PosedFigure>('poseScene', [source]);
      if (source !== text.text || source === ran || !isOpen()) return;
      const data = view.readData(posed.data);
      const now = data.links.map((link) => link.name).join();
      app.show.live(data, undefined, { still: app.show.isLive() && now === links });
      links = now;
      app.motion = null;
      byId('title').textContent = name();
    } catch (error) {
      app.fault(error);
    }
  });
  text.onCheck(() => {
    faults.show(text.faults);
    // What it said before it was broken stays to be read.
    if (text.outline) outline.replaceChildren(outlineWords(text.outline));
    outline.classList.toggle('old', text.outline === null);
    if (text.text !== ran) {
      ran = '';
      void pose();
    }
  });
  app.onMotion(() => {
    // Another panel's motion: what was run is not what is shown.
    if (app.motion?.engine === app.engine) ran = '';
  });
  
  app.tools.add({
    id: 'scene',
    title: 'Scene',
    element,
    shown() {
      document.body.dataset.tool = 'scene';
      text.set(text.text);
      if (text.text !== ran || app.show.isLive()) {
        ran = '';
        void pose();
      }
    },
    left() {
      delete document.body.dataset.tool;
      editor.flush();
    },
  });
}
