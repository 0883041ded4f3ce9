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

// How a byte is foretold: by how many bits of the byte before it, and by how many bits of its own place for bytes and for matches. The second is
// best of most pieces of a program, the last of numbers of four bytes and eight; which one it was stands in the packed piece.
const SETTINGS = [
  [3, 0, 2],
  [1, 0, 0],
  [0, 2, 2],
];

// `Encoder`: the library's, which pages need not hold. It packs with the first of the settings, unless it is told.
export function pack(pieces, Encoder) {
  class Told extends Encoder {
    configure(mode) {
      super.configure(mode);
      [this._numLiteralContextBits, this._numLiteralPosStateBits, this._posStateBits] = mode.setting;
      this._posStateMask = (1 << this._posStateBits) - 1;
    }
  }
  return Buffer.concat(
    pieces.flatMap((piece) => {
      // The window is as long as the piece, and no longer: whoever unpacks it allocates as much.
      const searchDepth = Math.max(12, Math.ceil(Math.log2(piece.length + 1)));
      const tried = SETTINGS.map((setting) => {
        const output = new OutputBuffer(piece.length + 1024);
        new Told().compress(new InputBuffer(piece), output, { searchDepth, filterStrength: 0xff, modeIndex: 1, setting });
        return output.toArray();
      });
      const bytes = tried.reduce((best, other) => (other.length < best.length ? other : best));
      const head = Buffer.alloc(HEAD);
      head.writeUInt32LE(bytes.length);
      return [head, bytes];
    }),
  );
}
