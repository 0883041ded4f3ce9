// What was set up, in the part of the address behind `#`, which no browser sends anywhere. Nothing else is remembered.

import type { SceneDocument } from './document.ts';
import { FIRST } from './document.ts';
import type { App } from './app.ts';
import type { WalkPanel, WalkState } from './panels/walk.ts';

interface State {
  panel?: string;
  scene?: string;
  walk?: WalkState;
}

// The most characters of a state: what it unpacks to may be far more than what is given.
const MOST = 4_000_000;

const through = async (bytes: Uint8Array, stream: CompressionStream | DecompressionStream): Promise<Uint8Array> => {
  const reader = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream().pipeThrough<Uint8Array>(stream).getReader();
  const pieces: Uint8Array<ArrayBuffer>[] = [];
  for (let length = 0; ; ) {
    const { done, value } = await reader.read();
    if (done) return new Uint8Array(await new Blob(pieces).arrayBuffer());
    length += value.length;
    if (length > MOST) throw new Error(`the link holds more than ${MOST / 1e6} MB`);
    pieces.push(value as Uint8Array<ArrayBuffer>);
  }
};

export async function pack(text: string): Promise<string> {
  const bytes = await through(new TextEncoder().encode(text), new CompressionStream('deflate-raw'));
  const binary = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
  return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

export async function unpack(packed: string): Promise<string> {
  const binary = atob(packed.replaceAll('-', '+').replaceAll('_', '/'));
  const bytes = await through(Uint8Array.from(binary, (c) => c.charCodeAt(0)), new DecompressionStream('deflate-raw'));
  return new TextDecoder().decode(bytes);
}

// The address of the studio as it is set up now.
export async function link(app: App, document_: SceneDocument, walk: WalkPanel): Promise<string> {
  const state: State = { panel: app.tools.current(), walk: walk.state() };
  if (document_.text !== FIRST) state.scene = document_.text;
  return `${location.href.replace(/#.*/s, '')}#s=${await pack(JSON.stringify(state))}`;
}

const finite = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value);

// Only what a walk can be asked: numbers and words, from whoever made the link.
function walkOf({ who, asked, touched }: WalkState): WalkState {
  if (!finite(who.height) || !finite(who.mass)) throw new Error('the link says no height and mass of who walks');
  const plain = Object.entries(asked).filter(([, value]) => finite(value) || typeof value === 'string');
  return { who: { height: who.height, mass: who.mass }, asked: Object.fromEntries(plain), touched: touched.filter(([name, value]) => typeof name === 'string' && finite(value)) };
}

// Sets up what the address says; gives the panel that was open, if it says anything.
export async function restore(app: App, document_: SceneDocument, walk: WalkPanel): Promise<string | null> {
  const packed = /^#s=([\w-]+)$/.exec(location.hash)?.[1];
  if (!packed) return null;
  try {
    const state = JSON.parse(await unpack(packed)) as State;
    if (state.walk) walk.restore(walkOf(state.walk));
    if (typeof state.scene === 'string') document_.set(state.scene);
    return typeof state.panel === 'string' ? state.panel : null;
  } catch (error) {
    app.fault(new Error(`the link cannot be opened: ${(error as Error).message}`));
    return null;
  }
}
