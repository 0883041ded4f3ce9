// A program of WebAssembly as streams of what is alike: instructions, places of local variables, constants, offsets. Each is packed much smaller by
// itself than between the others (a tenth of the whole). Both ways are one grammar: each piece is copied from where it is to where it belongs.

// The streams. The padding of memory accesses and the types of blocks go with the instructions that they follow nearly always.
const OPS = 0;
const LOCALS = 1;
const GLOBALS = 2;
const CALLS = 3;
const BRANCHES = 4;
const LOADS = 5;
const STORES = 6;
const LONG = 7;
const FLOATS = 8;
const HEADS = 9;
const OTHER = 10;
// Constants of 32 bits by how many bytes they are written with, one to five.
const CONSTANTS = 10;
const DATA = 16;
// All that is not code, in its order.
const REST = 17;
const COUNT = 18;

// Sections.
const [CODE_SECTION, DATA_SECTION] = [10, 11];
// `i32.const`, and what stands for it: an instruction of its own for each length.
const CONSTANT = 0x41;
const LENGTHS = 0xd6;

// Bytes that are read or written one after the other.
class Cursor {
  at = 0;
  constructor(bytes) {
    this.bytes = bytes;
  }
  byte() {
    return this.bytes[this.at++];
  }
  write(byte) {
    this.bytes[this.at++] = byte;
  }
}

const copy = (from, to) => {
  const byte = from.byte();
  to.write(byte);
  return byte;
};

function copyMany(from, to, count) {
  to.bytes.set(from.bytes.subarray(from.at, from.at + count), to.at);
  from.at += count;
  to.at += count;
}

// A number of seven bits a byte (LEB128); gives it, where it is not negative.
function number(from, to) {
  let [value, shift, byte] = [0, 1, 128];
  while (byte >= 128) {
    byte = copy(from, to);
    value += (byte & 127) * shift;
    shift *= 128;
  }
  return value;
}

// How many bytes the number at a cursor has.
function length({ bytes, at }) {
  let end = at;
  while (bytes[end] >= 128) end += 1;
  return end - at + 1;
}

// The instructions of one function, to its last `end`.
function instructions(from, to, joins) {
  const [ops, written] = [from[OPS], to[OPS]];
  for (let depth = 1; depth > 0; ) {
    let op = ops.byte();
    if (joins ? op > LENGTHS && op <= LENGTHS + 5 : op === CONSTANT) {
      const bytes = joins ? op - LENGTHS : length(ops);
      written.write(joins ? CONSTANT : LENGTHS + bytes);
      copyMany(from[CONSTANTS + bytes], to[CONSTANTS + bytes], bytes);
      continue;
    }
    written.write(op);
    if (op >= 0x20 && op <= 0x22) number(from[LOCALS], to[LOCALS]);
    else if (op >= 0x28 && op <= 0x3e) {
      copy(ops, written);
      const which = op >= 0x36 ? STORES : LOADS;
      number(from[which], to[which]);
    } else if (op >= 0x45 && op <= 0xc4) continue;
    else if (op === 0x10) number(from[CALLS], to[CALLS]);
    else if (op === 0x0b) depth -= 1;
    else if (op >= 0x02 && op <= 0x04) {
      depth += 1;
      number(ops, written);
    } else if (op === 0x0c || op === 0x0d) number(from[BRANCHES], to[BRANCHES]);
    else if (op === 0x0e) for (let left = number(from[BRANCHES], to[BRANCHES]); left >= 0; left -= 1) number(from[BRANCHES], to[BRANCHES]);
    else if (op >= 0x23 && op <= 0x26) number(from[GLOBALS], to[GLOBALS]);
    else if (op === 0x42) number(from[LONG], to[LONG]);
    else if (op === 0x43) copyMany(from[FLOATS], to[FLOATS], 4);
    else if (op === 0x44) copyMany(from[FLOATS], to[FLOATS], 8);
    else other(op, from, to);
  }
}

// What is rare.
function other(op, from, to) {
  const numbers = (count) => {
    for (let i = 0; i < count; i += 1) number(from[OTHER], to[OTHER]);
  };
  if (op === 0x11) numbers(2);
  else if (op === 0x1c) numbers(number(from[OTHER], to[OTHER]));
  else if (op === 0x3f || op === 0x40 || op === 0xd0 || op === 0xd2) numbers(1);
  else if (op === 0xfc) {
    const which = number(from[OPS], to[OPS]);
    if (which > 17) throw new Error(`an instruction 0xfc ${which} is not known`);
    // Those below turn floats into whole numbers.
    if (which >= 8) numbers([8, 10, 12, 14].includes(which) ? 2 : 1);
  } else if (![0x00, 0x01, 0x05, 0x0f, 0x1a, 0x1b, 0xd1].includes(op)) throw new Error(`an instruction 0x${op.toString(16)} is not known`);
}

function functions(from, to, joins) {
  const whole = joins ? to[REST] : from[REST];
  for (let left = number(from[REST], to[REST]); left > 0; left -= 1) {
    // How long a function is comes of what is in it.
    const begins = whole.at + (joins ? 5 : length(whole));
    whole.at = begins;
    for (let kinds = number(from[HEADS], to[HEADS]); kinds > 0; kinds -= 1) {
      number(from[HEADS], to[HEADS]);
      copy(from[HEADS], to[HEADS]);
    }
    instructions(from, to, joins);
    if (joins) {
      const size = whole.at - begins;
      whole.at = begins - 5;
      for (let rest = size; ; rest >>>= 7) {
        whole.write(rest < 128 ? rest : (rest & 127) | 128);
        if (rest < 128) break;
      }
      whole.bytes.copyWithin(whole.at, begins, begins + size);
      whole.at += size;
    }
  }
}

function program(from, to, joins, size) {
  const whole = joins ? to[REST] : from[REST];
  copyMany(from[REST], to[REST], 8);
  while (whole.at < size) {
    const section = copy(from[REST], to[REST]);
    const length = number(from[REST], to[REST]);
    if (section === CODE_SECTION) functions(from, to, joins);
    else copyMany(from[section === DATA_SECTION ? DATA : REST], to[section === DATA_SECTION ? DATA : REST], length);
  }
}

// The streams of a program.
export function split(bytes) {
  const whole = new Cursor(bytes);
  const streams = Array.from({ length: COUNT }, () => new Cursor(new Uint8Array(bytes.length)));
  program(Array(COUNT).fill(whole), streams, false, bytes.length);
  return streams.map(({ bytes: all, at }) => all.slice(0, at));
}

// A program of `size` bytes of its streams.
export function join(streams, size) {
  // Functions are written a little beyond their place first.
  const whole = new Cursor(new Uint8Array(size + 5));
  program(streams.map((bytes) => new Cursor(bytes)), Array(COUNT).fill(whole), true, size);
  return whole.bytes.subarray(0, size);
}
