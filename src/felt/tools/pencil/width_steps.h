#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "felt/stroke/fit/ink_fit.h"

namespace felt {

/// Holds the width of a line at a few steps: widths of drawing pens, 0.3, 0.5, 0.7, 1.0, 1.4 mm and
/// so on. From 0.5 mm up, each is sqrt(2) times the previous one, rounded, as in ISO 128-2.
///
/// The range of pressure is divided into equal parts, one for each step, because a hand holds a
/// push more surely than a width. So the pen must press equally much more for each step, whatever
/// its width. A step is left only if the pressure is kHysteresis of a part outside.
class WidthSteps {
 public:
  static constexpr std::size_t kMax = 5;  ///< more steps cannot be told apart on a weak device
  static constexpr double kHysteresis = 0.15;

  /// Makes a value that holds nothing.
  WidthSteps() noexcept = default;
  /// Uses the steps between the thinnest and the broadest line; if there are more than kMax, the
  /// first, the last and those at equal distances between them. With fewer than two, it holds
  /// nothing.
  explicit WidthSteps(const WidthMapOptions& widths) noexcept;

  [[nodiscard]] std::size_t size() const noexcept { return count_; }
  /// Returns the width of step i, mm. Requires i < size().
  [[nodiscard]] double width_mm(std::size_t i) const noexcept { return widths_mm_[i]; }
  /// Returns the pressure whose width is that of the current step. Returns the same value if it is
  /// absent or there are no steps.
  std::optional<double> held(std::optional<double> pressure) noexcept;

 private:
  std::array<double, kMax> widths_mm_{};
  std::array<double, kMax> pressures_{};
  std::size_t count_ = 0;
  std::optional<std::size_t> step_;
};

}  // namespace felt
