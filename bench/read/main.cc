// bench_read [--tries N] [--device NAME] [--forces off] [--sound off] [--line NAME] [--trace TRY]
// Simulated people without eyes (felt/devices/simulated/blind_hand.h) follow lines of 200 mm with
// the tool Read: straight, curved, wavy, and with corners. A try is successful if the pen visits
// the whole line, each 5 mm of it in order and within 3 mm, and comes within 2 mm of the far end
// within 60 s. Prints the successes; fails if they are fewer than 95 %. With --forces off, the
// people feel nothing, which shows that the hand does not know the line otherwise; with --sound
// off, they do not hear whether the pen is on a line or at an end. With --trace, prints the path of
// one try as lines of x, y and the distance from the line.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/devices/simulated/blind_hand.h"
#include "felt/devices/simulated/held_body.h"
#include "felt/geometry/polyline.h"
#include "felt/haptics/safety/safety_limits.h"
#include "felt/rt/servo.h"
#include "felt/rt/virtual_clock.h"
#include "felt/session/session.h"
#include "felt/tools/reading.h"

namespace felt::bench {
namespace {

constexpr double kLengthMm = 200.0, kPartMm = 5.0;
constexpr double kNearMm = 3.0, kEndMm = 2.0;
constexpr double kLimitS = 60.0;
constexpr double kGoal = 0.95;
constexpr Point kMiddle{150.0, 105.0};
constexpr int kPublishTicks = 8;  // the edit thread works about 120 times a second
constexpr std::array<const char*, 4> kShapes{"straight", "curved", "wavy", "corners"};

struct Options {
  std::size_t tries = 500;
  std::string device = "premium";
  bool forces = true, sound = true;
  std::optional<std::size_t> trace;
  std::string line;  ///< only this kind of line, or "" for all
};

/// Cuts a path to kLengthMm and moves its middle to kMiddle.
std::vector<Point> cut_to_length(const std::vector<Point>& path) {
  std::vector<Point> points(static_cast<std::size_t>(kLengthMm / 0.5) + 1);
  std::vector<Point> whole;
  for (const Point& p : path) {
    whole.push_back(p);
    const double length = polyline_length(whole);
    if (length < kLengthMm) continue;
    whole.back() = point_at_length(whole, kLengthMm);
    break;
  }
  resample(whole, points);
  Rect box;
  for (const Point& p : points) box.extend(p);
  const Vec shift = kMiddle - Point{0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)};
  for (Point& p : points) p += shift;
  return points;
}

/// Returns the line of a try.
std::vector<Point> line_of(std::size_t shape, Random& random) {
  std::vector<Point> path;
  const double turn = random.between(0.0, kTau);
  const Vec x{std::cos(turn), std::sin(turn)};
  const auto add = [&](double a, double b) { path.push_back(Point{} + a * x + b * perp(x)); };
  if (shape == 0) {
    add(0.0, 0.0);
    add(kLengthMm + 1.0, 0.0);
  } else if (shape == 1) {
    const double radius = random.between(45.0, 120.0);
    for (double s = 0.0; s < kLengthMm + 1.0; s += 0.25) {
      add(radius * std::sin(s / radius), radius * (1.0 - std::cos(s / radius)));
    }
  } else if (shape == 2) {
    const double height = random.between(4.0, 8.0), wave = random.between(50.0, 80.0);
    for (double s = 0.0; s < kLengthMm + 1.0; s += 0.25) add(s, height * std::sin(kTau * s / wave));
  } else {
    Point at{};
    double heading = turn, side = random.between(-1.0, 1.0) < 0.0 ? -1.0 : 1.0;
    path.push_back(at);
    for (int i = 0; i < 6; ++i) {
      at += random.between(35.0, 60.0) * Vec{std::cos(heading), std::sin(heading)};
      path.push_back(at);
      heading += side * random.between(40.0, 110.0) * kTau / 360.0;
      side = -side;  // zigzag, so that the line does not cross itself
    }
  }
  return cut_to_length(path);
}

Document drawing_of(const std::vector<Point>& line) {
  // Corners only where the line has them: elsewhere the turn between two points is small.
  StrokeData data;
  data.points = {line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Cubic c = straight(line[i - 1], line[i]);
    data.points.insert(data.points.end(), {c.p[1], c.p[2], line[i]});
  }
  data.joints.assign(line.size() - 2, JointKind::kCorner);
  const auto end = static_cast<double>(line.size() - 1);
  data.widths = {{0.0, 1.0}, {end, 1.0}};
  const StrokePtr stroke = std::make_shared<const Stroke>(Stroke::create(std::move(data)).value());
  return document_of(std::span(&stroke, 1));
}

struct TryResult {
  bool is_done = false;
  double seconds = 0.0;
  double mean_mm = 0.0;  ///< distance from the line
  double reached_mm = 0.0;
  bool thought_end = false;
};

/// Returns true if the tone of Read is steady: the pen is on a line, its end or a crossing.
bool is_on_line(const Reading& reading) {
  return reading.kind != Reading::Kind::kNothing && reading.kind != Reading::Kind::kFill;
}

bool is_at_end(const Reading& reading) {
  return reading.kind == Reading::Kind::kEnd;
}

/// Lets one person follow one line.
TryResult follow_line(const Options& options, std::size_t number) {
  Random random(number + 1);
  const std::vector<Point> line = line_of(number % kShapes.size(), random);
  StylusPreset preset = *find_stylus_preset(options.device);
  center_workspace(preset.capabilities, kMiddle);
  const Vec along = line[4] - line[0];
  // Somebody puts the pen onto the start, and says roughly which direction.
  const double heading = std::atan2(along.y, along.x) + random.between(-0.7, 0.7);
  const Point start = line[0] + Vec{random.between(-1.5, 1.5), random.between(-1.5, 1.5)};
  BlindHand hand(preset, person_of(number + 1), start, heading);
  ServoOptions servo_options{.limits = limits_for(preset.capabilities)};
  const auto servo = std::make_unique<Servo>(hand.device(), servo_options);
  servo->arm();
  Session session(make_tools(), {.device = preset.capabilities, .document = drawing_of(line)});
  static_cast<void>(session.apply({0, SelectTool{"read"}}));
  if (!options.forces) {
    static_cast<void>(session.apply({0, SetOption{"read.strength", OptionValue(0.0)}}));
  }
  VirtualClock clock(*servo);
  TryResult result;
  double sum = 0.0;
  int ticks = 0;
  const double ms = 1e-9 * static_cast<double>(preset.capabilities.period_ns);
  while (ms * ticks < kLimitS && !result.is_done && !hand.found_end()) {
    hand.step();
    const TickReport& tick = clock.tick();
    static_cast<void>(session.sample(tick.sample));
    const Reading* reading = session.tool().reading();
    if (options.sound && reading) hand.hear(is_on_line(*reading), is_at_end(*reading));
    if (++ticks % kPublishTicks == 0) servo->publish(session.force());
    const Vec3& body = hand.device().stylus().body().position();
    const PolylineNearest near = nearest_on_polyline(line, on_page(body));
    const double away = std::sqrt(near.distance_squared);
    sum += away;
    const double at_mm = 0.5 * (static_cast<double>(near.index) + near.t);
    if (away < kNearMm && at_mm < result.reached_mm + kPartMm) {
      result.reached_mm = std::max(result.reached_mm, at_mm);
    }
    result.is_done =
        result.reached_mm > kLengthMm - kPartMm && distance(on_page(body), line.back()) < kEndMm;
    if (options.trace && ticks % 20 == 0) {
      fmt::print("{:.2f} {:.2f} {:.2f} {:.1f}\n", body.x, body.y, away, result.reached_mm);
    }
  }
  result.seconds = ms * ticks;
  result.mean_mm = sum / std::max(1, ticks);
  result.thought_end = hand.found_end();
  return result;
}

struct ShapeTotals {
  std::size_t tries = 0, done = 0, early = 0;
  double seconds = 0.0, mean_mm = 0.0;
};

int run(const Options& options) {
  std::array<ShapeTotals, kShapes.size()> totals;
  std::size_t done = 0;
  std::size_t tries = 0;
  for (std::size_t i = 0; i < options.tries; ++i) {
    if (!options.line.empty() && options.line != kShapes[i % kShapes.size()]) continue;
    ++tries;
    const TryResult result = follow_line(options, i);
    ShapeTotals& t = totals[i % kShapes.size()];
    ++t.tries;
    if (result.is_done) {
      ++t.done;
      ++done;
      t.seconds += result.seconds;
      t.mean_mm += result.mean_mm;
    } else {
      if (result.thought_end) ++t.early;
      fmt::print("try {} ({}) ends after {:.0f} mm, {:.0f} s{}\n", i, kShapes[i % kShapes.size()],
                 result.reached_mm, result.seconds,
                 result.thought_end ? ": the person believes that the line ends" : "");
    }
  }
  fmt::print("{:<10} {:>6} {:>8} {:>10} {:>8} {:>16}\n", "line", "tries", "to end", "gave up",
             "mean s", "mean distance mm");
  for (std::size_t k = 0; k < kShapes.size(); ++k) {
    const ShapeTotals& t = totals[k];
    const double count = static_cast<double>(std::max<std::size_t>(1, t.done));
    fmt::print("{:<10} {:>6} {:>8} {:>10} {:>8.1f} {:>16.2f}\n", kShapes[k], t.tries, t.done,
               t.early, t.seconds / count, t.mean_mm / count);
  }
  const double share =
      static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(1, tries));
  fmt::print(
      "\n{} of {} tries from end to end ({:.1f} %; the goal is {:.0f} %). Simulated {}, forces "
      "{}, sound {}.\n"
      "gave up: the person believed that the line ended earlier.\n",
      done, tries, 100.0 * share, 100.0 * kGoal, options.device, options.forces ? "on" : "off",
      options.sound ? "on" : "off");
  return share >= kGoal || !options.forces ? 0 : 1;
}

int run_arguments(int argc, char** argv) {
  Options options;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i], value = argv[i + 1];
    if (name == "--tries") options.tries = std::strtoull(value.c_str(), nullptr, 10);
    if (name == "--device") options.device = value;
    if (name == "--sound") options.sound = value != "off";
    if (name == "--forces") options.forces = value != "off";
    if (name == "--line") options.line = value;
    if (name == "--trace") options.trace = std::strtoull(value.c_str(), nullptr, 10);
  }
  if (argc % 2 == 0 || options.tries == 0 || !find_stylus_preset(options.device)) {
    fmt::print(stderr,
               "usage: bench_read [--tries N] [--device NAME] [--forces off] [--sound off]\n"
               "                  [--line NAME] [--trace TRY]\n");
    return 2;
  }
  if (options.trace) {
    const TryResult result = follow_line(options, *options.trace);
    return result.is_done ? 0 : 1;
  }
  return run(options);
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  return felt::bench::run_arguments(argc, argv);
}
