#include "felt/store/stroke_blob.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "felt/base/utf8.h"
#include "felt/store/byte_stream.h"
#include "felt/store/crc32c.h"
#include "felt/store/packed_numbers.h"
#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

/// Of a stroke whose tones are those of its widths; all that there was before strokes had tones.
constexpr std::uint8_t kPlain = 1;
/// Of one with tones of its own.
constexpr std::uint8_t kToned = 2;
constexpr std::uint8_t kClosed = 1;  // flags
constexpr std::size_t kChecksumBytes = 4;

tl::unexpected<Error> damaged(const char* what) {
  return fail(ErrorCode::kInvalidData, what);
}

/// What a control point is likely to be, from those before it. The arithmetic is part of the
/// format: doubles of IEEE 754, each operation rounded.
class PointGuess {
 public:
  explicit PointGuess(const std::vector<Point>& points) noexcept : points_(points) {}

  /// Whether y is known first, x follows then.
  [[nodiscard]] bool is_y_first(std::size_t i) const noexcept {
    return turns_on(i) && std::abs(way(i).y) > std::abs(way(i).x);
  }
  [[nodiscard]] Point before(std::size_t i) const noexcept {
    return i > 0 ? points_[i - 1] : Point{0.0, 0.0};
  }
  /// The second coordinate, `along` being the first.
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
  /// The first handle of a segment goes on the way of the handle before the joint: exactly so where
  /// the joint is smooth, but for the last bits.
  static bool turns_on(std::size_t i) noexcept { return i % 3 == 1 && i > 1; }
  [[nodiscard]] Vec way(std::size_t i) const noexcept { return points_[i - 1] - points_[i - 2]; }

  const std::vector<Point>& points_;
};

/// How many points are written: a closed stroke ends where it begins.
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

/// The first and the last breakpoint are at the ends.
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
  out.count(d.material.size());
  bytes += d.material;
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
  if (!in.ok() || segments == 0 || knots < 2) return damaged("has no segment or no width");
  if (segments > kMaxStrokeSegments || knots > kMaxStrokeKnots) {
    return fail(ErrorCode::kLimitExceeded, "has more segments or widths than a stroke may have");
  }
  // Each point and breakpoint has a byte at least.
  if (!in.has(3 * segments + knots - 1, 1)) return damaged("has fewer points than it says");
  d.points.resize(3 * segments + 1);
  d.widths.resize(knots);
  return {};
}

Result<void> read_shape(ByteReader& in, bool toned, StrokeData& d) {
  const std::uint8_t flags = in.u8();
  if ((flags & ~kClosed) != 0) return damaged("has unknown flags");
  d.closed = (flags & kClosed) != 0;
  for (std::uint8_t* c : {&d.color.r, &d.color.g, &d.color.b, &d.color.a}) *c = in.u8();
  const std::uint64_t name_bytes = in.count();
  if (name_bytes > kMaxMaterialNameBytes) return damaged("names no material");
  d.material = std::string(in.bytes(name_bytes));
  if (!in.ok() || !is_utf8(d.material)) return damaged("names no material");
  if (auto ok = read_sizes(in, d); !ok) return ok;
  const std::size_t segments = d.points.size() / 3;
  if (!read_joints(in, segments - (d.closed ? 0 : 1), d.joints)) {
    return damaged("has no joints as it should");
  }
  NumberUnpacker numbers(in, number_count(d, toned));
  read_points(numbers, d);
  read_widths(numbers, static_cast<double>(segments), d.widths);
  if (toned) read_tones(numbers, d.widths);
  if (!in.ok()) return damaged("has fewer points than it says");
  if (in.left() > 0 || !numbers.is_clean()) return damaged("has bytes left over");
  // Equal strokes have equal bytes.
  if (toned && !has_own_tone(d.widths)) return damaged("has tones that its widths say already");
  return {};
}

}  // namespace

Result<void> append_stroke_blob(std::string& out, const Stroke& stroke) {
  const StrokeData& d = stroke.data();
  if (d.points.size() > 3 * kMaxStrokeSegments + 1 || d.widths.size() > kMaxStrokeKnots ||
      d.material.size() > kMaxMaterialNameBytes) {
    return fail(ErrorCode::kLimitExceeded, "the stroke is too large for a file");
  }
  if (!is_utf8(d.material)) {
    return fail(ErrorCode::kInvalidData, "the material's name is not UTF-8");
  }
  const std::size_t begin = out.size();
  write_shape(out, d);
  ByteWriter(out).u32(crc32c(std::string_view(out).substr(begin)));
  return {};
}

Result<Stroke> read_stroke_blob(std::string_view bytes) {
  if (bytes.size() > kMaxStrokeBlobBytes) return damaged("is too large");
  if (bytes.size() <= kChecksumBytes) return damaged("is cut off");
  // The version is looked at first: another one may keep its checksum elsewhere.
  const auto version = static_cast<std::uint8_t>(bytes[0]);
  if (version != kPlain && version != kToned) {
    return fail(ErrorCode::kUnsupported, "is of version " + std::to_string(version) +
                                             ", this program knows versions up to " +
                                             std::to_string(kToned));
  }
  const std::string_view shape = bytes.substr(0, bytes.size() - kChecksumBytes);
  if (ByteReader(bytes.substr(shape.size())).u32() != crc32c(shape)) {
    return damaged("is damaged: its checksum is not that of its bytes");
  }
  ByteReader in(shape.substr(1));
  StrokeData data;
  if (auto ok = read_shape(in, version == kToned, data); !ok) return tl::unexpected(ok.error());
  return Stroke::create(std::move(data));
}

}  // namespace felt
