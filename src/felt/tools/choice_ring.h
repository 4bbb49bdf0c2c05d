#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "felt/geometry/point.h"
#include "felt/haptics/bricks/guide.h"
#include "felt/haptics/capabilities.h"
#include "felt/haptics/force_model.h"
#include "felt/material/materials.h"

namespace felt {

/// A menu around the pen: eight wells on a circle, each in a fixed direction, clockwise from the
/// top. A movement out of the middle chooses the well in its direction, whether it reaches the
/// well, stops before it or goes beyond it, so that a quick flick chooses without looking, as in
/// the marking menus of Kurtenbach and Buxton 1994 (DOI 10.1145/191666.191759; eight directions are
/// about the most that people mark reliably: Kurtenbach, Sellen and Buxton 1993, DOI
/// 10.1207/s15327051hci0801_1).
///
///   ChoiceRing ring(pen, up, right);   // the menu opens
///   ring.move(pen);                    // for each position; publish ring_force(ring, ...)
///   ring.chosen();                     // when the pen is lifted or the button released
///
/// A value type.
class ChoiceRing {
 public:
  static constexpr std::size_t kWells = 8;
  /// Share of the radius within which nothing is chosen (chosen).
  static constexpr double kMiddle = 0.35;
  /// How far beyond the middle between two wells the pen must turn before the choice changes, rad.
  static constexpr double kHysteresisRad = 0.07;

  /// `up` and `right` point from the middle to the wells at the top and on the right; they are
  /// perpendicular and their length is the radius, mm. They depend on how the page is turned and
  /// mirrored on the screen.
  ChoiceRing(Point middle, Vec up, Vec right) noexcept : middle_(middle), up_(up), right_(right) {}

  /// Updates the choice for a position of the pen.
  void move(Point pen) noexcept;
  /// Chooses a well without the pen, or none.
  void choose(std::optional<std::size_t> well) noexcept { chosen_ = well; }
  [[nodiscard]] std::optional<std::size_t> chosen() const noexcept { return chosen_; }

  [[nodiscard]] Point middle() const noexcept { return middle_; }
  [[nodiscard]] double radius_mm() const noexcept { return norm(up_); }
  [[nodiscard]] Point well(std::size_t i) const noexcept;

 private:
  Point middle_;
  Vec up_, right_;
  std::optional<std::size_t> chosen_;
};

/// Returns the force of a well of a ring with this radius: 250 N/m, at most 0.5 N, smaller in
/// proportion if the radius is less than kRingMm. It ends before the middle between two wells, so a
/// choice never changes while it acts, and the slopes of two neighbours are felt as a ridge.
GuideLaw ring_law(double radius_mm) noexcept;
inline constexpr double kRingMm = 16.0;

/// Returns the force of the chosen well; without a choice, a guide without force.
Guide ring_guide(const ChoiceRing& ring) noexcept;
/// Returns the force model of a ring: the hardness of the surface and the chosen well
/// (docs/design/forces.md#rings). There is neither friction nor grain, so that only the wells are
/// felt.
ForceModel ring_force(const ChoiceRing& ring, const SurfaceMaterial& surface,
                      const Capabilities& device) noexcept;

}  // namespace felt
