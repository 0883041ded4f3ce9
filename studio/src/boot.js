// The first script of the page: unpacks the rest of it, and begins. The engine is unpacked in a worker meanwhile, by this same script.

import { unpack } from './pack/lzma.mjs';
import { decode } from './pack/text.mjs';
import { join } from './pack/wasm.mjs';

// Packed text as its pieces of bytes; `packed`: how many bytes it stands for.
const pieces = (text, packed) => unpack(decode(text, packed));

// How long the first picture of the page is waited for (ms).
const LATEST = 200;

if (globalThis.document) {
  const element = (id) => document.getElementById(id);
  // What a script of the page holds: its text, and how many bytes it is packed and whole.
  const held = (id) => {
    const { textContent: text, dataset } = element(id);
    return [text, Number(dataset.packed), Number(dataset.size)];
  };
  const module = new Promise((resolve, reject) => {
    const place = URL.createObjectURL(new Blob([element('boot').textContent], { type: 'text/javascript' }));
    const worker = new Worker(place);
    const done = (act) => {
      act();
      worker.terminate();
      URL.revokeObjectURL(place);
    };
    worker.onmessage = ({ data }) => done(() => resolve(data));
    worker.onerror = ({ message }) => done(() => reject(new Error(message || 'the engine cannot be unpacked')));
    worker.postMessage(held('engine'));
  });
  const begin = () => {
    const [code] = pieces(...held('code'));
    const [viewer, studio, worker, style, panels] = new TextDecoder().decode(code).split('\0');
    const add = (kind, text) => document.head.append(Object.assign(document.createElement(kind), { textContent: text }));
    globalThis.solarisParts = { viewer, style, worker, module };
    add('style', panels);
    add('script', viewer);
    add('script', studio);
  };
  // The page is seen before it is unpacked; one in the background is not drawn, and does not wait for it.
  let begun = false;
  const once = () => {
    if (!begun) begin();
    begun = true;
  };
  requestAnimationFrame(() => setTimeout(once));
  setTimeout(once, LATEST);
} else {
  globalThis.onmessage = ({ data: [text, packed, size] }) => {
    postMessage(new WebAssembly.Module(join(pieces(text, packed), size)));
  };
}
