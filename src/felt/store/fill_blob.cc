#include "felt/store/fill_blob.h"

#include <cstdint>
#include <memory>
#include <utility>

#include "felt/store/byte_writer.h"

namespace felt {
namespace {

constexpr std::uint8_t kFillVersion = 1;
constexpr std::size_t kSegmentBytes = 48, kMinLoopBytes = 2;

void write_loop(ByteWriter& out, const FillLoop& loop) {
  out.count(loop.points.size() / 3);
  out.count(loop.pieces.size());
  for (std::size_t i = 0; i + 1 < loop.points.size(); ++i) {
    out.f64(loop.points[i].x);
    out.f64(loop.points[i].y);
  }
  for (const FillPiece& piece : loop.pieces) {
    out.count(piece.stroke.value);
    if (!piece.stroke) continue;
    out.f64(piece.from);
    out.f64(piece.to);
  }
}

bool read_loop(ByteReader& in, FillLoop& loop) {
  const std::uint64_t segments = in.count(), pieces = in.count();
  if (segments == 0 || !in.has(segments, kSegmentBytes) || !in.has(pieces, 1)) return false;
  for (std::uint64_t i = 0; i < 3 * segments; ++i) {
    const double x = in.f64(), y = in.f64();
    loop.points.push_back({x, y});
  }
  loop.points.push_back(loop.points.front());
  for (std::uint64_t i = 0; i < pieces && in.ok(); ++i) {
    FillPiece piece{{in.count()}};
    if (piece.stroke) {
      piece.from = in.f64();
      piece.to = in.f64();
    }
    loop.pieces.push_back(piece);
  }
  return in.ok();
}

}  // namespace

Result<void> append_fill_blob(std::string& out, const Fill& fill) {
  if (auto ok = check_fill(fill); !ok) return ok;
  ByteWriter writer(out);
  writer.u8(kFillVersion);
  for (const std::uint8_t c : {fill.color.r, fill.color.g, fill.color.b, fill.color.a}) {
    writer.u8(c);
  }
  writer.f64(fill.max_gap_mm);
  writer.count(fill.loops.size());
  for (const FillLoop& loop : fill.loops) write_loop(writer, loop);
  return {};
}

Result<FillPtr> read_fill_blob(std::string_view bytes) {
  if (bytes.size() > kMaxFillBlobBytes) return invalid_data("is too large");
  ByteReader in(bytes);
  if (const std::uint8_t version = in.u8(); version != kFillVersion) {
    return fail(ErrorCode::kUnsupported, "has version " + std::to_string(version) +
                                             "; this program supports version " +
                                             std::to_string(kFillVersion));
  }
  Fill fill;
  for (std::uint8_t* c : {&fill.color.r, &fill.color.g, &fill.color.b, &fill.color.a}) {
    *c = in.u8();
  }
  fill.max_gap_mm = in.f64();
  const std::uint64_t loops = in.count();
  if (!in.has(loops, kMinLoopBytes)) return invalid_data("has fewer loops than it states");
  for (std::uint64_t i = 0; i < loops; ++i) {
    if (!read_loop(in, fill.loops.emplace_back())) {
      return invalid_data("has fewer points than it states");
    }
  }
  if (!in.ok() || in.left() > 0) return invalid_data("has unexpected bytes at the end");
  if (auto ok = check_fill(fill); !ok) return tl::unexpected(ok.error());
  return std::make_shared<const Fill>(std::move(fill));
}

}  // namespace felt
