#include "felt/store/stroke_blob.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "felt/base/utf8.h"
#include "felt/store/byte_writer.h"
#include "felt/store/crc32c.h"
#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

/// Packs doubles into few bytes without loss (docs/formats/felt.md, "Packed numbers"). Each is
/// stored as the difference from a guess, which the reader computes in the same way, or as its
/// leading bytes if it is a round number. A number that equals its guess takes half a byte. Any
/// other number takes at most half a byte more than the double itself.
class NumberPacker {
 public:
  void put(double value, double guess);
  void append_to(std::string& out) const;

 private:
  std::string lengths_, bytes_;
  bool is_odd_ = false;
};

/// Unpacks what NumberPacker packed. Requires the same guesses as in the packer.
class NumberUnpacker {
 public:
  /// Accepts any bytes. If there are too few, in.ok() is false afterwards.
  NumberUnpacker(ByteReader& in, std::size_t count);

  double take(double guess);
  /// Returns true if the unused half byte of the lengths is zero, as the packer leaves it.
  [[nodiscard]] bool is_clean() const noexcept;

 private:
  std::string_view lengths_;
  ByteReader& in_;
  std::size_t count_;
  std::size_t taken_ = 0;
};

constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
/// A length of at most 8 is the number of bytes of a difference. A greater length is 8 plus the
/// number of leading bytes of a round number.
constexpr unsigned kMaxDifferenceBytes = 8;

/// Maps doubles to whole numbers in the same order. Neighbouring doubles become consecutive
/// numbers.
std::uint64_t rank_of(double value) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

double of_rank(std::uint64_t rank) noexcept {
  return std::bit_cast<double>((rank & kSign) != 0 ? rank ^ kSign : ~rank);
}

/// Maps small differences of either sign to small numbers: 0, -1, 1, -2, ... to 0, 1, 2, 3, ...
std::uint64_t folded(std::uint64_t difference) noexcept {
  return (difference << 1) ^ ((difference & kSign) != 0 ? ~std::uint64_t{0} : 0);
}

std::uint64_t unfolded(std::uint64_t n) noexcept {
  return (n >> 1) ^ ((n & 1) != 0 ? ~std::uint64_t{0} : 0);
}

void NumberPacker::put(double value, double guess) {
  const std::uint64_t difference = folded(rank_of(value) - rank_of(guess));
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto size = static_cast<unsigned>(std::bit_width(difference) + 7) / 8;
  const auto leading = bits == 0 ? 1U : 8U - static_cast<unsigned>(std::countr_zero(bits)) / 8;
  const bool is_round = leading < size;
  const unsigned length = is_round ? kMaxDifferenceBytes + leading : size;
  if (is_odd_) {
    lengths_.back() = static_cast<char>(static_cast<unsigned char>(lengths_.back()) | length << 4);
  } else {
    lengths_ += static_cast<char>(length);
  }
  is_odd_ = !is_odd_;
  const std::uint64_t n = is_round ? bits >> (64 - 8 * leading) : difference;
  for (unsigned i = 0; i < (is_round ? leading : size); ++i) {
    bytes_ += static_cast<char>((n >> (8 * i)) & 0xff);
  }
}

void NumberPacker::append_to(std::string& out) const {
  out += lengths_;
  out += bytes_;
}

NumberUnpacker::NumberUnpacker(ByteReader& in, std::size_t count)
    : lengths_(in.bytes((count + 1) / 2)), in_(in), count_(count) {}

double NumberUnpacker::take(double guess) {
  const std::size_t at = taken_++;
  if (at / 2 >= lengths_.size()) return 0.0;
  const auto pair = static_cast<unsigned char>(lengths_[at / 2]);
  const unsigned length = at % 2 == 0 ? pair & 0xfU : pair >> 4;
  if (length <= kMaxDifferenceBytes) {
    return of_rank(rank_of(guess) + unfolded(in_.whole(length)));
  }
  const unsigned leading = length - kMaxDifferenceBytes;
  return std::bit_cast<double>(in_.whole(leading) << (64 - 8 * leading));
}

bool NumberUnpacker::is_clean() const noexcept {
  return count_ % 2 == 0 || lengths_.empty() ||
         static_cast<unsigned char>(lengths_.back()) >> 4 == 0;
}

/// Version of a blob in which all tones are the default tones of the widths. Blobs written before
/// strokes had tones have this version, too.
constexpr std::uint8_t kPlain = 1;
/// Version of a blob with its own tones.
constexpr std::uint8_t kToned = 2;
constexpr std::uint8_t kClosed = 1;  // flags
constexpr std::size_t kChecksumBytes = 4;

/// Predicts a control point from those before it. The arithmetic is part of the format: IEEE 754
/// doubles, each operation rounded.
class PointGuess {
 public:
  explicit PointGuess(const std::vector<Point>& points) noexcept : points_(points) {}

