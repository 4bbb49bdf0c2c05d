#pragma once

#include <functional>

#include "felt/document/edit.h"
#include "felt/document/stroke_index.h"

namespace felt {

/// The point at which two ends meet.
enum class MeetingPlace {
  kAtTarget,  ///< the moved end moves to the other end, which stays
  /// Both ends move halfway. Exception: the other end stays, and only the moved end moves, if the
  /// gap is too wide to close by bending (TipLead::small_gap_mm) or if the other stroke must not be
  /// changed.
  kHalfWay,
};

struct ConnectEndsOptions {
  MeetingPlace place = MeetingPlace::kAtTarget;
  /// If true, strokes that meet stay separate, with a shared point.
  bool keep_separate = false;
  /// Adds the changes of other strokes to an edit that lets the ends meet, before they are joined.
  /// May be empty.
  std::function<void(Edit&)> complete = {};
};

/// Returns the edit that connects the ends `moved` and `to` (paper, "Connect curves";
/// docs/design/editing.md#joining; R43, R45):
///   - if they are the two ends of one stroke, the stroke is closed: "Close";
///   - if they belong to two strokes of one layer with the same medium and colour, the strokes are
///     joined: "Connect". The result keeps id, position in the layer and direction of the stroke of
///     `to`. Both strokes keep their widths, so the width may change abruptly at the joint;
///   - otherwise the strokes stay separate and share the point: "Connect". They are not joined if
///     that would change the look or the layer of ink, or if `keep_separate` is set. A stroke of a
///     locked or hidden layer does not change.
/// Joints are smooth if the ink turns by less than 30 degrees, else corners. If the gap is too wide
/// to close by bending, the moved end arrives in the direction of the target (TipLead).
///
/// Returns an empty edit if an end does not exist, `moved` is not editable, the strokes are too
/// short for a valid result, or nothing would change; so ink is never lost. This is a pure
/// function if `complete` is.
Edit connect_ends(const Document& document, TipId moved, TipId to,
                  const ConnectEndsOptions& options = {});

}  // namespace felt
