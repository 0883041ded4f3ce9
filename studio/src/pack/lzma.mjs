// Several pieces of bytes, each packed by LZMA, one after the other.

import { Decoder } from '../../node_modules/lzma1/lib/decoder.js';
import { InputBuffer, OutputBuffer } from '../../node_modules/lzma1/lib/streams.js';

// Before each piece: how long it is packed (bytes), the lowest byte first. How long it is stands in its own beginning.
const HEAD = 4;
const SIZE_AT = 5;

export function unpack(packed) {
  const view = new DataView(packed.buffer, packed.byteOffset, packed.byteLength);
  const pieces = [];
  for (let at = 0; at < packed.length; ) {
    const begins = at + HEAD;
    at = begins + view.getUint32(at, true);
    const output = new OutputBuffer(view.getUint32(begins + SIZE_AT, true));
    new Decoder().decompress(new InputBuffer(packed.subarray(begins, at)), output);
    pieces.push(output.toArray());
  }
  return pieces;
}

// `Encoder`: the library's, which pages need not hold.
export function pack(pieces, Encoder) {
  return Buffer.concat(
    pieces.flatMap((piece) => {
      // The window is as long as the piece, and no longer: whoever unpacks it allocates as much.
      const searchDepth = Math.max(12, Math.ceil(Math.log2(piece.length + 1)));
      const output = new OutputBuffer(piece.length + 1024);
      new Encoder().compress(new InputBuffer(piece), output, { searchDepth, filterStrength: 0xff, modeIndex: 1 });
      const bytes = output.toArray();
      const head = Buffer.alloc(HEAD);
      head.writeUInt32LE(bytes.length);
      return [head, bytes];
    }),
  );
}
