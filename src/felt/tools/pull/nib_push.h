#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/tools/pull/strand.h"

namespace felt {

/// One stroke in the way of a round nib (R27; specification 5c, "Push"). The nib goes in steps of
/// at most half its radius. After each, as long as the point f of the stroke nearest to the pen p
/// is nearer than the radius, f goes to p - r n, n = (p - f)/|p - f|, by the weights of least
/// motion. So the stroke is parted from outside and never drawn along; and since the pen is never
/// within half a radius of it, it cannot get to the other side.
///
/// Where the nib first meets it the stroke is divided into pieces of kPieceRadii radii, so that
/// what moves is near the nib. They are its material: they stretch, but are not divided again, so
/// that a deep push stays wide at its tip.
class NibPush {
 public:
  static constexpr double kPieceRadii = 3.0;
  /// Steps that one motion is walked in. Of a motion that is longer than so many half radii the
  /// steps are longer, and what they jump over is caught on the way.
  static constexpr int kMostSteps = 64;
  /// Corrections after each step: 6 do (specification 5c); the rest is for ink that is all round.
  static constexpr int kCorrections = 24;
  /// A stroke is not divided into more segments than so.
  static constexpr int kMostSegments = 1000;
  /// Within this of the radius is at the radius, mm.
  static constexpr double kContactMm = 1e-7;

  NibPush(StrokePtr snapshot, double radius_mm);

  /// The pen went straight from `from` to `to`. `came_from`: unit direction from the stroke towards
  /// the pen for a pen that lies exactly on it; zero where it is not known. True when something
  /// moved. What would break an invariant is left as it was.
  bool move(Point from, Point to, Vec came_from = {});
  /// The stroke as it is now.
  [[nodiscard]] const StrokePtr& stroke() const noexcept { return stroke_; }
  /// Where the last move touched it, if it did.
  [[nodiscard]] const std::optional<Point>& contact() const noexcept { return contact_; }
  /// The stroke with what changed in good shape (refit.h), for the end.
  [[nodiscard]] Result<Stroke> finished() const;

 private:
  struct Nearest {
    StrandPlace place;
    Point point;
  };

  [[nodiscard]] std::optional<Nearest> deepest(Point p) const;
  bool clear(Point p, Vec came_from);
  bool catch_jumped(Point from, Point to);
  bool divide_at(int segment);
  bool displace(const Nearest& at, Point target);

  Strand strand_;
  StrokePtr stroke_;
  Rect box_;
  double radius_mm_;
  std::vector<std::uint8_t> is_in_pieces_;  // by segment of the snapshot
  std::optional<Point> contact_;
};

/// True when a nib that goes straight from `from` to `to` meets the segment, by the same steps.
bool nib_meets(const Cubic& c, Point from, Point to, double radius_mm) noexcept;

}  // namespace felt
