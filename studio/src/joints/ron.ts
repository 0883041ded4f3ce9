// What a scene's text says at a place, with the place: as much of its grammar as the panel needs. The engine says what is wrong with it.

export interface Node {
  from: number;
  to: number;
  // `Move` of `Move(…)`, and a bare word.
  name?: string;
  // Of `name: value` in round brackets.
  fields?: Map<string, Node>;
  // What stands in brackets without names: `[…]`, `(…)`.
  items?: Node[];
  list?: boolean;
  // `{key: value}`.
  entries?: { key: string; value: Node }[];
  number?: number;
  text?: string;
}

const WORD = /[\p{L}_][\p{L}\p{N}_]*/uy;
const NUMBER = /[+-]?(?:inf|[\d._]+(?:[eE][+-]?\d+)?)/y;
const GAP = /(?:\s+|\/\/[^\n]*|\/\*[^]*?\*\/)*/y;

// Null where it cannot be read.
export function parse(text: string): Node | null {
  let at = 0;
  const match = (pattern: RegExp): string => {
    pattern.lastIndex = at;
    const found = pattern.exec(text)?.[0] ?? '';
    at += found.length;
    return found;
  };
  const skip = (): void => void match(GAP);
  const take = (sign: string): boolean => {
    skip();
    if (text[at] !== sign) return false;
    at += 1;
    return true;
  };
  const fail = (): never => {
    throw new SyntaxError(`not read at ${at}`);
  };
  const list = (close: string, one: () => void): void => {
    while (!take(close)) {
      one();
      if (!take(',')) {
        if (!take(close)) fail();
        return;
      }
    }
  };
  const quoted = (): string => {
    const from = at;
    for (at += 1; text[at] !== '"'; at += text[at] === '\\' ? 2 : 1) if (at >= text.length) fail();
    at += 1;
    try {
      return JSON.parse(text.slice(from, at)) as string;
    } catch {
      return text.slice(from + 1, at - 1);
    }
  };
  const round = (node: Node): void => {
    list(')', () => {
      skip();
      const before = at;
      const name = match(WORD);
      if (name && take(':')) {
        (node.fields ??= new Map()).set(name, value());
        return;
      }
      at = before;
      (node.items ??= []).push(value());
    });
    if (!node.fields) node.items ??= [];
  };
  function value(): Node {
    skip();
    const node: Node = { from: at, to: at };
    const sign = text[at];
    if (sign === '"') node.text = quoted();
    else if (sign === '[') {
      at += 1;
      node.list = true;
      const items: Node[] = (node.items = []);
      list(']', () => void items.push(value()));
    } else if (sign === '{') {
      at += 1;
      const entries: { key: string; value: Node }[] = (node.entries = []);
      list('}', () => {
        const key = value();
        if (!take(':')) fail();
        entries.push({ key: key.text ?? text.slice(key.from, key.to), value: value() });
      });
    } else if (sign === '(') {
      at += 1;
      round(node);
    } else {
      node.name = match(WORD);
      if (node.name) {
        const end = at;
        if (take('(')) round(node);
        else at = end;
      } else {
        delete node.name;
        const digits = match(NUMBER);
        if (!digits) fail();
        node.number = Number(digits.replaceAll('_', '').replace('inf', 'Infinity'));
      }
    }
    node.to = at;
    return node;
  }
  try {
    const node = value();
    skip();
    return at === text.length ? node : null;
  } catch {
    return null;
  }
}

export const field = (node: Node | null | undefined, name: string): Node | undefined => node?.fields?.get(name);
export const entry = (node: Node | null | undefined, key: string): Node | undefined => node?.entries?.find((one) => one.key === key)?.value;

// A number, or an angle in degrees (rad); null: something else stands there.
export function scalar(node: Node | undefined): number | null {
  if (!node) return null;
  if (node.name === 'deg' && node.items?.length === 1) return node.items[0].number === undefined ? null : node.items[0].number * DEGREE;
  return node.number ?? null;
}

export const DEGREE = Math.PI / 180;
// As the text has it: never without a point, never more digits than were meant.
export const plain = (value: number, digits = 4): string => {
  const short = String(Number(value.toFixed(digits)) || 0);
  return /[.e]/.test(short) ? short : `${short}.0`;
};
// A position of something that turns is shown and written in degrees.
export const position = (value: number, turns: boolean): string =>
  turns ? `deg(${String(Number((value / DEGREE).toFixed(3)) || 0)})` : plain(value, 5);
export const quote = (name: string): string => JSON.stringify(name);

// Whether a name is meant by a pattern with `*` for any text.
export function isMeant(pattern: string, name: string): boolean {
  const parts = pattern.split('*').map((part) => part.replace(/[\\^$.|?+()[\]{}]/g, '\\$&'));
  return new RegExp(`^${parts.join('.*')}$`).test(name);
}
