// Lines that are wrapped go on below where they begin.

import { RangeSetBuilder } from '@codemirror/state';
import { Decoration, ViewPlugin, type DecorationSet, type EditorView, type ViewUpdate } from '@codemirror/view';

// Of the lines' own padding (px), and the most columns that are kept free.
const [PADDING, MOST] = [6, 24];

const marks = new Map<number, Decoration>();
function mark(columns: number): Decoration {
  const style = `text-indent:-${columns}ch;padding-left:calc(${columns}ch + ${PADDING}px)`;
  if (!marks.has(columns)) marks.set(columns, Decoration.line({ attributes: { style } }));
  return marks.get(columns)!;
}

function indents(view: EditorView): DecorationSet {
  const builder = new RangeSetBuilder<Decoration>();
  for (const { from, to } of view.visibleRanges) {
    for (let at = from; at <= to; ) {
      const line = view.state.doc.lineAt(at);
      // Comments go on behind their slashes.
      const columns = Math.min(MOST, /^ *(?:\/\/ *)?/.exec(line.text)![0].length);
      if (columns > 0) builder.add(line.from, line.from, mark(columns));
      at = line.to + 1;
    }
  }
  return builder.finish();
}

export const hangingIndents = ViewPlugin.fromClass(
  class {
    lines: DecorationSet;
    constructor(view: EditorView) {
      this.lines = indents(view);
    }
    update(update: ViewUpdate): void {
      if (update.docChanged || update.viewportChanged) this.lines = indents(update.view);
    }
  },
  { decorations: (plugin) => plugin.lines },
);
