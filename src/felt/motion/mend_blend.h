#pragma once

#include "felt/base/result.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Makes a stroke of interpolated data. Segments that have become too short (I5) are joined with
/// their neighbours, a stroke that is too short as a whole becomes a dot, and joints that are not
/// smooth enough become corners. Changes nothing if the data is valid. Fails if a number is not
/// finite or the data does not have the form of a stroke.
Result<Stroke> mended_blend(StrokeData data);

}  // namespace felt
