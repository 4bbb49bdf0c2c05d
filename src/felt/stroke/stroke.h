#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/cubic.h"
#include "felt/geometry/rect.h"

namespace felt {

/// How two neighbouring segments meet, or that a stroke ends there (specification section 4).
enum class JointKind : std::uint8_t {
  kSmooth,  ///< both tangents are collinear: G1 to 1e-6 degrees (I2)
  kCorner,  ///< the ink turns here; each side has its own tangent
  kEnd,     ///< the first or last point of an open stroke
};

/// The tone of ink of which only the width is known (drawings of before there was tone, foreign
/// files): 0 at 0.3 mm, 1 at 6 mm, the pencil's range of widths.
constexpr double tone_of_width(double width_mm) noexcept {
  const double share = (width_mm - 0.3) / (6.0 - 0.3);
  return share > 0.0 ? (share < 1.0 ? share : 1.0) : 0.0;  // NaN: 0
}

/// One breakpoint of the width profile [Paper eq. 3]: full width `width_mm` at stroke parameter
/// `u` = segment index + t. Linear in u between breakpoints.
///
/// `tone` tells how much of the medium was laid on there, 0 (a breath) .. 1 (all it gives): what
/// remains of pressure and lean once they became a width. What a medium makes of it (opacity, how
/// deep it goes into the relief) is MediumLook; wet ink takes no notice. Linear like the width.
/// A breakpoint made without a tone has that of its width.
struct WidthKnot {
  double u = 0.0;
  double width_mm = 0.0;
  double tone = tone_of_width(width_mm);

  friend constexpr bool operator==(const WidthKnot&, const WidthKnot&) noexcept = default;
};

/// 8-bit sRGB with straight alpha.
struct Rgba {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;

  friend constexpr bool operator==(const Rgba&, const Rgba&) noexcept = default;
};

/// Limits of the stroke model (specification section 4, invariants I2, I4, I5).
inline constexpr double kMinWidthMm = 0.05;
inline constexpr double kMinSegmentMm = 0.05;
inline constexpr double kSmoothJointMaxDeg = 1e-6;

/// Everything a stroke is made of, as a plain value that can be filled in and handed to
/// `Stroke::create`.
struct StrokeData {
  /// Control points of n joined cubics: 3n + 1 of them. Joints are stored once, so neighbours
  /// share them exactly (I1). A closed stroke repeats its first point as the last, bit for bit.
  std::vector<Point> points;
  /// n - 1 kinds for an open stroke, n for a closed one (the last is the joint at u = 0 = n).
  /// Only kSmooth and kCorner.
  std::vector<JointKind> joints;
  bool closed = false;
  /// Breakpoints, u strictly increasing from 0 to n (I6).
  std::vector<WidthKnot> widths;
  std::string material = "pencil";
  Rgba color{};

  friend bool operator==(const StrokeData&, const StrokeData&) = default;
};

/// A finished variable-width stroke: joined cubic Bezier segments and a width profile. Immutable
/// once made, hence freely shared between threads as `std::shared_ptr<const Stroke>`; an edit
/// makes a new one.
class Stroke {
 public:
  /// Makes a stroke, or says which invariant I1-I7 the data breaks and where.
  static Result<Stroke> create(StrokeData data);

  /// Number of cubic segments, at least 1.
  [[nodiscard]] int segment_count() const noexcept {
    return static_cast<int>(data_.points.size() / 3);
  }
  /// Segment i. Requires 0 <= i < segment_count().
  [[nodiscard]] Cubic segment(int i) const noexcept;
  /// Kind of the joint before segment i; i = segment_count() is the end of the stroke.
  [[nodiscard]] JointKind joint(int i) const noexcept;
  [[nodiscard]] bool closed() const noexcept { return data_.closed; }
  [[nodiscard]] std::span<const WidthKnot> widths() const noexcept { return data_.widths; }
  [[nodiscard]] const std::string& material() const noexcept { return data_.material; }
  [[nodiscard]] Rgba color() const noexcept { return data_.color; }
  /// The whole value, for copying, changing and making another.
  [[nodiscard]] const StrokeData& data() const noexcept { return data_; }

  /// Position at u, clamped to [0, n].
  [[nodiscard]] Point position(double u) const noexcept;
  /// Width at u by linear interpolation [Paper eq. 3], clamped to [0, n].
  [[nodiscard]] double width_mm(double u) const noexcept;
  /// Tone at u, 0..1, likewise.
  [[nodiscard]] double tone(double u) const noexcept;
  /// Tight bounds of the inked area: curve bounds widened by half the largest width.
  [[nodiscard]] Rect bounds() const noexcept;

  friend bool operator==(const Stroke&, const Stroke&) = default;

 private:
  explicit Stroke(StrokeData data) noexcept : data_(std::move(data)) {}
  StrokeData data_;
};

/// The one place where the invariants of the stroke model are checked: I1-I6 of the specification
/// and I7, tones in 0..1. `Stroke::create` and every test call it. Returns the first broken one,
/// named, with the place.
Result<void> check_invariants(const StrokeData& data);

/// One of the two ends of an open stroke.
enum class StrokeTip : std::uint8_t { kStart, kEnd };

constexpr StrokeTip opposite(StrokeTip tip) noexcept {
  return tip == StrokeTip::kStart ? StrokeTip::kEnd : StrokeTip::kStart;
}

/// The first or last point of a stroke.
inline Point tip_point(const Stroke& stroke, StrokeTip tip) noexcept {
  return tip == StrokeTip::kStart ? stroke.data().points.front() : stroke.data().points.back();
}

/// Unit direction in which the ink would go on beyond the tip.
inline Vec tip_direction(const Stroke& stroke, StrokeTip tip) noexcept {
  return tip == StrokeTip::kStart ? -tangent(stroke.segment(0), 0.0)
                                  : tangent(stroke.segment(stroke.segment_count() - 1), 1.0);
}

}  // namespace felt
