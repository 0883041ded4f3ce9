// The text of the scene in an editor: it says what the document says, and the document what is typed.

import { autocompletion, closeBrackets, closeBracketsKeymap, type CompletionContext, type CompletionResult } from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap, isolateHistory, redo, redoDepth, undo, undoDepth } from '@codemirror/commands';
import { indentOnInput } from '@codemirror/language';
import { lintGutter, lintKeymap, setDiagnostics, type Diagnostic } from '@codemirror/lint';
import { Annotation, ChangeSet, EditorState, Prec, Text } from '@codemirror/state';
import { EditorView, drawSelection, highlightActiveLine, keymap, lineNumbers } from '@codemirror/view';
import type { TextFault } from '../engine/protocol.ts';
import type { SceneDocument } from '../document.ts';
import { later } from '../ui/dom.ts';
import { difference } from './difference.ts';
import { ron } from './ron.ts';
import { hangingIndents } from './hanging.ts';

// How long typing rests before it is read (ms).
const REST = 200;

export interface Completions {
  from: number;
  to: number;
  items: { label: string; insert: string; detail: string }[];
}

export interface Editor {
  element: HTMLElement;
  undo(): void;
  redo(): void;
  // Hands over at once what was typed.
  flush(): void;
  // Cursor and view to a place.
  goTo(from: number, to: number): void;
  // Writes at a place what was meant there.
  mend(fault: TextFault): void;
}

export interface EditorOptions {
  document: SceneDocument;
  complete: (text: string, at: number) => Promise<Completions>;
  run: () => void;
  // After every change of what can be undone and redone.
  changed: (canUndo: boolean, canRedo: boolean) => void;
}

// Changes that the document told, and does not need to hear.
const told = Annotation.define<boolean>();

export function makeEditor({ document: text, complete, run, changed }: EditorOptions): Editor {
  // The text that the document knows, and what was typed since.
  let known = Text.of(text.text.split('\n'));
  let typed: ChangeSet | null = null;

  const flush = (): void => {
    if (!typed) return;
    [known, typed] = [view.state.doc, null];
    text.set(known.toString());
  };
  const flushSoon = later(REST, flush);

  const source = async (context: CompletionContext): Promise<CompletionResult | null> => {
    // By itself only where a word has begun.
    if (!context.explicit && !context.matchBefore(/["a-z_*][\w.*]*/i)) return null;
    const { from, to, items } = await complete(context.state.doc.toString(), context.pos).catch(() => ({ from: 0, to: 0, items: [] }));
    if (items.length === 0) return null;
    return { from, to, validFor: /^[\w.*]*$/, options: items.map(({ label, insert, detail }) => ({ label, detail, apply: insert })) };
  };

  const view = new EditorView({
    state: EditorState.create({
      doc: known,
      extensions: [
        Prec.highest(
          keymap.of([
            { key: 'Mod-Enter', run: () => (run(), true) },
            { key: 'Mod-.', run: () => mendHere() },
          ]),
        ),
        keymap.of([...closeBracketsKeymap, ...lintKeymap.filter(({ key }) => key === 'F8'), ...historyKeymap, ...defaultKeymap]),
        ron,
        history(),
        lineNumbers(),
        lintGutter(),
        drawSelection(),
        highlightActiveLine(),
        indentOnInput(),
        closeBrackets(),
        autocompletion({ override: [source], icons: false, maxRenderedOptions: 200 }),
        EditorView.lineWrapping,
        hangingIndents,
        EditorView.contentAttributes.of({ 'aria-label': 'The scene’s text', spellcheck: 'false', autocapitalize: 'off' }),
        EditorView.updateListener.of((update) => {
          for (const one of update.transactions) {
            if (!one.docChanged || one.annotation(told)) continue;
            typed = typed ? typed.compose(one.changes) : one.changes;
            flushSoon();
          }
          if (update.docChanged) changed(undoDepth(update.state) > 0, redoDepth(update.state) > 0);
        }),
        EditorView.domEventHandlers({ blur: flush }),
      ],
    }),
  });
  // Keys of the text are not those of the picture.
  view.dom.addEventListener('keydown', (event) => {
    if (!event.altKey && event.key !== 'Escape') event.stopPropagation();
  });

  const hear = (): void => {
    if (text.text.includes('\r')) {
      text.set(text.text.replace(/\r\n?/g, '\n'));
      return;
    }
    const changes = difference(known.toString(), text.text);
    if (changes.length === 0) return;
    // What was typed and not handed over yet stays, wherever it is now.
    const theirs = ChangeSet.of(changes, known.length);
    known = theirs.apply(known);
    const here = typed ? theirs.map(typed, true) : theirs;
    typed = typed ? typed.map(theirs) : null;
    view.dispatch({ changes: here, annotations: [told.of(true), isolateHistory.of('full')] });
    if (typed) flushSoon();
  };
  text.onText(hear);

  // Whole places of the text as it is now; one at the very end of a line is that of its last letter.
  const place = ({ from, to }: TextFault): { from: number; to: number } => {
    const { length } = view.state.doc;
    const [first, last] = [Math.min(from, length), Math.min(Math.max(from, to), length)];
    if (last > first) return { from: first, to: last };
    const line = view.state.doc.lineAt(first);
    return first < line.to ? { from: first, to: first + 1 } : { from: Math.max(line.from, first - 1), to: first };
  };
  text.onCheck(() => {
    if (typed) return;
    const diagnostics = text.faults.map(
      (fault): Diagnostic => ({
        ...place(fault),
        severity: 'error',
        message: fault.message,
        actions:
          fault.instead === null
            ? []
            : [{ name: `Write ${fault.instead}`, apply: (_, from, to) => write(from, to, fault.instead!) }],
      }),
    );
    view.dispatch(setDiagnostics(view.state, diagnostics));
  });

  const write = (from: number, to: number, insert: string): void => {
    view.dispatch({ changes: { from, to, insert }, selection: { anchor: from + insert.length }, annotations: isolateHistory.of('full'), userEvent: 'input' });
    view.focus();
    flush();
  };
  // Mends what is wrong on the line of the cursor, beginning with what is nearest.
  function mendHere(): boolean {
    if (typed) return false;
    const at = view.state.selection.main.head;
    const line = view.state.doc.lineAt(at);
    const off = ({ from, to }: TextFault): number => Math.max(from - at, at - to, 0);
    const [fault] = text.faults
      .filter(({ instead, from, to }) => instead !== null && from <= line.to && to >= line.from)
      .sort((a, b) => off(a) - off(b));
    if (fault) self.mend(fault);
    return fault !== undefined;
  }

  const self: Editor = {
    element: view.dom,
    undo: () => (undo(view), view.focus()),
    redo: () => (redo(view), view.focus()),
    flush,
    goTo(from, to) {
      const { length } = view.state.doc;
      view.dispatch({ selection: { anchor: Math.min(from, length), head: Math.min(to, length) }, scrollIntoView: true });
      view.focus();
    },
    mend({ from, to, instead }) {
      if (instead !== null && to <= view.state.doc.length) write(from, to, instead);
    },
  };
  return self;
}
