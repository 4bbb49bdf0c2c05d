#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/stroke/arc_map.h"
#include "felt/tools/pull/strand.h"

namespace felt {

/// One stroke in the way of a round nib (R27; specification 5c, "Push"). The nib goes in steps of
/// at most half its radius. After each, as long as the point f of the stroke nearest to the pen p
/// is nearer than the radius, f goes to p - r n, n = (p - f)/|p - f|. So the stroke is parted from
/// outside and never drawn along; and since the pen is never within half a radius of it, it cannot
/// get to the other side.
///
/// What moves with f is its neighbourhood: with s the arc length in the stroke at the touch, a
/// place moves by w(s) = 1 - 3x^2 + 2x^3, x = |s - s_f|/R, of what f does, and the tangents turn as
/// the slope of w says. R is kReachRadii radii, and more as f is farther from where it was
/// (kReachPerDepth), so that a deep push makes a dale with slopes that the nib glides along, not a
/// slot that catches it. The influence is measured in the ink, not in what it has been stretched
/// to. Where it reaches, the stroke is divided into pieces of kPieceRadii radii.
class NibPush {
 public:
  static constexpr double kReachRadii = 3.0;
  static constexpr double kReachPerDepth = 1.25;
  static constexpr double kPieceRadii = 2.0;
  static constexpr int kReachTrials = 6;
  /// Steps that one motion is walked in. Of a motion that is longer than so many half radii the
  /// steps are longer, and what they jump over is caught on the way.
  static constexpr int kMostSteps = 64;
  /// Corrections after each step (specification 5c: up to 6), and how many more there may be where
  /// ink lies all round the nib; those leave some micrometres more than the radius.
  static constexpr int kExactCorrections = 6;
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
  /// The point of the stroke nearest to a place, and how far it has been pushed; nothing if it is
  /// farther than `within_mm`.
  struct Under {
    Point point;
    double displacement_mm = 0.0;
  };
  [[nodiscard]] std::optional<Under> under(Point p, double within_mm) const;
  /// Where the last move touched it, if it did.
  [[nodiscard]] const std::optional<Point>& contact() const noexcept { return contact_; }
  /// The stroke with what changed in good shape (refit.h), for the end; as clear of the nib at
  /// `pen` as it is now.
  [[nodiscard]] Result<Stroke> finished(Point pen) const;

 private:
  struct Nearest {
    StrandPlace place;
    Point point;
  };

  /// What a place of the stroke was in the stroke at the touch.
  struct Material {
    double s_mm = 0.0;        ///< arc length from its start
    double handles_mm = 0.0;  ///< both handles of the joint
  };

  /// Part of the motion that a joint makes, and its slope along the ink, 1/mm.
  struct Influence {
    double weight = 0.0, slope = 0.0;
  };

  [[nodiscard]] std::optional<Nearest> nearest_to(Point p, double within_mm) const;
  bool clear(Point p, Vec came_from);
  bool catch_jumped(Point from, Point to);
  bool displace(Nearest at, Point target);
  bool displace_within(double reach, const Nearest& at, Point target);
  bool divide_within(double s_mm, double reach_mm);
  void note_material();
  [[nodiscard]] double u_of(StrandPlace place) const noexcept;
  [[nodiscard]] Influence influence_at(int joint, double s_mm, double reach_mm) const;
  [[nodiscard]] std::array<double, 3> weights_at(int joint, const Influence& influence) const;

  Strand strand_;
  ArcMap map_;  // of the snapshot
  StrokePtr stroke_;
  Rect box_;
  double radius_mm_;
  std::vector<std::uint8_t> is_in_pieces_;  // by segment of the snapshot
  std::vector<Material> material_;          // by joint
  std::vector<double> weights_;             // room for displace()
  std::optional<Point> contact_;
};

/// True when a nib that goes straight from `from` to `to` meets the segment, by the same steps.
bool nib_meets(const Cubic& c, Point from, Point to, double radius_mm) noexcept;

}  // namespace felt
