// A decoder of .lzma files (https://www.7-zip.org/sdk.html, lzma-specification.txt), a module of
// its own of some kB: it unpacks the module of the core, which is a fifth smaller so than with
// gzip. The output is also the dictionary.

#include <cstddef>
#include <cstdint>

namespace {

constexpr std::uint32_t kTop = 1U << 24U;
constexpr int kModelBits = 11, kMoveBits = 5;
constexpr int kStates = 12, kLiteralStates = 7;
constexpr std::size_t kHeaderBytes = 13;
using Prob = std::uint16_t;

/// Reads bits of an adaptive binary range code.
struct Decoder {
  const std::uint8_t* in = nullptr;
  std::uint32_t range = 0xFFFFFFFFU, code = 0;

  void normalise() {
    if (range >= kTop) return;
    range <<= 8U;
    code = code << 8U | *in++;
  }
  unsigned bit(Prob& prob) {
    const std::uint32_t bound = (range >> kModelBits) * prob;
    unsigned bit = 0;
    if (code < bound) {
      range = bound;
      prob = static_cast<Prob>(prob + (((1U << kModelBits) - prob) >> kMoveBits));
    } else {
      range -= bound;
      code -= bound;
      prob = static_cast<Prob>(prob - (prob >> kMoveBits));
      bit = 1;
    }
    normalise();
    return bit;
  }
  unsigned tree(Prob* probs, int bits) {
    unsigned m = 1;
    for (int i = 0; i < bits; ++i) m = m << 1U | bit(probs[m]);
    return m - (1U << bits);
  }
  unsigned reverse_tree(Prob* probs, int bits) {
    unsigned m = 1, value = 0;
    for (int i = 0; i < bits; ++i) {
      const unsigned b = bit(probs[m]);
      m = m << 1U | b;
      value |= b << i;
    }
    return value;
  }
  unsigned direct(int bits) {
    unsigned value = 0;
    while (bits-- > 0) {
      range >>= 1U;
      const unsigned is_set = code >= range;
      if (is_set) code -= range;
      value = value << 1U | is_set;
      normalise();
    }
    return value;
  }
};

/// The code of the length of a match.
struct Lengths {
  Prob choice[2], low[16][8], middle[16][8], high[256];

  unsigned read(Decoder& from, unsigned position) {
    if (from.bit(choice[0]) == 0) return from.tree(low[position], 3);
    if (from.bit(choice[1]) == 0) return 8 + from.tree(middle[position], 3);
    return 16 + from.tree(high, 8);
  }
};

struct Tables {
  Prob is_match[kStates][16], is_rep[kStates], is_rep0[kStates], is_rep1[kStates], is_rep2[kStates];
  Prob is_long_rep0[kStates][16], slots[4][64], special[128], align[16];
  Lengths match, rep;
  Prob literals[0x300 << 4];
};
Tables tables;

void reset() {
  Prob* const probs = reinterpret_cast<Prob*>(&tables);
  for (std::size_t i = 0; i < sizeof(Tables) / sizeof(Prob); ++i) probs[i] = 1U << (kModelBits - 1);
}

unsigned literal(Decoder& from, Prob* probs, unsigned match_byte, bool after_match) {
  unsigned symbol = 1;
  for (; after_match && symbol < 0x100; match_byte <<= 1U) {
    const unsigned match_bit = match_byte >> 7U & 1U;
    const unsigned b = from.bit(probs[((1 + match_bit) << 8U) + symbol]);
    symbol = symbol << 1U | b;
    if (b != match_bit) break;
  }
  while (symbol < 0x100) symbol = symbol << 1U | from.bit(probs[symbol]);
  return symbol & 0xFFU;
}

unsigned distance(Decoder& from, unsigned length) {
  const unsigned slot = from.tree(tables.slots[length < 3 ? length : 3], 6);
  if (slot < 4) return slot;
  const int bits = static_cast<int>(slot >> 1U) - 1;
  const unsigned base = (2U | (slot & 1U)) << bits;
  if (slot < 14) return base + from.reverse_tree(tables.special + base - slot, bits);
  return base + (from.direct(bits - 4) << 4U) + from.reverse_tree(tables.align, 4);
}

/// What the last symbols were, and the distances of the last matches.
struct History {
  unsigned state = 0;
  unsigned rep[4] = {0, 0, 0, 0};

