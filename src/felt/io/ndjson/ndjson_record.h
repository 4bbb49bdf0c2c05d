#pragma once

#include <string>
#include <vector>

#include "felt/stroke/fit/ink_fit.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// The kinds of lines in an .ndjson file (docs/formats/ndjson.md).
enum class NdjsonKind {
  kStroke,  ///< a stroke; raw_stroke() reads a raw one, sketch_stroke() a fitted one
  kHeader,  ///< {"feltline":1,...}: describes the file
};

/// A pen recording: samples as the device reported them, in the unit of the file. Pressures are
/// those of the file, too; InkFitter limits them to 0..1 and reports those that are outside.
struct RawStroke {
  std::string id;  ///< empty if the line has none
  std::vector<InkSample> samples;

  friend bool operator==(const RawStroke&, const RawStroke&) = default;
};

/// The values of a sketch line. They may not make a valid stroke; `Stroke::create` checks that.
struct SketchRecord {
  std::string id;  ///< empty if the line has none
  StrokeData data;

  friend bool operator==(const SketchRecord&, const SketchRecord&) = default;
};

}  // namespace felt
