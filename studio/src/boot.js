// The first script of the page: unpacks the rest of it, and begins.

import { Decoder } from '../node_modules/lzma1/lib/decoder.js';
import { InputBuffer, OutputBuffer } from '../node_modules/lzma1/lib/streams.js';
import { decode } from './pack.mjs';

// Packed text as bytes; `packed` and `size`: how many there are before and after.
function unpack(text, packed, size) {
  const output = new OutputBuffer(size);
  new Decoder().decompress(new InputBuffer(decode(text, packed)), output);
  return output.toArray();
}

// What a worker needs before it has anything: the same.
globalThis.solarisUnpack = unpack;

if (globalThis.document) {
  const element = (id) => document.getElementById(id);
  const held = (id) => {
    const { textContent: text, dataset } = element(id);
    return [text, Number(dataset.packed), Number(dataset.size)];
  };
  const [viewer, studio, worker, style] = new TextDecoder().decode(unpack(...held('code'))).split('\0');
  const run = (text) => document.head.append(Object.assign(document.createElement('script'), { textContent: text }));
  globalThis.solarisParts = { viewer, style, worker: `${element('boot').textContent}\n${worker}`, engine: held('engine') };
  run(viewer);
  run(studio);
}
