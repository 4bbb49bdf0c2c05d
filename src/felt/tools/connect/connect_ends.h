#pragma once

#include "felt/document/edit.h"
#include "felt/document/stroke_index.h"

namespace felt {

/// Where two ends meet.
enum class MeetingPlace {
  kAtTarget,  ///< the moved end comes to the other one, which stays
  /// Both go half of the way, but not over a gap that is wider than bending covers
  /// (TipLead::small_gap_mm). A stroke that must not be changed stays.
  kHalfWay,
};

struct ConnectEndsOptions {
  MeetingPlace place = MeetingPlace::kAtTarget;
  /// Strokes that meet stay two, with a shared point.
  bool keep_separate = false;
};

/// The edit that puts the end `moved` and the end `to` onto each other (paper, "Connect curves";
/// specification 5g; R43, R45):
///   - the two ends of one stroke: it is closed, "Close";
///   - ends of two strokes that look alike, in one layer: they become one, "Connect", which keeps
///     id, place and direction of the stroke of `to`; widths are carried, and where they differ the
///     profile steps at the joint;
///   - else the strokes share the point, "Connect": ink of another look or layer must not change
///     its own. A stroke of a locked or hidden layer stays as it is.
/// Joints are smooth if the ink turns by less than 30 degrees, else corners. Over a gap that is
/// wider than bending covers, the moved end arrives in the direction of the target (TipLead).
///
/// Empty when an end is not there, `moved` may not be edited, the strokes are too short for a valid
/// one, or nothing would change: ink is never lost. Pure.
Edit connect_ends(const Document& document, TipId moved, TipId to,
                  const ConnectEndsOptions& options = {});

}  // namespace felt
