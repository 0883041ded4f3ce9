// The scene's text, which all panels share: what is clicked is written into it, what is written is shown.

import type { App } from './app.ts';
import type { SceneOutline, TextFault } from './engine/protocol.ts';
import type { Checked } from './engine/scenes.ts';
import { latest } from './ui/dom.ts';

export interface Edit {
  // Fields and keys of maps; a key stands in quotes: ['drives', '"left_elbow.rx"'].
  path: string[];
  // RON; null takes the entry away.
  value: string | null;
}

export interface SceneDocument {
  text: string;
  // Of the text as it was checked last; null where it has faults.
  outline: SceneOutline | null;
  faults: TextFault[];
  // Another text; whoever shows it listens.
  set(text: string): void;
  // Values written at their places, all else left as it stands.
  edit(edits: Edit[]): Promise<void>;
  // Called at once when the text changes, and when it has been checked.
  onText(listener: () => void): void;
  onCheck(listener: () => void): void;
}

// Somebody who stands still: the first text.
export const FIRST = `Scene(
    version: 1,
    figures: {"ann": Human(height: 1.75, mass: 73.0)},
    duration: 3.0,
    drives: {
        "*": Frozen,
    },
)
`;

export function makeDocument(app: App): SceneDocument {
  const [onText, onCheck]: (() => void)[][] = [[], []];
  const check = latest(async () => {
    const { text } = self;
    try {
      const { outline, faults } = await app.engine.call<Checked>('checkScene', [text]);
      if (text !== self.text) return;
      Object.assign(self, { outline, faults });
      onCheck.forEach((listener) => listener());
    } catch (error) {
      app.fault(error);
    }
  });
  const self: SceneDocument = {
    text: FIRST,
    outline: null,
    faults: [],
    set(text) {
      if (text === self.text && self.outline) return;
      self.text = text;
      onText.forEach((listener) => listener());
      void check();
    },
    async edit(edits) {
      try {
        let text: string;
        let next: string;
        // Of what was typed meanwhile nothing is lost.
        do {
          text = self.text;
          next = await app.engine.call<string>('editScene', [text, edits]);
        } while (text !== self.text);
        self.set(next);
      } catch (error) {
        app.fault(error);
      }
    },
    onText: (listener) => onText.push(listener),
    onCheck: (listener) => onCheck.push(listener),
  };
  return self;
}
