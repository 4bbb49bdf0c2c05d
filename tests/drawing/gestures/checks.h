#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "felt/session/session.h"

namespace felt::gestures {

/// The result of a check: the rule that was broken and where, or nullopt if all rules hold.
using Broken = std::optional<std::string>;

/// Checks that `edit` can be applied to `before` (it is tried on a copy), that every new stroke
/// keeps the invariants I1-I6, and that every changed stroke is on a visible, unlocked layer.
Broken check_edit(const Document& before, const Edit& edit);
/// Checks that strokes that `edit` does not name are the same objects in both documents.
Broken check_locality(const Document& before, const Document& after, const Edit& edit);
/// Checks that each selected stroke exists in `document`, has one mark per control point, and that
/// at least one of its marks is set.
Broken check_selection(const Document& document, const Selection& selection);
/// Checks that every number of `overlay` is finite and that it has not more items than the drawing
/// and a gesture of `samples` samples explain.
Broken check_overlay(const Overlay& overlay, const Document& document, std::size_t samples);

/// Checks that a reading names only strokes and fills that `document` has, and that its numbers are
/// lengths.
Broken check_reading(const Reading& reading, const Document& document);

/// Evaluates force models as the haptic loop does, with the same ForceMemory for all calls.
class ForceProbe {
 public:
  explicit ForceProbe(const Capabilities& device);

  /// Checks the force at `sample`: it is finite. The part that does not come from the surface
  /// (plane, friction, grain) is, without damping, at most `limit_n` along the surface, is not
  /// stiffer than the model claims, and does not jump. The claimed stiffness is within the
  /// device's budget, unless `may_exceed_budget` is set (the safety chain then scales it down).
  Broken check(const ForceModel& model, const PenSample& sample, double limit_n,
               bool may_exceed_budget);
  /// Returns the largest force since the last call, in N, without the forces of the surface. Resets
  /// it to 0.
  [[nodiscard]] double take_largest_n() noexcept { return std::exchange(largest_n_, 0.0); }

 private:
  [[nodiscard]] static Force beside_the_surface(const ForceModel& model, const PenSample& sample,
                                                ForceMemory memory);
  [[nodiscard]] static double jump_between(const ForceModel& model, PenSample a, PenSample b,
                                           const ForceMemory& seen);
  Broken check_slope(const ForceModel& model, const PenSample& sample) const;
  Broken check_claims(const Slopes& slopes, bool may_exceed_budget) const;

  Capabilities device_;
  ForceMemory memory_;
  std::int64_t last_ns_ = 0;
  double largest_n_ = 0.0;
};

}  // namespace felt::gestures
