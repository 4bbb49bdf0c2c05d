#pragma once

#include <string>
#include <vector>

#include "felt/stroke/fit/ink_fit.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// What one line of an .ndjson file holds (docs/formats/ndjson.md).
enum class NdjsonKind {
  kStroke,  ///< a stroke, raw or fitted, depending on what was asked for
  kHeader,  ///< {"feltline":1,...}: says something about the file, is no stroke
};

/// A pen recording: samples as they came from the device, in the unit of the file.
struct RawStroke {
  std::string id;  ///< empty when the line has none
  std::vector<InkSample> samples;

  friend bool operator==(const RawStroke&, const RawStroke&) = default;
};

/// What a sketch line says, not yet known to be a stroke: `Stroke::create` decides that.
struct SketchRecord {
  std::string id;  ///< empty when the line has none
  StrokeData data;

  friend bool operator==(const SketchRecord&, const SketchRecord&) = default;
};

}  // namespace felt
