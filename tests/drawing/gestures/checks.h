#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "felt/session/session.h"

namespace felt::gestures {

/// What a check says: nothing, or the rule that was broken and where.
using Broken = std::optional<std::string>;

/// An edit fits a document (a copy of it is changed to see), every stroke that it makes keeps the
/// invariants I1-I6, and every stroke that it changes is one that tools may change: on a visible
/// layer that is not locked.
Broken check_edit(const Document& before, const Edit& edit);
/// Strokes that an edit does not name are the same objects in both documents.
Broken check_locality(const Document& before, const Document& after, const Edit& edit);
/// Marks belong to strokes that are there, one a control point, and one at least is set.
Broken check_selection(const Document& document, const Selection& selection);
/// Everything in it is finite, and there is not more of it than the drawing and the gesture (so
/// many samples so far) account for.
Broken check_overlay(const Overlay& overlay, const Document& document, std::size_t samples);

/// Evaluates force models as the haptic loop does, one memory all along.
class ForceProbe {
 public:
  explicit ForceProbe(const Capabilities& device);

  /// The force at this sample is finite; what it has beside the sheet itself (plane, friction,
  /// grain) is at most `limit_n` in the sheet without the damping, pulls back no more steeply than
  /// the model claims and does not jump; claims keep the device's budget unless `may_exceed_budget`
  /// (the safety chain shrinks them then).
  Broken check(const ForceModel& model, const PenSample& sample, double limit_n,
               bool may_exceed_budget);
  /// The largest force beside the sheet's since the last call.
  [[nodiscard]] double take_largest_n() noexcept { return std::exchange(largest_n_, 0.0); }

 private:
  [[nodiscard]] Force beside_the_sheet(const ForceModel& model, const PenSample& sample) const;
  [[nodiscard]] double jump_between(const ForceModel& model, PenSample a, PenSample b) const;
  Broken check_slope(const ForceModel& model, const PenSample& sample) const;
  Broken check_claims(const Slopes& slopes, bool may_exceed_budget) const;

  Capabilities device_;
  ForceMemory memory_;
  std::int64_t last_ns_ = 0;
  double largest_n_ = 0.0;
};

}  // namespace felt::gestures
