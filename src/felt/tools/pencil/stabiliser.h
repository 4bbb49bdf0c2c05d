#pragma once

#include <cstdint>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/haptics/bricks/stabiliser.h"

namespace felt {

/// What lies between the pen and the point that draws, the nib.
enum class StabiliserKind {
  kOff,      ///< the nib is the pen
  kInertia,  ///< the nib is a mass on a spring (Keefe 2007; Snibbe 1998: sprung mass)
  kTowed,    ///< the nib hangs on a rope and follows when that is taut
};

struct StabiliserOptions {
  StabiliserKind kind = StabiliserKind::kOff;
  double mass_g = 50.0;    ///< kInertia
  double length_mm = 4.0;  ///< kTowed: of the rope

  friend bool operator==(const StabiliserOptions&, const StabiliserOptions&) noexcept = default;
};

/// The mass of kInertia. Its drag makes it critically damped, B + c = 2 sqrt(K m), for a nib that
/// overshoots would draw loops; it trails by c v/K, 2 mm at 100 mm/s for 50 g.
InertiaOptions inertia_of(const StabiliserOptions& options) noexcept;
/// The rope of kTowed.
TowOptions tow_of(const StabiliserOptions& options) noexcept;

/// Steadies a hand: moves the nib with the same functions that make the force in the hand, so that
/// what is drawn and what is felt agree. The pen is taken to move evenly between samples, in steps
/// of at most 1 ms: nearly the same line at 133 Hz as at 1 kHz. One thread.
class Stabiliser {
 public:
  explicit Stabiliser(const StabiliserOptions& options = {}) noexcept : options_(options) {}

  void begin(Point pen, std::int64_t time_ns) noexcept;
  /// The pen is here now; returns the nib. Bounded, whatever the times say.
  Point update(Point pen, std::int64_t time_ns) noexcept;
  [[nodiscard]] Point nib() const noexcept { return nib_.position; }

  /// A point of the nib's way.
  struct Step {
    Point nib;
    std::int64_t time_ns = 0;
  };
  /// Pen-up: the rest of the line, as the nib would draw it while the pen rests where it is, since
  /// people expect ink to reach the pen. The last point is the pen. At most 2000 points.
  void finish(std::vector<Step>& rest);

 private:
  void follow(Point pen, Vec pen_velocity_mm_per_s, double dt_s) noexcept;

  StabiliserOptions options_;
  Point pen_;
  Follower nib_;
  std::int64_t time_ns_ = 0;
};

}  // namespace felt
