#pragma once

#include <cstdint>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/haptics/bricks/stabiliser.h"

namespace felt {

/// The mechanism between the pen and the nib. The nib is the point that draws.
enum class StabiliserKind {
  kOff,      ///< the nib is the pen
  kInertia,  ///< the nib is a mass on a spring (Keefe 2007; Snibbe 1998: sprung mass)
  kTowed,    ///< the pen tows the nib on a rope
};

struct StabiliserOptions {
  StabiliserKind kind = StabiliserKind::kOff;
  double mass_g = 50.0;    ///< kInertia
  double length_mm = 4.0;  ///< kTowed: length of the rope

  friend bool operator==(const StabiliserOptions&, const StabiliserOptions&) noexcept = default;
};

/// Returns the options of kInertia. Let K and B be the stiffness and damping of the spring between
/// pen and nib, and m the mass. The drag c is chosen so that the mass is at least critically
/// damped, B + c >= 2 sqrt(K m), because a nib that overshoots would draw loops. At the speed v the
/// nib trails by c v/K: 2 mm at 100 mm/s for 50 g.
InertiaOptions inertia_of(const StabiliserOptions& options) noexcept;
/// Returns the options of kTowed.
TowOptions tow_of(const StabiliserOptions& options) noexcept;

/// Computes the steadied line: it moves the nib with the same functions that compute the force, so
/// that the line and the force agree. The pen is assumed to move uniformly between samples, in
/// steps of at most 1 ms, so that 133 Hz gives nearly the same line as 1 kHz. Not thread-safe.
class Stabiliser {
 public:
  explicit Stabiliser(const StabiliserOptions& options = {}) noexcept : options_(options) {}

  void begin(Point pen, std::int64_t time_ns) noexcept;
  /// Moves the pen and returns the position of the nib. The work is bounded for any times.
  Point update(Point pen, std::int64_t time_ns) noexcept;
  [[nodiscard]] Point nib() const noexcept { return nib_.position; }

  /// A point of the nib's path.
  struct Step {
    Point nib;
    std::int64_t time_ns = 0;
  };
  /// Ends the line at pen-up. Sets `rest` to the remaining path of the nib to the resting pen,
  /// because users expect ink to reach the pen. The last point is the position of the pen. `rest`
  /// gets at most 2000 points.
  void finish(std::vector<Step>& rest);

 private:
  void follow(Point pen, Vec pen_velocity_mm_per_s, double dt_s) noexcept;

  StabiliserOptions options_;
  Point pen_;
  Follower nib_;
  std::int64_t time_ns_ = 0;
};

}  // namespace felt
