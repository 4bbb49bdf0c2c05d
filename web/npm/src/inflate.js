// A decoder of the DEFLATE format (RFC 1951) for the module that is part of the file. Browsers have
// no synchronous one.

// Symbols of lengths and distances: their extra bits and their first value (RFC 1951, 3.2.5).
const LENGTH_BITS = [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0];
const CODE_ORDER = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];

const firstValues = (bits, first) => bits.map((_, i) => bits.slice(0, i).reduce((sum, b) => sum + (1 << b), first));

const LENGTHS = firstValues(LENGTH_BITS, 3);
LENGTHS[28] = 258;
const DISTANCE_BITS = Array.from({ length: 30 }, (_, i) => Math.max(0, (i >> 1) - 1));
const DISTANCES = firstValues(DISTANCE_BITS, 1);

/** Returns a code: how many symbols have each length, and the symbols in their order. */
function codeOf(lengths) {
  const counts = new Uint16Array(16), symbols = [];
  for (let length = 1; length < 16; ++length) {
    lengths.forEach((of, symbol) => {
      if (of !== length) return;
      ++counts[length];
      symbols.push(symbol);
    });
  }
  return { counts, symbols };
}

/** Returns the `size` bytes that `bytes` encodes. */
export function inflate(bytes, size) {
  const out = new Uint8Array(size);
  let at = 0, position = 0, buffer = 0, available = 0;
  const bits = (count) => {
    while (available < count) {
      buffer |= bytes[position++] << available;
      available += 8;
    }
    const value = buffer & ((1 << count) - 1);
    buffer >>>= count;
    available -= count;
    return value;
  };
  const symbolOf = ({ counts, symbols }) => {
    let code = 0, first = 0, index = 0;
    for (let length = 1; length < 16; ++length) {
      code |= bits(1);
      if (code - counts[length] < first) return symbols[index + code - first];
      index += counts[length];
      first = (first + counts[length]) << 1;
      code <<= 1;
    }
    throw new Error('the module is damaged');
  };
  const readCodes = () => {
    const literals = bits(5) + 257, distances = bits(5) + 1, count = bits(4) + 4;
    const lengths = new Array(19).fill(0);
    for (let i = 0; i < count; ++i) lengths[CODE_ORDER[i]] = bits(3);
    const code = codeOf(lengths), all = [];
    while (all.length < literals + distances) {
      const symbol = symbolOf(code);
      if (symbol < 16) all.push(symbol);
      else {
        const value = symbol === 16 ? all[all.length - 1] : 0;
        const times = symbol === 16 ? 3 + bits(2) : symbol === 17 ? 3 + bits(3) : 11 + bits(7);
        for (let i = 0; i < times; ++i) all.push(value);
      }
    }
    return [codeOf(all.slice(0, literals)), codeOf(all.slice(literals))];
  };
  const fixedCodes = () => [
    codeOf(Array.from({ length: 288 }, (_, i) => i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8)),
    codeOf(new Array(30).fill(5)),
  ];
  const copyStored = () => {
    bits(available % 8);
    const length = bits(16);
    bits(16);
    for (let i = 0; i < length; ++i) out[at++] = bits(8);
  };
  for (let last = 0; !last;) {
    last = bits(1);
    const kind = bits(2);
    if (kind === 0) {
      copyStored();
      continue;
    }
    if (kind === 3) throw new Error('the module is damaged');
    const [literals, distances] = kind === 2 ? readCodes() : fixedCodes();
    for (let symbol; (symbol = symbolOf(literals)) !== 256;) {
      if (symbol < 256) out[at++] = symbol;
      else {
        const length = LENGTHS[symbol - 257] + bits(LENGTH_BITS[symbol - 257]);
        const code = symbolOf(distances), distance = DISTANCES[code] + bits(DISTANCE_BITS[code]);
        for (let i = 0; i < length; ++i, ++at) out[at] = out[at - distance];
      }
    }
  }
  return out;
}
