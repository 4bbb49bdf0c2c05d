#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "felt/geometry/point.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// How stiff a guide of a drawing is across its path.
struct GuideSpring {
  double n_per_m = 600.0, damping_n_s_per_m = 3.0;
};

/// The force of a guide as a function of the distance D from its path
/// (docs/design/forces.md#guides): the same function as that of a snap target.
struct GuideLaw {
  /// The size of the force: a spring up to `core_mm`, constant up to radius_mm - rim_mm (the
  /// capture width), zero from radius_mm on. The damping acts only across the path.
  WellShape well;
  double dead_mm = 0.0;  ///< distance within which there is no force
  /// If true, the force points away from the path.
  bool pushes_away = false;
  double blur_mm = 0.5;    ///< how far corners of the path are rounded
  double window_mm = 9.5;  ///< how far along the path points count, from the position of the pen
  double lead_n = 0.0;     ///< largest force along the path, towards its end
  double lead_n_s_per_m = 0.0;  ///< that force divided by how much too slow the pen is
  double rise_s = 0.15;         ///< time in which the force grows from zero
  /// If true, the path is an edge: from kEdgeMm before it on, it pushes to GuidePiece::free_side.
  bool is_edge = false;
  static constexpr double kEdgeMm = 0.25;
  /// A click: a brake against the movement, N, for 30 ms when the guide begins to hold the pen.
  double click_n = 0.0;

  /// Returns the law of a groove: 300 N/m, at most 0.8 N, capture width 3 mm. `strength`, 0 to 1,
  /// multiplies all forces.
  static GuideLaw groove(double strength) noexcept;
  /// Returns the law of a force away from the path: 67 N/m, at most 0.2 N.
  static GuideLaw error_amplifying(double strength) noexcept;
  /// Returns the law of a groove that also leads the pen along the path, with at most 0.2 N.
  static GuideLaw teacher(double strength) noexcept;
  /// Returns the law of a guide of a drawing: a stiffer groove with the same force and width.
  static GuideLaw line(double strength, const GuideSpring& spring = {}) noexcept;
  /// Returns the law of a node of a grid or a ray of a protractor: 300 N/m, at most 0.3 N, smaller
  /// in proportion if `radius_mm` is less than kTickMm.
  static GuideLaw tick(double strength, double radius_mm) noexcept;
  static constexpr double kTickMm = 2.0, kTickN = 0.3;

  /// Returns the energy, mJ, that the force takes from the hand when the pen moves from the path to
  /// a distance from it; negative if the force pushes away.
  [[nodiscard]] double potential_mj(double distance_mm) const noexcept;
};

/// The piece of a path near the pen: points at equal distances along the path. A piece of one point
/// attracts the pen from all sides.
struct GuidePiece {
  static constexpr std::size_t kPoints = 40;
  static constexpr double kSpacingMm = 0.5;

  std::array<Point, kPoints> points{};
  std::array<float, kPoints> speeds_mm_per_s{};  ///< of the teacher; 0 without a teacher
  std::size_t count = 0;                         ///< 0: no guide
  double spacing_mm = kSpacingMm;
  double at_mm = 0.0;  ///< position of the pen along the path, from points[0]
  double gain = 1.0;   ///< 0..1, multiplies all forces; must change slowly
  /// For an edge: 1 if the side without force is that of perp() of the path's direction, else -1.
  double free_side = 1.0;
  /// Changes when the piece belongs to another part of the path than before, or to another path.
  /// Then the force starts again from zero.
  std::uint32_t hold = 0;
};

/// Guides the pen along a path, or pushes it away from the path (docs/design/forces.md#guides).
/// With the points p_i of the piece, their distances d_i from the pen, the blur s and the spacing
/// c:
///
///   w_i = S(i) exp(-d_i^2 / (2 s^2)),   q = sum w_i p_i / sum w_i
///   D^2 = -2 s^2 ln(sum w_i c / (s sqrt(2 pi)))
///   F   = -f(D)/D (pen - q)             f: GuideLaw::well
///
/// Next to a straight path, D is the distance from it, q is its nearest point, and F has no
/// component along the path. In corners, the nearest point would jump from one side to the other; q
/// moves smoothly. F has the potential f integrated up to D. S is 1 around the pen and decreases to
/// 0 at GuideLaw::window_mm along the path, so that the force is also continuous while the piece
/// moves.
///
/// The force begins when the pen touches within the capture width, and grows from zero within 150
/// ms (GuideLaw::rise_s). If the pen leaves the guide (D > radius), the force ends. It grows from
/// zero again when the pen returns to the capture width. So a guide never pulls suddenly, and
/// leaving it costs more energy than returning gives. A force that points away acts without this
/// rule, because otherwise coming back would cost nothing, and a loop would gain energy.
///
/// An edge acts only on a pen that has been on its free side during this touch, and again after it
/// was left. D counts from GuideLaw::kEdgeMm before the path, and F points to the free side.
///
/// The force of a teacher along the path, lead_n_s_per_m (v_teacher - v_pen), is never negative: a
/// pen that is faster than the teacher is not braked.
class Guide {
 public:
  static constexpr bool kIsGuide = true;  // GuideForce
  static constexpr double kFallS = 0.03;  ///< time in which it ends after the pen is lifted

  Guide(const GuideLaw& law, const GuidePiece& piece) noexcept : law_(law), piece_(piece) {}
  /// Makes a guide without force.
  Guide() noexcept = default;

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  /// Returns the largest stiffness: that of the core, or, for a force that pushes away, that of the
  /// rim and of the middle between two parts of the path.
  [[nodiscard]] Slopes slopes() const noexcept;
  /// Returns D at a point of the page, mm; infinity without a piece.
  [[nodiscard]] double distance_mm(Point pen) const noexcept;

  /// Returns the point q of the path, and the largest force on a pen at rest, N, for a point of the
  /// page; that point itself and 0 without a piece.
  [[nodiscard]] Point nearest(Point pen) const noexcept;
  [[nodiscard]] double pull_n(Point pen) const noexcept;

  [[nodiscard]] const GuideLaw& law() const noexcept { return law_; }
  [[nodiscard]] const GuidePiece& piece() const noexcept { return piece_; }

 private:
  /// The path as seen from the pen.
  struct Near {
    double distance_mm = 0.0;     // D
    Vec offset{};                 // pen - q
    Vec along{};                  // mean direction of the path; shorter than 1 in corners
    double speed_mm_per_s = 0.0;  // of the teacher
  };

  [[nodiscard]] Near near(Point pen) const noexcept;
  [[nodiscard]] double window(std::size_t i) const noexcept;
  [[nodiscard]] double reach_mm(const Near& near) const noexcept;
  [[nodiscard]] Vec edge_n(const Near& near, Vec velocity, double share) const noexcept;
  [[nodiscard]] Vec click_n(Vec velocity, double share) const noexcept;
  [[nodiscard]] double held_share(bool is_down, double reach_mm,
                                  ForceMemory& memory) const noexcept;
  [[nodiscard]] Vec across_n(const Near& near, Vec velocity, double share) const noexcept;
  [[nodiscard]] Vec lead_n(const Near& near, Vec velocity) const noexcept;

  GuideLaw law_;
  GuidePiece piece_;
};

}  // namespace felt
