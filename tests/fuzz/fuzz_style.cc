/// Draws any stroke with any style. The ink must be finite, bounded, the same every time, and
/// within the bounds of the stroke.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "felt/base/check.h"
#include "felt/render/styled_outline.h"

namespace felt {
namespace {

constexpr std::size_t kMaxSegments = 200;
/// The ink of a row has no bound but that of its dabs.
constexpr std::size_t kMaxRow = std::size_t{1} << 14;

/// Reads numbers from the input. After its end, all bytes are 0.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  [[nodiscard]] bool empty() const { return at_ >= size_; }
  std::uint8_t byte() { return empty() ? std::uint8_t{0} : data_[at_++]; }
  double between(double low, double high) { return low + (high - low) * byte() / 255.0; }
  std::string text(std::size_t count) {
    std::string out;
    for (std::size_t i = 0; i < count && !empty(); ++i) out += static_cast<char>(byte());
    return out;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_, at_ = 0;
};

/// Reads a style whose values are in the ranges of docs/formats/material.md.
StrokeStyle take_style(Bytes& in) {
  StrokeStyle style;
  const std::uint8_t what = in.byte();
  style.how.kind = static_cast<StyleKind>((what & 7U) % kStyleKinds.size());
  style.how.arrows = static_cast<StyleArrows>(what >> 3U & 3U);
  style.how.length = in.between(0.2, 50.0);
  style.how.gap = in.between(0.0, 50.0);
  style.how.thin = in.between(0.05, 1.0);
  style.how.arrow_length = in.between(0.5, 10.0);
  style.how.angle_deg = in.between(-90.0, 90.0);
  style.how.spacing_mm = in.between(0.3, 50.0);
  const std::string shape = in.text(in.byte());
  Result<StyleShape> read = read_style_shape(shape);
  if (read) style.how.shape = shape;
  style.shape = read ? *std::move(read) : read_style_shape(kLensShape).value();
  return style;
}

/// Reads a stroke, which may have any form that Stroke::create accepts.
Result<Stroke> take_stroke(Bytes& in) {
  constexpr double kScalesMm[] = {0.1, 0.01, 1.0, 10.0, 1e3, 1e5, 1e-3, 0.3};
  constexpr double kWidthsMm[] = {1.0, 0.05, 0.2, 3.0, 20.0, 100.0, 0.5, 8.0};
  const std::uint8_t form = in.byte();
  const double scale = kScalesMm[form & 7U], width = kWidthsMm[form >> 3U & 7U];
  StrokeData d;
  d.closed = (form & 64U) != 0;
  Point now{(form & 128U) != 0 ? 1e6 : 0.0, 0.0};
  d.points.push_back(now);
  d.widths.push_back({0.0, width});
  for (std::size_t n = 1; n <= kMaxSegments && !in.empty(); ++n) {
    for (int k = 0; k < 3; ++k) {
      now += scale * Vec{in.between(-128.0, 127.0), in.between(-128.0, 127.0)};
      d.points.push_back(now);
    }
    const std::uint8_t end = in.byte();
    d.joints.push_back((end & 1U) != 0 ? JointKind::kSmooth : JointKind::kCorner);
    d.widths.push_back(
        {static_cast<double>(n), std::max(0.05, width * (1.0 + (end >> 1U)) / 64.0)});
  }
  if (d.closed) {
    d.points.back() = d.points.front();
    d.widths.back().width_mm = d.widths.front().width_mm;
  } else if (!d.joints.empty()) {
    d.joints.pop_back();
  }
  return Stroke::create(std::move(d));
}

void check(const StyledInk& ink, const Rect& bounds) {
  FELT_CHECK(ink.outline.points.size() <= 2 * StrokeStyler::kMaxPoints);
  FELT_CHECK(ink.hatching.size() % 2 == 0 && !ink.outline.points.empty());
  FELT_CHECK(ink.outline.ends.back() == ink.outline.points.size());
  for (const Point p : ink.outline.points) FELT_CHECK(bounds.contains(p));  // not if it is NaN
  for (const Dab& dab : ink.hatching)
    FELT_CHECK(dab.radius_mm > 0.0 && bounds.contains(dab.center));
}

}  // namespace
}  // namespace felt

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace felt;
  Bytes in(data, size);
  const double tolerance_mm = in.between(0.002, 0.5);
  const StrokeStyle style = take_style(in);
  const Result<Stroke> stroke = take_stroke(in);
  if (!stroke) return 0;
  const Rect bounds = stroke->bounds();
  const double reach = std::max({-bounds.x0, -bounds.y0, bounds.x1, bounds.y1, 1.0});
  StrokeStyler first, second;
  const StyledInk& ink = first.ink(*stroke, style, tolerance_mm);
  check(ink, bounds.inflated(tolerance_mm + 1e-9 * reach));
  FELT_CHECK(second.ink(*stroke, style, tolerance_mm).outline.points == ink.outline.points);
  std::vector<Dab> dabs;
  flatten(*stroke, tolerance_mm, dabs);
  if (dabs.size() > kMaxRow) return 0;
  const std::vector<std::size_t> corners{dabs.size() / 2};
  const StyledInk& row =
      first.ink({dabs, corners, stroke->closed(), true, 1.0}, style, tolerance_mm);
  check(row, bounds.inflated(2.0 * tolerance_mm + 1e-9 * reach));
  return 0;
}
