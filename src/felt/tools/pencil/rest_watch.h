#pragma once

#include <cstdint>

#include "felt/geometry/point.h"

namespace felt {

/// Detects that the pen rests on the surface. Use: begin() at the touch; update() for each sample.
class RestWatch {
 public:
  /// The pen rests if it has stayed within kRestMm of one point for kRestS. A hand that holds a pen
  /// still moves it by some tenths of a millimetre (tremor and drift,
  /// docs/design/simulation.md#people), and drawing programs that offer shapes wait about half a
  /// second.
  static constexpr double kRestMm = 1.0, kRestS = 0.5;

  void begin(Point pen, std::int64_t time_ns) noexcept;
  void update(Point pen, std::int64_t time_ns) noexcept;

  /// Returns how long the pen has been near at(), in s.
  [[nodiscard]] double still_s() const noexcept { return still_s_; }
  [[nodiscard]] bool rests() const noexcept { return still_s_ >= kRestS; }
  /// Returns the point near which the pen has stayed.
  [[nodiscard]] Point at() const noexcept { return at_; }

 private:
  Point at_;
  std::int64_t last_ns_ = 0;
  double still_s_ = 0.0;
};

}  // namespace felt