  [[nodiscard]] bool after_literal() const { return state < kLiteralStates; }
};

/// Reads which earlier distance is used again, and moves it to the front.
void repeat(Decoder& from, History& history) {
  unsigned* const rep = history.rep;
  unsigned next = rep[1];
  if (from.bit(tables.is_rep1[history.state]) != 0) {
    next = rep[2];
    if (from.bit(tables.is_rep2[history.state]) != 0) {
      next = rep[3];
      rep[3] = rep[2];
    }
    rep[2] = rep[1];
  }
  rep[1] = rep[0];
  rep[0] = next;
}

/// Reads a match, whose distance is rep[0] + 1 afterwards, and returns its length.
unsigned match(Decoder& from, History& history, unsigned position) {
  unsigned& state = history.state;
  unsigned* const rep = history.rep;
  if (from.bit(tables.is_rep[state]) == 0) {
    for (int i = 3; i > 0; --i) rep[i] = rep[i - 1];
    const unsigned length = tables.match.read(from, position);
    state = history.after_literal() ? 7 : 10;
    rep[0] = distance(from, length);
    return length + 2;
  }
  if (from.bit(tables.is_rep0[state]) != 0) {
    repeat(from, history);
  } else if (from.bit(tables.is_long_rep0[state][position]) == 0) {
    state = history.after_literal() ? 9 : 11;
    return 1;
  }
  const unsigned length = tables.rep.read(from, position);
  state = history.after_literal() ? 8 : 11;
  return length + 2;
}

/// A file that is being unpacked.
struct Job {
  Decoder from;
  History history;
  std::uint8_t* out = nullptr;
  std::size_t size = 0, at = 0;
  unsigned position_mask = 0, literal_mask = 0, literal_bits = 0;
};
Job job;

void read_literal() {
  History& history = job.history;
  std::uint8_t* const out = job.out;
  const std::size_t at = job.at;
  const unsigned before = at > 0 ? out[at - 1] : 0;
  const unsigned context = ((static_cast<unsigned>(at) & job.literal_mask) << job.literal_bits) +
                           (before >> (8 - job.literal_bits));
  const bool after_match = !history.after_literal();
  const unsigned match_byte = after_match ? out[at - history.rep[0] - 1] : 0;
  Prob* const probs = tables.literals + std::size_t{0x300} * context;
  out[job.at++] = static_cast<std::uint8_t>(literal(job.from, probs, match_byte, after_match));
  history.state = history.state < 4    ? 0
                  : history.state < 10 ? history.state - 3
                                       : history.state - 6;
}

}  // namespace

/// Replaces base64 text by its bytes, in place. The text has only letters of base64, and = at the
/// end. JavaScript copies a text into memory fast, but reads its letters slowly.
extern "C" __attribute__((export_name("decode"))) void decode(std::uint8_t* text,
                                                              std::size_t size) {
  std::uint8_t* out = text;
  for (std::size_t i = 0; i + 4 <= size; i += 4) {
    std::uint32_t bits = 0;
    for (std::size_t k = i; k < i + 4; ++k) {
      const std::uint32_t c = text[k];
      const std::uint32_t value = c >= 'a'   ? c - 'a' + 26
                                  : c >= 'A' ? c - 'A'
                                  : c >= '0' ? c - '0' + 52
                                             : (c == '+' ? 62 : 63);
      bits = bits << 6U | (value & 63U);
    }
    *out++ = static_cast<std::uint8_t>(bits >> 16U);
    *out++ = static_cast<std::uint8_t>(bits >> 8U);
    *out++ = static_cast<std::uint8_t>(bits);
  }
}

/// Begins to unpack a .lzma file to `size` bytes. Returns 1 on success. Does not check the packed
/// bytes, which come with the page.
extern "C" __attribute__((export_name("begin"))) int begin(const std::uint8_t* packed,
                                                           std::uint8_t* out, std::size_t size) {
  const unsigned props = packed[0];
  const unsigned lc = props % 9, lp = props / 9 % 5, pb = props / 45;
  if (lc + lp > 4 || pb > 4) return 0;
  reset();
  job = {};
  job.out = out;
  job.size = size;
  job.position_mask = (1U << pb) - 1;
  job.literal_mask = (1U << lp) - 1;
  job.literal_bits = lc;
  job.from.in = packed + kHeaderBytes + 1;
  for (int i = 0; i < 4; ++i) job.from.code = job.from.code << 8U | *job.from.in++;
  return 1;
}

/// Unpacks at least `count` more bytes, or the rest. Returns the number of all unpacked bytes, or 0
/// if the file is damaged. The caller calls it in parts, because an engine can only replace the
/// code of a function by faster code between two calls.
extern "C" __attribute__((export_name("unpack"))) std::size_t unpack(std::size_t count) {
  const std::size_t end = count < job.size - job.at ? job.at + count : job.size;
  while (job.at < end) {
    const unsigned position = static_cast<unsigned>(job.at) & job.position_mask;
    if (job.from.bit(tables.is_match[job.history.state][position]) == 0) {
      read_literal();
      continue;
    }
    unsigned length = match(job.from, job.history, position);
    const std::size_t distance = std::size_t{job.history.rep[0]} + 1;
    if (distance > job.at) return 0;  // also at the mark of the end
    for (; length > 0 && job.at < job.size; --length, ++job.at) {
      job.out[job.at] = job.out[job.at - distance];
    }
  }
  return job.at;
}
