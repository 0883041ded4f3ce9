// How a scene's text is told apart while it is written: colours, brackets, indentation. What it means is the engine's.

import { HighlightStyle, StreamLanguage, bracketMatching, indentUnit, syntaxHighlighting, type StreamParser } from '@codemirror/language';
import type { Extension } from '@codemirror/state';
import { tags } from '@lezer/highlight';

interface State {
  // How deep comments stand in each other.
  comments: number;
  // What ends the string that goes over lines; empty: there is none.
  ends: string;
  // The indentation (columns) of what stands in each open bracket.
  inside: number[];
}

const WIDTH = 4;
const [OPENING, CLOSING] = ['([{', ')]}'];

// A string that goes on after this line has its state kept.
function string(stream: Parameters<StreamParser<State>['token']>[0], state: State): string {
  const raw = state.ends !== '"';
  while (!stream.eol()) {
    if (stream.match(state.ends)) {
      state.ends = '';
      // A key of a map.
      return stream.match(/\s*:/, false) ? 'propertyName' : 'string';
    }
    if (stream.next() === '\\' && !raw) stream.next();
  }
  return 'string';
}

function comment(stream: Parameters<StreamParser<State>['token']>[0], state: State): string {
  while (state.comments > 0 && !stream.eol()) {
    if (stream.match('*/')) state.comments -= 1;
    else if (stream.match('/*')) state.comments += 1;
    else stream.next();
  }
  return 'blockComment';
}

const parser: StreamParser<State> = {
  name: 'ron',
  startState: () => ({ comments: 0, ends: '', inside: [] }),
  copyState: (state) => ({ ...state, inside: [...state.inside] }),
  token(stream, state) {
    if (state.comments > 0) return comment(stream, state);
    if (state.ends !== '') return string(stream, state);
    if (stream.eatSpace()) return null;
    if (stream.match('//')) {
      stream.skipToEnd();
      return 'lineComment';
    }
    if (stream.match('/*')) {
      state.comments = 1;
      return comment(stream, state);
    }
    const quote = stream.match(/^(?:r(#*))?"/) as RegExpMatchArray | null;
    if (quote) {
      state.ends = `"${quote[1] ?? ''}`;
      return string(stream, state);
    }
    if (stream.match(/^[+-]?(?:0x[\da-f_]+|(?:\d[\d_]*\.?[\d_]*|\.\d+)(?:e[+-]?\d+)?)/i)) return 'number';
    if (stream.match(/^[a-z_]\w*/i)) {
      if (stream.match(/^\s*:/, false)) return 'propertyName';
      return /^[A-Z]/.test(stream.current()) ? 'typeName' : 'keyword';
    }
    const letter = stream.next()!;
    if (OPENING.includes(letter)) state.inside.push(stream.indentation() + WIDTH);
    else if (CLOSING.includes(letter)) state.inside.pop();
    else return 'punctuation';
    return 'bracket';
  },
  indent(state, after) {
    if (state.comments > 0 || state.ends !== '') return null;
    const depth = state.inside.at(-1) ?? 0;
    return Math.max(0, CLOSING.includes(after[0] ?? ' ') ? depth - WIDTH : depth);
  },
  languageData: {
    commentTokens: { line: '//', block: { open: '/*', close: '*/' } },
    closeBrackets: { brackets: ['(', '[', '{', '"'] },
    indentOnInput: /^\s*[)\]}]$/,
  },
};

const colours = HighlightStyle.define([
  { tag: [tags.lineComment, tags.blockComment], class: 'ron-comment' },
  { tag: tags.string, class: 'ron-string' },
  { tag: tags.number, class: 'ron-number' },
  { tag: tags.propertyName, class: 'ron-field' },
  { tag: [tags.typeName, tags.keyword], class: 'ron-word' },
  { tag: [tags.punctuation, tags.bracket], class: 'ron-mark' },
]);

export const ron: Extension = [StreamLanguage.define(parser), syntaxHighlighting(colours), bracketMatching(), indentUnit.of(' '.repeat(WIDTH))];