  /// Returns true if y is stored before x.
  [[nodiscard]] bool is_y_first(std::size_t i) const noexcept {
    return turns_on(i) && std::abs(way(i).y) > std::abs(way(i).x);
  }
  [[nodiscard]] Point before(std::size_t i) const noexcept {
    return i > 0 ? points_[i - 1] : Point{0.0, 0.0};
  }
  /// Predicts the second coordinate of a point from its first one, `along`.
  [[nodiscard]] double across(std::size_t i, double along) const noexcept {
    const Point p = before(i);
    const bool y_first = is_y_first(i);
    const double stays = y_first ? p.x : p.y;
    if (!turns_on(i)) return stays;
    const Vec w = way(i);
    const double part = y_first ? (along - p.y) / w.y : (along - p.x) / w.x;
    const double guess = stays + (y_first ? w.x : w.y) * part;
    return std::isfinite(guess) ? guess : stays;
  }

 private:
  /// Returns true if point i is the first handle of a segment after a joint. If the joint is
  /// smooth, such a handle has the direction of the handle before the joint, up to rounding.
  static bool turns_on(std::size_t i) noexcept { return i % 3 == 1 && i > 1; }
  [[nodiscard]] Vec way(std::size_t i) const noexcept { return points_[i - 1] - points_[i - 2]; }

  const std::vector<Point>& points_;
};

/// Returns the number of points to write. The last point of a closed stroke is its first one and is
/// not written.
std::size_t written_points(const StrokeData& d) noexcept {
  return d.points.size() - (d.closed ? 1 : 0);
}

void write_points(NumberPacker& out, const StrokeData& d) {
  const PointGuess guess(d.points);
  for (std::size_t i = 0; i < written_points(d); ++i) {
    const Point p = d.points[i], before = guess.before(i);
    const bool y_first = guess.is_y_first(i);
    const double first = y_first ? p.y : p.x;
    out.put(first, y_first ? before.y : before.x);
    out.put(y_first ? p.x : p.y, guess.across(i, first));
  }
}

void read_points(NumberUnpacker& in, StrokeData& d) {
  const PointGuess guess(d.points);
  for (std::size_t i = 0; i < written_points(d); ++i) {
    const Point before = guess.before(i);
    const bool y_first = guess.is_y_first(i);
    const double first = in.take(y_first ? before.y : before.x);
    const double second = in.take(guess.across(i, first));
    d.points[i] = y_first ? Point{second, first} : Point{first, second};
  }
  if (d.closed) d.points.back() = d.points.front();
}

/// Writes the widths. The u of the first knot and that of the last knot are not written, because
/// these knots are at the ends of the stroke.
void write_widths(NumberPacker& out, const std::vector<WidthKnot>& widths) {
  for (std::size_t i = 1; i + 1 < widths.size(); ++i) out.put(widths[i].u, widths[i - 1].u);
  double before = 0.0;
  for (const WidthKnot& knot : widths) {
    out.put(knot.width_mm, before);
    before = knot.width_mm;
  }
}

void read_widths(NumberUnpacker& in, double end, std::vector<WidthKnot>& widths) {
  for (std::size_t i = 1; i + 1 < widths.size(); ++i) widths[i].u = in.take(widths[i - 1].u);
  widths.back().u = end;
  double before = 0.0;
  for (WidthKnot& knot : widths) before = knot.width_mm = in.take(before);
  take_tone_of_width(widths);
}

void write_tones(NumberPacker& out, const std::vector<WidthKnot>& widths) {
  double before = 0.0;
  for (const WidthKnot& knot : widths) {
    out.put(knot.tone, before);
    before = knot.tone;
  }
}

void read_tones(NumberUnpacker& in, std::vector<WidthKnot>& widths) {
  double before = 0.0;
  for (WidthKnot& knot : widths) before = knot.tone = in.take(before);
}

void write_joints(ByteWriter& out, const std::vector<JointKind>& joints) {
  for (std::size_t i = 0; i < joints.size(); i += 8) {
    unsigned bits = 0;
    for (std::size_t k = i; k < joints.size() && k < i + 8; ++k) {
      if (joints[k] == JointKind::kCorner) bits |= 1U << (k - i);
    }
    out.u8(static_cast<std::uint8_t>(bits));
  }
}

bool read_joints(ByteReader& in, std::size_t count, std::vector<JointKind>& joints) {
  const std::string_view bits = in.bytes((count + 7) / 8);
  if (!in.ok()) return false;
  joints.reserve(count);
  for (std::size_t i = 0; i < 8 * bits.size(); ++i) {
    const bool is_corner = ((static_cast<unsigned char>(bits[i / 8]) >> (i % 8)) & 1) != 0;
    if (i < count) {
      joints.push_back(is_corner ? JointKind::kCorner : JointKind::kSmooth);
    } else if (is_corner) {
      return false;
    }
  }
  return true;
}

