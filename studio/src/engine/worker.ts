// The engine's side: loads it, and answers calls.

import * as engine from '../../dist/engine/engine.js';
import type { Begin, Call, Reply } from './protocol.ts';
import { figures } from './figures.ts';
import { files } from './files.ts';
import { motions } from './motions.ts';
import { scenes } from './scenes.ts';
import { steering } from './steering.ts';
import { walks } from './walks.ts';

export interface Context {
  tell: (share: number | null, words: string | null, soFar?: string) => void;
}

let memory: WebAssembly.Memory | null = null;

const calls: Record<string, (context: Context, ...args: never[]) => unknown> = {
  ...figures,
  ...files,
  ...motions,
  ...scenes,
  ...steering,
  ...walks,
  // How many bytes the engine has.
  memory: () => memory?.buffer.byteLength,
};

const say = (reply: Reply, transfer: Transferable[] = []): void => self.postMessage(reply, { transfer });

function answer({ id, name, args }: Call): void {
  const context: Context = { tell: (share, words, soFar) => say({ id, share, words, soFar }) };
  try {
    const call = calls[name];
    if (!call) throw new Error(`the engine has no '${name}'`);
    const value = call(context, ...(args as never[]));
    const buffers = value instanceof Uint8Array || value instanceof Float32Array || value instanceof Float64Array ? [value.buffer] : [];
    say({ id, value }, buffers as ArrayBuffer[]);
  } catch (error) {
    // A trap of WebAssembly leaves its memory as it was in the middle of something.
    const broken = error instanceof WebAssembly.RuntimeError || error instanceof RangeError;
    const said = broken ? engine.lastPanic() : undefined;
    const message = error instanceof Error ? error.message : String(error);
    say({ id, fault: { message: said ?? message, broken } });
  }
}

self.onmessage = ({ data }: MessageEvent<Begin | Call>) => {
  if ('id' in data) answer(data);
  else ({ memory } = engine.initSync({ module: data.module }));
};
