#include "demo_act.h"

#include <algorithm>
#include <cmath>

#include "felt/base/constants.h"
#include "felt/devices/simulated/samples/sample_sets.h"
#include "felt/io/events/event_writer.h"

namespace felt {
namespace {

constexpr double kStepS = 0.04;  // time between two events of a path
constexpr double kHoverMm = 5.0;
constexpr double kAirMmPerS = 180.0;
constexpr double kEngageS = 0.8;  // time until forces are on
constexpr double kLandS = 0.12;

double rounded(double v, double step) {
  return std::round(v / step) * step;
}

/// Returns a value that rises smoothly from 0 to 1 while `t` does, with zero speed and acceleration
/// at both ends.
double eased(double t) {
  return t * t * t * (10.0 + t * (6.0 * t - 15.0));
}

/// Returns closely spaced points on a smooth curve (Catmull-Rom) through `via`.
std::vector<Point> smooth_way(const std::vector<Point>& via) {
  constexpr int kSteps = 16;
  std::vector<Point> way{via.front()};
  for (std::size_t i = 0; i + 1 < via.size(); ++i) {
    const Point a = via[i], b = via[i + 1];
    const Vec out = i > 0 ? 0.5 * (b - via[i - 1]) : b - a;
    const Vec in = i + 2 < via.size() ? 0.5 * (via[i + 2] - a) : b - a;
    for (int k = 1; k <= kSteps; ++k) {
      const double t = static_cast<double>(k) / kSteps, s = 1.0 - t;
      const Vec bend = t * s * (s * out - t * in);
      way.push_back(lerp(a, b, t * t * (3.0 - 2.0 * t)) + bend);
    }
  }
  return way;
}

}  // namespace

void DemoAct::say(const decltype(Event::what)& what) {
  append_event_line(text_, {.time_ns = std::llround(1e3 * now_s_) * 1'000'000, .what = what});
}

void DemoAct::tool(const char* id) {
  say(SelectTool{.id = id});
}

void DemoAct::set(const char* id, const OptionValue& value) {
  say(SetOption{.id = id, .value = value});
}

void DemoAct::choose(OfferKind what) {
  say(ChooseOffer{what});
}

void DemoAct::open_ring(double radius_mm) {
  const Point pen = on_page(hand_);
  say(UseRing{true, pen, pen + Vec{0.0, -radius_mm}, pen + Vec{radius_mm, 0.0}});
}

void DemoAct::draw(WritingHand& hand, const std::vector<Gesture>& gestures, int& count) {
  SampleSet set{"", {}};
  for (const Gesture& gesture : gestures) {
    set.strokes.push_back({"demo-" + std::to_string(++count), hand.draw(gesture)});
    // Adds the time that the hand needs when the script is played: 2.5 s to move to the stroke, and
    // 1.2 times the recorded duration to draw it. The next event must come later.
    const auto& samples = set.strokes.back().samples;
    drawing_s_ +=
        2.5 + 1.2e-9 * static_cast<double>(samples.back().time_ns - samples.front().time_ns);
  }
  text_ += to_ndjson(set);
  is_there_ = false;
}

void DemoAct::aim(const Vec3& target) {
  hand_ = target;
  const Vec off = std::sin(kTau * shake_hz_ * now_s_) * shake_mm_;
  say(HandEvent{.target = {rounded(target.x + off.x, 0.01), rounded(target.y + off.y, 0.01),
                           rounded(target.z, 0.01)},
                .pressure = {},
                .buttons = 0});
}

void DemoAct::go(const Vec3& target, double seconds) {
  const Vec3 from = hand_;
  const int steps = std::max(1, static_cast<int>(std::ceil(seconds / kStepS)));
  for (int i = 1; i <= steps; ++i) {
    now_s_ += seconds / steps;
    aim(lerp(from, target, eased(static_cast<double>(i) / steps)));
  }
}

void DemoAct::hover(Point at) {
  const Vec3 target{at.x, at.y, kHoverMm};
  if (is_there_) {
    go(target, 0.2 + norm(target - hand_) / kAirMmPerS);
    return wait(0.3);
  }
  now_s_ += drawing_s_;
  drawing_s_ = 0.0;
  aim(target);
  is_there_ = true;
  wait(kEngageS);
}

void DemoAct::press(double depth_mm) {
  go({hand_.x, hand_.y, -depth_mm}, kLandS);
}

void DemoAct::along(const std::vector<Point>& via, double mm_per_s) {
  std::vector<Point> points{on_page(hand_)};
  points.insert(points.end(), via.begin(), via.end());
  const std::vector<Point> way = smooth_way(points);
  std::vector<double> at_mm{0.0};
  for (std::size_t i = 1; i < way.size(); ++i) {
    at_mm.push_back(at_mm.back() + distance(way[i - 1], way[i]));
  }
  const double z = hand_.z;
  const double seconds = 0.2 + at_mm.back() / mm_per_s;
  const int steps = std::max(2, static_cast<int>(std::ceil(seconds / kStepS)));
  std::size_t k = 1;
  for (int i = 1; i <= steps; ++i) {
    const double wanted_mm = at_mm.back() * eased(static_cast<double>(i) / steps);
    while (k + 1 < way.size() && at_mm[k] < wanted_mm) ++k;
    const double span_mm = at_mm[k] - at_mm[k - 1];
    const double t =
        span_mm > 0.0 ? std::clamp((wanted_mm - at_mm[k - 1]) / span_mm, 0.0, 1.0) : 1.0;
    const Point p = lerp(way[k - 1], way[k], t);
    now_s_ += seconds / steps;
    aim({p.x, p.y, z});
  }
}

void DemoAct::wait(double seconds) {
  now_s_ += seconds;
  aim(hand_);
}

void DemoAct::lift() {
  go({hand_.x, hand_.y, kHoverMm}, kLandS);
  wait(0.15);
}

void DemoAct::tap(Point at) {
  hover(at);
  press();
  wait(0.1);
  lift();
}

void DemoAct::gesture(const std::vector<Point>& via, double mm_per_s, double depth_mm) {
  hover(via.front());
  press(depth_mm);
  wait(0.15);
  along({via.begin() + 1, via.end()}, mm_per_s);
  wait(0.35);
  lift();
}

std::vector<Point> loop_around_cats_head() {
  return {{30, 8},    {60, 4},  {92, 6},  {96, 40}, {92, 60}, {76, 64},
          {59, 62.4}, {42, 64}, {24, 62}, {24, 40}, {29, 10}};
}

}  // namespace felt
