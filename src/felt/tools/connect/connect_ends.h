#pragma once

#include "felt/document/edit.h"
#include "felt/document/stroke_index.h"

namespace felt {

/// The point where two ends meet.
enum class MeetingPlace {
  kAtTarget,  ///< the moved end goes to the other one, which stays
  /// Both go halfway, unless the gap is wider than bending covers (TipLead::small_gap_mm) or the
  /// other stroke must not be changed; then the other end stays.
  kHalfWay,
};

struct ConnectEndsOptions {
  MeetingPlace place = MeetingPlace::kAtTarget;
  /// Strokes that meet stay separate, with a shared point.
  bool keep_separate = false;
};

/// Returns the edit that connects the ends `moved` and `to` (paper, "Connect curves";
/// docs/design/editing.md#joining; R43, R45):
///   - if they are the two ends of one stroke, it is closed: "Close";
///   - if they belong to two strokes that look alike, in one layer, the strokes are joined:
///     "Connect". The result keeps id, position in the layer and direction of the stroke of `to`.
///     Widths are kept; if they differ, the profile steps at the joint;
///   - otherwise the strokes share the point: "Connect", because ink must not change its look or
///     layer. A stroke of a locked or hidden layer does not change.
/// Joints are smooth if the ink turns by less than 30 degrees, else corners. If the gap is wider
/// than bending covers, the moved end arrives in the direction of the target (TipLead).
///
/// Returns an empty edit if an end does not exist, `moved` is not editable, the strokes are too
/// short for a valid result, or nothing would change; so ink is never lost. Pure.
Edit connect_ends(const Document& document, TipId moved, TipId to,
                  const ConnectEndsOptions& options = {});

}  // namespace felt
