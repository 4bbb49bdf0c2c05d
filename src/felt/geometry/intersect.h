#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "felt/geometry/cubic.h"

namespace felt {

/// Two points on cubics closer than this are one place, mm.
inline constexpr double kMeetMm = 1e-9;

/// A place where two cubics meet.
struct Crossing {
  enum class Kind : std::uint8_t {
    kCross,    ///< they pass through each other
    kTouch,    ///< they meet without being seen to pass: tangents, cusps, ends on the other
    kOverlap,  ///< an end of a part that both share
  };
  double t1 = 0.0;  ///< on the first
  double t2 = 0.0;  ///< on the second
  Point point;      ///< on the first
  Kind kind = Kind::kCross;
};

/// The places where two cubics meet, ascending in t1, then t2.
struct Crossings {
  /// Two cubics cross at most nine times (Bezout); the rest is for touches.
  static constexpr std::size_t kMost = 16;

  std::array<Crossing, kMost> places{};
  std::size_t count = 0;
  /// False when the work or the room was used up: then some may be missing.
  bool complete = true;
  int pairs = 0;  ///< of pieces looked at

  [[nodiscard]] const Crossing* begin() const noexcept { return places.data(); }
  [[nodiscard]] const Crossing* end() const noexcept { return places.data() + count; }
};

/// Limit on the work of one call: pairs of pieces, each 0.1 us or less. Transversal crossings need
/// 10 to 60 pairs; curves that run within a micrometre of each other need more.
inline constexpr int kIntersectPairs = 4096;

/// All places where two cubics meet, ends included.
///
/// How it is found. Pairs of pieces wait on a fixed stack; the larger piece of a pair is halved.
///  1. A pair is done when its hulls are apart: by their boxes, or by the strip along the chord of
///     either one (fat line; Sederberg and Nishita 1990), which narrows with the square of the
///     size.
///  2. When every direction of one hodograph hull is to the same side of every one of the other,
///     f(s) - g(t) is injective on the pair: it holds at most one crossing. Newton finds it, or the
///     pair is halved on until the hulls are apart.
///  3. Pieces that are straight to a quarter of kMeetMm are compared as straight segments: what is
///     tangent ends here, some 1e-4 mm long, and neighbours of the same touch become one place.
/// Curves that share a part (copies, lines upon lines) would survive at every size: this is asked
/// first. If ends of one lie on the other and the curves agree between them at more places than
/// Bezout allows, the two ends of the shared part are reported as kOverlap, nothing within it, and
/// the search goes on with the rest.
///
/// Promise: the two points of each place are within kMeetMm (and 1e-13 of the coordinates); every
/// transversal crossing is there; what comes within half of kMeetMm is there as a touch. Crossings
/// nearer to each other than a touch is long may be one touch. No recursion, no allocation.
/// Nothing for a coordinate that is not finite.
Crossings intersections(const Cubic& first, const Cubic& second,
                        int most_pairs = kIntersectPairs) noexcept;

/// The place where a cubic crosses itself, t1 < t2; there is at most one. In closed form: with
/// p = t1 + t2 and q = t1 t2, (f(t2) - f(t1)) / (t2 - t1) = 0 is linear in p and p^2 - q. A closed
/// loop meets itself at (0, 1). A cusp does not cross, nor does a straight cubic that runs back
/// over itself.
std::optional<Crossing> self_intersection(const Cubic& c) noexcept;

}  // namespace felt
