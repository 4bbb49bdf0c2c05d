#include "felt/store/stroke_blob.h"

#include <cstdint>
#include <utility>

#include "felt/base/utf8.h"
#include "felt/store/byte_stream.h"
#include "felt/store/crc32c.h"

namespace felt {
namespace {

constexpr std::uint8_t kVersion = 1;
constexpr std::uint8_t kClosed = 1;  // flags
constexpr std::size_t kChecksumBytes = 4;
constexpr std::size_t kPointBytes = 16, kKnotBytes = 16;
constexpr std::size_t kMaxMaterialBytes = 4096;

tl::unexpected<Error> damaged(const char* what) {
  return fail(ErrorCode::kInvalidData, what);
}

void write_shape(ByteWriter& out, const StrokeData& d) {
  out.u8(kVersion);
  out.u8(d.closed ? kClosed : 0);
  for (const std::uint8_t c : {d.color.r, d.color.g, d.color.b, d.color.a}) out.u8(c);
  out.text(d.material);
  out.u32(static_cast<std::uint32_t>(d.points.size() / 3));
  for (const JointKind joint : d.joints) out.u8(joint == JointKind::kCorner ? 1 : 0);
  for (const Point& p : d.points) {
    out.f64(p.x);
    out.f64(p.y);
  }
  out.u32(static_cast<std::uint32_t>(d.widths.size()));
  for (const WidthKnot& knot : d.widths) {
    out.f64(knot.u);
    out.f64(knot.width_mm);
  }
}

Result<void> read_joints(ByteReader& in, std::size_t count, std::vector<JointKind>& joints) {
  if (!in.has(count, 1)) return damaged("ends within the joints");
  joints.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t kind = in.u8();
    if (kind > 1) return damaged("has a joint of an unknown kind");
    joints.push_back(kind == 1 ? JointKind::kCorner : JointKind::kSmooth);
  }
  return {};
}

Result<void> read_shape(ByteReader& in, StrokeData& d) {
  const std::uint8_t flags = in.u8();
  if ((flags & ~kClosed) != 0) return damaged("has unknown flags");
  d.closed = (flags & kClosed) != 0;
  for (std::uint8_t* c : {&d.color.r, &d.color.g, &d.color.b, &d.color.a}) *c = in.u8();
  d.material = std::string(in.text(kMaxMaterialBytes));
  if (!in.ok() || !is_utf8(d.material)) return damaged("names no material");
  const std::uint64_t segments = in.u32();
  if (segments == 0 || !in.has(3 * segments + 1, kPointBytes)) {
    return damaged("has fewer points than it says");
  }
  if (auto ok = read_joints(in, segments - (d.closed ? 0 : 1), d.joints); !ok) return ok;
  if (!in.has(3 * segments + 1, kPointBytes)) return damaged("has fewer points than it says");
  d.points.resize(3 * segments + 1);
  for (Point& p : d.points) {
    p.x = in.f64();
    p.y = in.f64();
  }
  const std::uint64_t knots = in.u32();
  if (!in.has(knots, kKnotBytes)) return damaged("has fewer widths than it says");
  d.widths.resize(knots);
  for (WidthKnot& knot : d.widths) {
    knot.u = in.f64();
    knot.width_mm = in.f64();
  }
  if (!in.ok() || in.left() > 0) return damaged("has bytes left over");
  return {};
}

}  // namespace

Result<void> append_stroke_blob(std::string& out, const Stroke& stroke) {
  const StrokeData& d = stroke.data();
  const std::size_t size = kPointBytes * d.points.size() + kKnotBytes * d.widths.size() +
                           d.joints.size() + d.material.size() + 64;
  if (size > kMaxStrokeBlobBytes || d.material.size() > kMaxMaterialBytes) {
    return fail(ErrorCode::kLimitExceeded, "the stroke is too large for a file");
  }
  if (!is_utf8(d.material)) {
    return fail(ErrorCode::kInvalidData, "the material's name is not UTF-8");
  }
  const std::size_t begin = out.size();
  out.reserve(begin + size);
  ByteWriter writer(out);
  write_shape(writer, d);
  writer.u32(crc32c(std::string_view(out).substr(begin)));
  return {};
}

Result<Stroke> read_stroke_blob(std::string_view bytes) {
  if (bytes.size() > kMaxStrokeBlobBytes) return damaged("is too large");
  if (bytes.size() <= kChecksumBytes) return damaged("is cut off");
  // The version is looked at first: another one may keep its checksum elsewhere.
  if (static_cast<std::uint8_t>(bytes[0]) != kVersion) {
    return fail(ErrorCode::kUnsupported,
                "is of version " + std::to_string(static_cast<unsigned char>(bytes[0])) +
                    ", this program knows version " + std::to_string(kVersion));
  }
  const std::string_view shape = bytes.substr(0, bytes.size() - kChecksumBytes);
  if (ByteReader(bytes.substr(shape.size())).u32() != crc32c(shape)) {
    return damaged("is damaged: its checksum is not that of its bytes");
  }
  ByteReader in(shape.substr(1));
  StrokeData data;
  if (auto ok = read_shape(in, data); !ok) return tl::unexpected(ok.error());
  return Stroke::create(std::move(data));
}

}  // namespace felt
