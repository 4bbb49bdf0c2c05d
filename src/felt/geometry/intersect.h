#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "felt/geometry/cubic.h"

namespace felt {

/// Distance in mm below which two points count as equal: two cubics meet if a point of the first is
/// within kMeetMm of a point of the second.
inline constexpr double kMeetMm = 1e-9;

/// A point where two cubics meet.
struct Crossing {
  enum class Kind : std::uint8_t {
    kCross,    ///< they pass through each other
    kTouch,    ///< they meet, but no crossing is proven, for example at tangents, cusps and ends
    kOverlap,  ///< an end of a part that both cubics share
  };
  double t1 = 0.0;  ///< parameter on the first cubic
  double t2 = 0.0;  ///< parameter on the second cubic
  Point point;      ///< the point on the first cubic
  Kind kind = Kind::kCross;
};

/// The points where two cubics meet, in ascending order of t1, then t2.
struct Crossings {
  /// Two cubics cross at most nine times (Bezout). The other entries are for touches.
  static constexpr std::size_t kMax = 16;

  std::array<Crossing, kMax> places{};
  std::size_t count = 0;
  /// False if the limit on the work or on the number of points was reached, so some points may be
  /// missing.
  bool complete = true;
  int pairs = 0;  ///< pairs of pieces examined

  [[nodiscard]] const Crossing* begin() const noexcept { return places.data(); }
  [[nodiscard]] const Crossing* end() const noexcept { return places.data() + count; }
};

/// Limit on the work of one call, in pairs of pieces; one pair takes 0.1 us or less. Transversal
/// crossings need 10 to 60 pairs; curves that run within a micrometre of each other need more.
inline constexpr int kIntersectPairs = 4096;

/// Returns all points where two cubics, f and g, meet, including at their ends.
///
/// Algorithm: pairs of pieces wait on a fixed stack; the larger piece of a pair is halved.
///  1. A pair is discarded if its hulls are disjoint. This is tested with their boxes and with the
///     strip along the chord of either piece (fat line; Sederberg and Nishita 1990). The width of
///     the strip falls with the square of the piece's length.
///  2. The hodograph hull of a piece bounds its directions of travel. If every direction of one
///     hull is on the same side of every direction of the other hull, f(s) - g(t) is injective on
///     the pair, so the pair has at most one crossing. Newton's method looks for this crossing. If
///     it finds none, the pair is halved further, until the hulls are disjoint.
///  3. Pieces that differ from their chords by at most a quarter of kMeetMm are compared as
///     straight segments. Where the curves are tangent, pieces are about 1e-4 mm long at this step;
///     neighbouring results of the same touch are merged into one.
/// Curves that share a part (copies, lines on top of lines) would never be discarded, so overlaps
/// are tested first. If ends of the curves lie on the other curve, and the curves agree between
/// these ends at more points than Bezout allows, they share the part between them. The two ends of
/// this part are reported as kOverlap; points within it are not reported. The search then continues
/// with the other parts.
///
/// Guarantees: f(t1) and g(t2) of each result are within kMeetMm (plus 1e-13 of the coordinates) of
/// each other; every transversal crossing is found; curves that come within half of kMeetMm of each
/// other are found as a touch. Results are merged into one if they are within 1e-7 mm of each other
/// along both curves, or if a touch extends from one to the other. No recursion, no allocation.
/// Returns no points if a coordinate is not finite.
Crossings intersections(const Cubic& first, const Cubic& second,
                        int max_pairs = kIntersectPairs) noexcept;

/// Returns the point where a cubic crosses itself (at most one), with t1 < t2. Uses a closed form:
/// the equation (f(t2) - f(t1)) / (t2 - t1) = 0 is linear in p and p^2 - q, where p = t1 + t2 and q
/// = t1 t2. If the ends of the cubic coincide, t1 = 0 and t2 = 1. Returns nullopt for a cusp and
/// for a straight cubic that runs back over itself.
std::optional<Crossing> self_intersection(const Cubic& c) noexcept;

}  // namespace felt
