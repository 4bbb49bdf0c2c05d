// Writes the acts of the demonstration as scripts: make_demo FOLDER (share/demo).

#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>

#include "felt/devices/simulated/drawings.h"
#include "felt/devices/simulated/sample_sets.h"
#include "felt/io/event_writer.h"

namespace felt {
namespace {

/// Part of a circle, begun at `from` turns (0 is to the right, a quarter is below) and a little
/// uneven, as drawn by hand.
Gesture arc(Point center, double radius_mm, double from, double turns, double pressure) {
  Gesture gesture{.via = {}, .pressure = pressure, .end_pressure = 0.45};
  const int steps = std::max(4, static_cast<int>(std::abs(turns) * 16.0));
  for (int i = 0; i <= steps; ++i) {
    const double turn = from + turns * i / steps;
    const double angle = 2.0 * std::numbers::pi * turn;
    const double r = radius_mm * (1.0 + 0.015 * std::sin(3.0 * angle + 1.0));
    gesture.via.push_back(center + Vec{r * std::cos(angle), r * std::sin(angle)});
  }
  return gesture;
}

/// A ball of wool beside the cat. Its outline ends 1.5 mm before its start: snapping closes it.
std::vector<Gesture> ball_of_wool() {
  const Point center{14.5, 111.0};
  constexpr double kRadius = 10.2;
  std::vector<Gesture> ball;
  ball.push_back(arc(center, kRadius, 0.75, 1.0 - 1.5 / (2.0 * std::numbers::pi * kRadius), 0.6));
  const auto thread = [&](std::vector<Vec> offsets) {
    Gesture gesture{.via = {}, .pressure = 0.32, .end_pressure = 0.3};
    for (const Vec& offset : offsets) gesture.via.push_back(center + offset);
    ball.push_back(std::move(gesture));
  };
  // Wound one way, and the other way on top.
  thread({{-9.2, -2.4}, {-6.2, -5.2}, {-2.6, -9.2}});
  thread({{-9.0, 2.2}, {-5.0, -2.8}, {1.2, -9.0}});
  thread({{-7.8, 5.2}, {-3.4, -0.8}, {4.4, -5.2}, {8.2, -4.8}});
  thread({{-4.8, 8.2}, {-0.6, 2.2}, {5.6, -1.6}, {9.0, -1.0}});
  thread({{-0.8, 9.2}, {3.0, 4.8}, {6.8, 2.4}, {8.8, 2.8}});
  // The loose end.
  ball.push_back({.via = {{20.5, 119.2},
                          {24.6, 123.4},
                          {30.6, 125.6},
                          {35.2, 125.2},
                          {35.0, 122.8},
                          {31.8, 124.0},
                          {34.0, 127.0},
                          {41.4, 126.2}},
                  .pressure = 0.45});
  return ball;
}

std::string event_line(const Event& event) {
  std::string line;
  append_event_line(line, event);
  return line;
}

/// What the hand records of some gestures, as lines of raw strokes with names that go on counting.
std::string recorded(WritingHand& hand, const std::vector<Gesture>& gestures, int& count) {
  SampleSet set{"", {}};
  for (const Gesture& gesture : gestures) {
    set.strokes.push_back({"demo-" + std::to_string(++count), hand.draw(gesture)});
  }
  return to_ndjson(set);
}

/// The first act: the ball of wool, whose outline snaps shut, and the cat, with the pencil.
std::string pencil_act() {
  WritingHand hand({.seed = 3});
  int count = 0;
  std::vector<Gesture> ball = ball_of_wool();
  std::string script = event_line({.time_ns = 0, .what = SelectTool{.id = "pencil"}});
  const auto set = [&script](const char* id, const OptionValue& value) {
    script += event_line({.time_ns = 0, .what = SetOption{.id = id, .value = value}});
  };
  // Fine lines that swell when pressed: the tool's own width is for broad strokes.
  set("pencil.min_width_mm", 0.25);
  set("pencil.max_width_mm", 2.2);
  set("pencil.gamma", 1.2);
  set("sheet.color", std::string("#23262d"));
  set("pencil.snap", std::string("both"));
  script += recorded(hand, {ball.front()}, count);
  ball.erase(ball.begin());
  set("pencil.snap", std::string("off"));
  script += recorded(hand, ball, count);
  script += recorded(hand, cat_drawing(), count);
  return script;
}

}  // namespace
}  // namespace felt

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 2;
  }
  const std::string path = std::string(argv[1]) + "/1-pencil.ndjson";
  std::ofstream out(path, std::ios::binary);
  out << felt::pencil_act();
  if (out.flush()) return 0;
  std::fprintf(stderr, "%s: cannot be written\n", path.c_str());
  return 1;
}
