#include "felt/devices/simulated/samples/sample_sets.h"

#include <array>
#include <cstdio>
#include <string_view>

#include "felt/devices/simulated/samples/drawings.h"

namespace felt {
namespace {

SampleSet draw(std::string name, const std::vector<Gesture>& gestures, const HandOptions& options) {
  SampleSet set{name + ".ndjson", {}};
  WritingHand hand(options);
  for (const Gesture& g : gestures) {
    set.strokes.push_back({name + "-" + std::to_string(set.strokes.size() + 1), hand.draw(g)});
  }
  return set;
}

std::vector<Gesture> handwriting() {
  std::vector<Gesture> lines;
  double y = 22.0;
  for (const std::string_view text : {"hello", "feltline", "feel the line"}) {
    for (const Gesture& g : cursive(text, {14.0, y}, 6.0)) lines.push_back(g);
    y += 22.0;
  }
  return lines;
}

}  // namespace

std::vector<SampleSet> make_sample_sets() {
  return {draw("cat", cat_drawing(), {.seed = 3}),
          draw("handwriting", handwriting(), {.tremor_mm = 0.02, .seed = 5}),
          draw("page", exercise_page(), {.seed = 7})};
}

std::string to_ndjson(const SampleSet& set) {
  std::string text;
  for (const RecordedStroke& stroke : set.strokes) {
    text += "{\"id\":\"" + stroke.id + "\",\"points\":[";
    const char* comma = "";
    for (const HandSample& s : stroke.samples) {
      std::array<char, 96> point{};
      std::snprintf(point.data(), point.size(), "%s[%.2f,%.2f,%.3f,%.1f]", comma, s.position.x,
                    s.position.y, s.pressure, static_cast<double>(s.time_ns) * 1e-6);
      text += point.data();
      comma = ",";
    }
    text += "]}\n";
  }
  return text;
}

}  // namespace felt
