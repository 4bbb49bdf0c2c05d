#pragma once

#include <string>
#include <vector>

#include "felt/devices/simulated/writing_hand.h"

namespace felt {

/// A recorded stroke with its name.
struct RecordedStroke {
  std::string id;
  std::vector<HandSample> samples;
};

/// A file of share/samples.
struct SampleSet {
  std::string file_name;
  std::vector<RecordedStroke> strokes;
};

/// Draws the project's sample strokes with the simulated hand, and returns the sets cat.ndjson,
/// handwriting.ndjson and page.ndjson.
std::vector<SampleSet> make_sample_sets();

/// Returns the set as raw stroke lines, {"id":..,"points":[[x,y,pressure,t_ms],..]}. Positions are
/// in mm with 2 decimals; pressure has 3 decimals, and milliseconds have 1.
std::string to_ndjson(const SampleSet& set);

}  // namespace felt
