#pragma once

#include <optional>

#include "felt/haptics/capabilities.h"
#include "felt/haptics/pen_sample.h"
#include "felt/material/materials.h"

namespace felt {

/// How hard a pen is pressed on a sheet, 0..1, from what its device knows (specification 5b;
/// architecture section 10; R14, R18):
///   - the device senses pressure: that, clamped;
///   - it senses depth: p = clamp((K depth - F0)/(F1 - F0), 0, 1), from the force of the plane's
///     spring, so that the same push draws the same width on every sheet;
///   - else (a mouse): nothing.
class Pressing {
 public:
  static constexpr double kLeastN = 0.1;  ///< F0: a resting hand does not draw broader

  Pressing(const SurfaceMaterial& surface, const Capabilities& device) noexcept;

  /// Stiffness of the plane as it is rendered (plane_for): that of the sheet, or what the device
  /// can give of it (R13, R55, R56).
  [[nodiscard]] double stiffness_n_per_m() const noexcept { return stiffness_n_per_m_; }
  /// F1: full width, which the device can hold for as long as one likes (firm_push_n).
  [[nodiscard]] double most_n() const noexcept { return most_n_; }
  /// Of a spring force.
  [[nodiscard]] double of_force(double spring_n) const noexcept;
  /// Of a sample.
  [[nodiscard]] std::optional<double> of(const PenSample& sample) const noexcept;

 private:
  double stiffness_n_per_m_;
  double most_n_;
  bool senses_depth_;
};

}  // namespace felt
