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

/// The kind of a joint: how two neighbouring segments meet there, or that the stroke ends there
/// (docs/design/strokes.md#stroke-model).
enum class JointKind : std::uint8_t {
  kSmooth,  ///< both tangents are collinear: G1 within 1e-6 degrees (I2)
  kCorner,  ///< the direction changes here; each side has its own tangent
  kEnd,     ///< the first or last point of an open stroke
};

/// Returns the default tone of ink that has no tone of its own, because its file comes from another
/// program or was written before tone existed. This tone grows linearly from 0 at a width of 0.3 mm
/// to 1 at 6 mm, the pencil's smallest and largest width.
constexpr double tone_of_width(double width_mm) noexcept {
  const double share = (width_mm - 0.3) / (6.0 - 0.3);
  return share > 0.0 ? (share < 1.0 ? share : 1.0) : 0.0;  // NaN: 0
}

/// One breakpoint of the width profile [Paper eq. 3]: the full width `width_mm` at stroke parameter
/// `u` = segment index + t. The width is linear in u between breakpoints.
///
/// `tone` is the amount of medium applied at `u`, from 0 (almost nothing) to 1 (the maximum). It
/// preserves the effect of pressure and tilt, which the width alone does not. MediumLook defines
/// how the tone affects the opacity and the depth to which the medium reaches into the relief. A
/// wet medium with a constant opacity, such as `ink-pen`, looks the same at every tone. Like the
/// width, the tone is linear between breakpoints. A breakpoint made without a tone has the default
/// tone of its width.
struct WidthKnot {
  double u = 0.0;
  double width_mm = 0.0;
  double tone = tone_of_width(width_mm);

  friend constexpr bool operator==(const WidthKnot&, const WidthKnot&) noexcept = default;
};

/// A colour in 8-bit sRGB with straight (not premultiplied) alpha.
struct Rgba {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;

  friend constexpr bool operator==(const Rgba&, const Rgba&) noexcept = default;
};

/// Limits of the stroke model (docs/design/strokes.md#invariants).
inline constexpr double kMinWidthMm = 0.05;
inline constexpr double kMinSegmentMm = 0.05;
inline constexpr double kSmoothJointMaxDeg = 1e-6;

/// The data of a stroke as a plain value, which the caller fills in and passes to `Stroke::create`.
struct StrokeData {
  /// The 3n + 1 control points of n joined cubics. Joints are stored once, so neighbours share them
  /// exactly (I1). A closed stroke repeats its first point as the last, bit for bit.
  std::vector<Point> points;
  /// The kinds of the joints: n - 1 for an open stroke, n for a closed one (the last is the joint
  /// at u = 0 = n). Contains only kSmooth and kCorner.
  std::vector<JointKind> joints;
  bool closed = false;
  /// The breakpoints, with u strictly increasing from 0 to n (I6).
  std::vector<WidthKnot> widths;
  std::string medium = "pencil";
  Rgba color{};

  friend bool operator==(const StrokeData&, const StrokeData&) = default;
};

/// A finished variable-width stroke: joined cubic Bezier segments and a width profile. It is
/// immutable, so threads can share it as `std::shared_ptr<const Stroke>`; an edit makes a new one.
class Stroke {
 public:
  /// Makes a stroke. Fails if the data breaks an invariant I1-I7; the error names the invariant and
  /// the location.
  static Result<Stroke> create(StrokeData data);

  /// Returns the number of cubic segments, at least 1.
  [[nodiscard]] int segment_count() const noexcept {
    return static_cast<int>(data_.points.size() / 3);
  }
  /// Returns segment i. Requires 0 <= i < segment_count().
  [[nodiscard]] Cubic segment(int i) const noexcept;
  /// Returns the kind of the joint before segment i; i = segment_count() is the end of the stroke.
  [[nodiscard]] JointKind joint(int i) const noexcept;
  [[nodiscard]] bool closed() const noexcept { return data_.closed; }
  [[nodiscard]] std::span<const WidthKnot> widths() const noexcept { return data_.widths; }
  [[nodiscard]] const std::string& medium() const noexcept { return data_.medium; }
  [[nodiscard]] Rgba color() const noexcept { return data_.color; }
  /// Returns all data, to make a changed copy.
  [[nodiscard]] const StrokeData& data() const noexcept { return data_; }

  /// Returns the position at u, clamped to [0, n].
  [[nodiscard]] Point position(double u) const noexcept;
  /// Returns the width at u by linear interpolation [Paper eq. 3]; u is clamped to [0, n].
  [[nodiscard]] double width_mm(double u) const noexcept;
  /// Returns the tone at u, 0..1, by linear interpolation; u is clamped to [0, n].
  [[nodiscard]] double tone(double u) const noexcept;
  /// Returns the bounds of the inked area: the exact bounds of the curve, expanded by half of the
  /// largest width.
  [[nodiscard]] Rect bounds() const noexcept;

  friend bool operator==(const Stroke&, const Stroke&) = default;

 private:
  explicit Stroke(StrokeData data) noexcept : data_(std::move(data)) {}
  StrokeData data_;
};

/// Checks the invariants I1 to I7 of the stroke model (docs/design/strokes.md#invariants). This is
/// the only function that checks them; `Stroke::create` and every test call it. Fails with the name
/// and the location of the first broken invariant.
Result<void> check_invariants(const StrokeData& data);

/// One of the two ends of an open stroke.
enum class StrokeTip : std::uint8_t { kStart, kEnd };

constexpr StrokeTip opposite(StrokeTip tip) noexcept {
  return tip == StrokeTip::kStart ? StrokeTip::kEnd : StrokeTip::kStart;
}

/// Returns the first or last point of a stroke.
inline Point tip_point(const Stroke& stroke, StrokeTip tip) noexcept {
  return tip == StrokeTip::kStart ? stroke.data().points.front() : stroke.data().points.back();
}

/// Returns the unit direction in which the ink would continue beyond the tip.
inline Vec tip_direction(const Stroke& stroke, StrokeTip tip) noexcept {
  return tip == StrokeTip::kStart ? -tangent(stroke.segment(0), 0.0)
                                  : tangent(stroke.segment(stroke.segment_count() - 1), 1.0);
}

}  // namespace felt
