#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/stroke/arc_map.h"
#include "felt/tools/pull/strand.h"

namespace felt {

/// One stroke that a round nib pushes aside (R27; docs/design/editing.md#push). The nib moves in
/// steps of at most half its radius r. Let f be the point of the stroke nearest to the pen p. If f
/// is nearer than r after a step, f is moved to p - r n, n = (p - f)/|p - f|. This is repeated with
/// the new nearest point until the distance of that point is at least r. So the stroke is pushed
/// from outside and never dragged along. Because a step is at most half a radius, the pen never
/// comes nearer to the stroke than half a radius, so the nib cannot pass through the stroke.
///
/// The neighbourhood of f moves with it: a point moves by w(s) times the displacement of f, with
/// w(s) = 1 - 3x^2 + 2x^3, x = |s - s_f|/R, and s the arc length in the stroke at the touch. The
/// tangents turn with the slope of w. R is kReachRadii radii plus kReachPerDepth times the total
/// displacement of f. So a deep push makes a wide dent that the nib can glide out of, not a narrow
/// slot that catches it. Arc lengths are those of the original ink, before it is stretched. Within
/// the reach the stroke is divided into pieces of kPieceRadii radii.
class NibPush {
 public:
  static constexpr double kReachRadii = 3.0;
  static constexpr double kReachPerDepth = 1.25;
  static constexpr double kPieceRadii = 2.0;
  static constexpr int kReachTrials = 6;
  /// Maximum number of steps of one motion. If a motion is longer than kMaxSteps half radii, its
  /// steps are longer, and ink that they jump over is found separately.
  static constexpr int kMaxSteps = 64;
  /// Usual and maximum number of corrections after each step (docs/design/editing.md#push: up to
  /// 6). More than kExactCorrections are needed only if ink lies all around the nib. These
  /// additional corrections move the ink some micrometres farther than the radius.
  static constexpr int kExactCorrections = 6;
  static constexpr int kCorrections = 24;
  /// Maximum number of segments into which a stroke is divided.
  static constexpr int kMaxSegments = 1000;
  /// A distance that differs from the radius by at most this counts as equal to it, mm.
  static constexpr double kContactMm = 1e-7;

  NibPush(StrokePtr snapshot, double radius_mm);

  /// Moves the nib straight from `from` to `to`. `came_from` is the unit direction from the stroke
  /// towards the pen, used if the pen lies exactly on the stroke; zero if unknown. Returns true if
  /// the stroke moved. Ignores a motion that would break an invariant.
  bool move(Point from, Point to, Vec came_from = {});
  /// Moves the nib as move() does, but leaves stroke() as it is until settle() is called, so that
  /// several steps and pulls make one stroke. Returns true if the ink moved. `max_steps` is for a
  /// motion that is a part of a longer one.
  bool step(Point from, Point to, Vec came_from, int max_steps = kMaxSteps);
  /// Pushes the ink out from under a nib that rests at p, `room_mm` farther than the radius.
  /// Returns true if the ink moved. Call settle() afterwards.
  bool clear(Point p, Vec came_from, double room_mm);
  /// Moves the point with this parameter of the snapshot to `target`, and the ink around it as if
  /// the nib had pushed it there. `pins` are the parameters on both sides at which the ink stays;
  /// NaN if there is none. Returns false if the ink cannot follow. Call settle() afterwards.
  bool pull(double u, Point target, std::pair<double, double> pins);
  /// Makes stroke() the ink after the last steps and pulls. If that breaks an invariant, undoes
  /// them and returns false.
  bool settle();
  /// Undoes the steps and pulls since the last settle().
  void undo();
  /// Returns the position of the point with this parameter of the snapshot.
  [[nodiscard]] Point position(double snapshot_u) const noexcept;
  /// Returns the stroke as pushed so far.
  [[nodiscard]] const StrokePtr& stroke() const noexcept { return stroke_; }
  /// The point of the stroke nearest to a position, and how far it has been pushed.
  struct Under {
    Point point;
    double displacement_mm = 0.0;
  };
  [[nodiscard]] std::optional<Under> under(Point p, double within_mm) const;
  /// Returns the point at which the last move touched the stroke, or nullopt if the move did not
  /// touch it.
  [[nodiscard]] const std::optional<Point>& contact() const noexcept { return contact_; }
  /// Returns the final stroke, with its changed segments refitted (refit.h). The refit does not
  /// move the stroke under a nib at `pen`: if it would, the refitted stroke is pushed again, or the
  /// stroke is not refitted.
  [[nodiscard]] Result<Stroke> finished(Point pen) const;

 private:
  struct Nearest {
    StrandPlace place;
    Point point;
  };

  /// Properties of a joint in the stroke at the touch.
  struct Material {
    double s_mm = 0.0;        ///< arc length from the start of the stroke
    double handles_mm = 0.0;  ///< sum of the lengths of both handles of the joint
  };

  /// The fraction of the motion by which a joint moves, and its slope along the ink, 1/mm.
  struct Influence {
    double weight = 0.0, slope = 0.0;
  };

  [[nodiscard]] std::optional<Nearest> nearest_to(Point p, double within_mm) const;
  void cut(double snapshot_u);
  [[nodiscard]] bool is_pinned() const noexcept {
    return pin_before_mm_ < std::numeric_limits<double>::max() ||
           pin_after_mm_ < std::numeric_limits<double>::max();
  }
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
  std::vector<std::uint8_t> is_in_pieces_;  // true for divided segments of the snapshot
  std::vector<Material> material_;          // by joint
  std::vector<double> weights_;             // buffer of displace_within()
  /// Arc lengths from the displaced point to the pins of pull(), before and after it.
  double pin_before_mm_ = std::numeric_limits<double>::infinity();
  double pin_after_mm_ = std::numeric_limits<double>::infinity();
  std::optional<Strand> settled_;  // the ink at the last settle(), if it has moved since
  std::optional<Point> contact_;
};

/// Returns true if a nib that moves straight from `from` to `to`, in the same steps as
/// NibPush::move(), touches the segment.
bool nib_meets(const Cubic& c, Point from, Point to, double radius_mm) noexcept;

}  // namespace felt
