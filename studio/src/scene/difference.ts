// What has changed between two texts, in few small places: whoever looks at one of them keeps cursor and scroll.

export interface Change {
  from: number;
  to: number;
  insert: string;
}

// One change of what is between the same beginning and the same end; nothing where they are equal.
function between(old: string, next: string, at: number): Change[] {
  if (old === next) return [];
  const most = Math.min(old.length, next.length);
  let [head, tail] = [0, 0];
  while (head < most && old[head] === next[head]) head += 1;
  while (tail < most - head && old[old.length - 1 - tail] === next[next.length - 1 - tail]) tail += 1;
  return [{ from: at + head, to: at + old.length - tail, insert: next.slice(head, next.length - tail) }];
}

export function difference(old: string, next: string): Change[] {
  const [all] = between(old, next, 0);
  if (!all) return [];
  // Values at several places of the text are several changes, as long as no line came or went.
  const [before, after] = [old.slice(all.from, all.to).split('\n'), all.insert.split('\n')];
  if (before.length !== after.length) return [all];
  let at = all.from;
  return before.flatMap((line, i) => {
    const changes = between(line, after[i], at);
    at += line.length + 1;
    return changes;
  });
}
