// Bytes as text that may stand in a page: seven bits a character, eight bytes for seven. A page's parser changes or takes some characters for its
// own; such seven bits, and the seven after them, make one character of two bytes in UTF-8, which is as long. After the idea of Base-122 (K.
// Albertson, 2016).

// NUL, line ends, vertical tabs, form feeds, the end of old text files, escapes, `&`, `<`, the backslash, delete: at most fourteen.
const FORBIDDEN = [0, 10, 11, 12, 13, 26, 27, 38, 60, 92, 127];
// Where the characters of two bytes begin: beyond those that control something.
const FIRST = 0x100;

export function encode(bytes) {
  const units = [];
  let [held, count] = [0, 0];
  for (const byte of bytes) {
    held = (held << 8) | byte;
    count += 8;
    while (count >= 7) {
      count -= 7;
      units.push((held >> count) & 127);
    }
    held &= (1 << count) - 1;
  }
  if (count > 0) units.push((held << (7 - count)) & 127);
  let text = '';
  for (let i = 0; i < units.length; i += 1) {
    const place = FORBIDDEN.indexOf(units[i]);
    if (place < 0) {
      text += String.fromCharCode(units[i]);
    } else {
      i += 1;
      text += String.fromCharCode(FIRST + 128 * place + (units[i] ?? 0));
    }
  }
  return text;
}

// `length`: how many bytes there were.
export function decode(text, length) {
  const bytes = new Uint8Array(length);
  let [held, count, at] = [0, 0, 0];
  const take = (unit) => {
    held = ((held << 7) | unit) & 0x7fff;
    count += 7;
    if (count < 8) return;
    count -= 8;
    if (at < length) bytes[at++] = held >> count;
  };
  for (let i = 0; i < text.length; i += 1) {
    const code = text.charCodeAt(i);
    if (code < 128) {
      take(code);
    } else {
      take(FORBIDDEN[(code - FIRST) >> 7]);
      take((code - FIRST) & 127);
    }
  }
  return bytes;
}