std::size_t number_count(const StrokeData& d, bool toned) noexcept {
  return 2 * written_points(d) + (toned ? 3 : 2) * d.widths.size() - 2;
}

void write_shape(std::string& bytes, const StrokeData& d) {
  ByteWriter out(bytes);
  const bool toned = has_own_tone(d.widths);
  out.u8(toned ? kToned : kPlain);
  out.u8(d.closed ? kClosed : 0);
  for (const std::uint8_t c : {d.color.r, d.color.g, d.color.b, d.color.a}) out.u8(c);
  out.count(d.medium.size());
  bytes += d.medium;
  out.count(d.points.size() / 3);
  out.count(d.widths.size());
  write_joints(out, d.joints);
  NumberPacker numbers;
  write_points(numbers, d);
  write_widths(numbers, d.widths);
  if (toned) write_tones(numbers, d.widths);
  numbers.append_to(bytes);
}

Result<void> read_sizes(ByteReader& in, StrokeData& d) {
  const std::uint64_t segments = in.count(), knots = in.count();
  if (!in.ok() || segments == 0 || knots < 2) return invalid_data("has no segment or no width");
  if (segments > kMaxStrokeSegments || knots > kMaxStrokeKnots) {
    return fail(ErrorCode::kLimitExceeded, "has more segments or widths than a stroke can have");
  }
  // Each point and knot needs at least one byte.
  if (!in.has(3 * segments + knots - 1, 1)) return invalid_data("has fewer points than it states");
  d.points.resize(3 * segments + 1);
  d.widths.resize(knots);
  return {};
}

Result<void> read_shape(ByteReader& in, bool toned, StrokeData& d) {
  const std::uint8_t flags = in.u8();
  if ((flags & ~kClosed) != 0) return invalid_data("has unknown flags");
  d.closed = (flags & kClosed) != 0;
  for (std::uint8_t* c : {&d.color.r, &d.color.g, &d.color.b, &d.color.a}) *c = in.u8();
  const std::uint64_t name_bytes = in.count();
  if (name_bytes > kMaxMaterialNameBytes) return invalid_data("has no material name");
  d.medium = std::string(in.bytes(name_bytes));
  if (!in.ok() || !is_utf8(d.medium)) return invalid_data("has no material name");
  if (auto ok = read_sizes(in, d); !ok) return ok;
  const std::size_t segments = d.points.size() / 3;
  if (!read_joints(in, segments - (d.closed ? 0 : 1), d.joints)) {
    return invalid_data("lacks its joints");
  }
  NumberUnpacker numbers(in, number_count(d, toned));
  read_points(numbers, d);
  read_widths(numbers, static_cast<double>(segments), d.widths);
  if (toned) read_tones(numbers, d.widths);
  if (!in.ok()) return invalid_data("has fewer points than it states");
  if (in.left() > 0 || !numbers.is_clean()) return invalid_data("has unexpected bytes at the end");
  // Refuses redundant tones, so that equal strokes have equal bytes.
  if (toned && !has_own_tone(d.widths)) return invalid_data("has tones that repeat its widths");
  return {};
}

}  // namespace

Result<void> append_stroke_blob(std::string& out, const Stroke& stroke) {
  const StrokeData& d = stroke.data();
  if (d.points.size() > 3 * kMaxStrokeSegments + 1 || d.widths.size() > kMaxStrokeKnots ||
      d.medium.size() > kMaxMaterialNameBytes) {
    return fail(ErrorCode::kLimitExceeded, "the stroke is too large for a file");
  }
  if (!is_utf8(d.medium)) {
    return fail(ErrorCode::kInvalidData, "the material's name is not UTF-8");
  }
  const std::size_t begin = out.size();
  write_shape(out, d);
  ByteWriter(out).u32(crc32c(std::string_view(out).substr(begin)));
  return {};
}

Result<Stroke> read_stroke_blob(std::string_view bytes) {
  if (bytes.size() > kMaxStrokeBlobBytes) return invalid_data("is too large");
  if (bytes.size() <= kChecksumBytes) return invalid_data("is incomplete");
  // Checks the version first, because another version may have its checksum elsewhere.
  const auto version = static_cast<std::uint8_t>(bytes[0]);
  if (version != kPlain && version != kToned) {
    return fail(ErrorCode::kUnsupported, "has version " + std::to_string(version) +
                                             "; this program supports versions up to " +
                                             std::to_string(kToned));
  }
  const std::string_view shape = bytes.substr(0, bytes.size() - kChecksumBytes);
  if (ByteReader(bytes.substr(shape.size())).u32() != crc32c(shape)) {
    return invalid_data("is damaged: its checksum does not match its bytes");
  }
  ByteReader in(shape.substr(1));
  StrokeData data;
  if (auto ok = read_shape(in, version == kToned, data); !ok) return tl::unexpected(ok.error());
  return Stroke::create(std::move(data));
}

}  // namespace felt
