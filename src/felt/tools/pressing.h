#pragma once

#include <optional>

#include "felt/haptics/capabilities.h"
#include "felt/haptics/pen_sample.h"
#include "felt/material/materials.h"

namespace felt {

/// Computes the pen pressure, 0..1, from the values that a device senses
/// (docs/design/forces.md#pressing; R14, R18):
///   - if the device senses pressure: that value, clamped;
///   - if it senses depth: p = clamp((K depth - F0)/(F1 - F0), 0, 1), from the spring force of the
///     plane (K is stiffness_n_per_m()), so that the same push draws the same width on every
///     surface;
///   - else (a mouse): nullopt.
class Pressing {
 public:
  /// F0, N. A hand that rests presses with up to this force, so the line keeps its minimum width.
  static constexpr double kMinN = 0.1;

  Pressing(const SurfaceMaterial& surface, const Capabilities& device) noexcept;

  /// Returns the rendered stiffness of the plane (plane_for): that of the surface, or less if the
  /// device cannot render it (R13, R55, R56).
  [[nodiscard]] double stiffness_n_per_m() const noexcept { return stiffness_n_per_m_; }
  /// Returns F1, the force at which a line has its full width, N. The device can exert this force
  /// continuously (firm_push_n).
  [[nodiscard]] double max_n() const noexcept { return max_n_; }
  /// Returns true if the pressure of a sample is its depth in the surface, so that a threshold of
  /// pressure can be felt as a click (PushClicks).
  [[nodiscard]] bool is_felt() const noexcept { return is_felt_; }
  /// Returns the pressure for a spring force in N.
  [[nodiscard]] double of_force(double spring_n) const noexcept;
  /// Returns the depth, mm, at which a device that senses depth has this pressure.
  [[nodiscard]] double depth_mm_at(double pressure) const noexcept;
  /// Returns the pressure of a sample, or nullopt if the device senses neither pressure nor depth.
  [[nodiscard]] std::optional<double> of(const PenSample& sample) const noexcept;

 private:
  double stiffness_n_per_m_;
  double max_n_;
  bool senses_depth_;
  bool is_felt_;
};

}  // namespace felt
