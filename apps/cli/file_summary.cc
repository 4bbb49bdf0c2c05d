#include "file_summary.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "felt/io/ndjson_writer.h"

namespace felt::cli {
namespace {

/// The figures in the order of output, each with its key and its text.
using Figures = std::vector<std::pair<const char*, std::string>>;

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string bounds_json(const Rect& bounds) {
  if (bounds.empty()) return "null";
  return "[" + number(bounds.x0) + "," + number(bounds.y0) + "," + number(bounds.x1) + "," +
         number(bounds.y1) + "]";
}

Figures figures_of(const FileSummary& s) {
  Figures figures = {{"strokes", std::to_string(s.strokes)}};
  if (s.is_sketch) {
    figures.insert(figures.end(), {{"segments", std::to_string(s.segments)},
                                   {"corners", std::to_string(s.corners)},
                                   {"closed", std::to_string(s.closed)},
                                   {"width_knots", std::to_string(s.width_knots)},
                                   {"min_width_mm", number(s.min_width_mm)},
                                   {"max_width_mm", number(s.max_width_mm)},
                                   {"bounds_mm", bounds_json(s.bounds)}});
  } else {
    figures.insert(figures.end(), {{"samples", std::to_string(s.samples)},
                                   {"longest_stroke", std::to_string(s.longest)},
                                   {"with_pressure", std::to_string(s.with_pressure)},
                                   {"with_time", std::to_string(s.with_time)},
                                   {"bounds", bounds_json(s.bounds)}});
  }
  return figures;
}

const char* kind_of(const FileSummary& s) {
  return s.is_sketch ? "sketch" : "raw";
}

}  // namespace

void FileSummary::add(const Stroke& stroke) {
  is_sketch = true;
  const StrokeData& data = stroke.data();
  for (const WidthKnot& knot : data.widths) {
    const bool first = width_knots++ == 0;
    min_width_mm = first ? knot.width_mm : std::min(min_width_mm, knot.width_mm);
    max_width_mm = first ? knot.width_mm : std::max(max_width_mm, knot.width_mm);
  }
  ++strokes;
  segments += stroke.segment_count();
  corners += std::count(data.joints.begin(), data.joints.end(), JointKind::kCorner);
  closed += stroke.closed() ? 1 : 0;
  bounds.extend(stroke.bounds());
}

void FileSummary::add(const RawStroke& stroke) {
  bool pressure = false, time = false;
  for (const InkSample& sample : stroke.samples) {
    bounds.extend(sample.position);
    pressure = pressure || sample.pressure.has_value();
    time = time || sample.time_ns.has_value();
  }
  const auto count = static_cast<std::int64_t>(stroke.samples.size());
  ++strokes;
  samples += count;
  longest = std::max(longest, count);
  with_pressure += pressure ? 1 : 0;
  with_time += time ? 1 : 0;
}

std::string summary_text(const FileSummary& summary) {
  std::string text = fmt::format("{:16}{}\n", "kind", kind_of(summary));
  for (const auto& [key, value] : figures_of(summary)) {
    text += fmt::format("{:16}{}\n", key, value);
  }
  return text;
}

std::string summary_json(const FileSummary& summary) {
  std::string text = fmt::format(R"({{"kind":"{}")", kind_of(summary));
  for (const auto& [key, value] : figures_of(summary)) {
    text += fmt::format(R"(,"{}":{})", key, value);
  }
  return text + "}\n";
}

}  // namespace felt::cli
