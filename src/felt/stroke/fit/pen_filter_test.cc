#include "felt/stroke/fit/pen_filter.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace felt::pen_filter_test {
namespace {

using Ink = std::vector<InkSample>;

Ink filtered(const Ink& stroke, const PenFilterOptions& options = {}) {
  PenFilter filter(options);
  filter.begin();
  Ink out;
  for (const InkSample& s : stroke) {
    const auto ready = filter.push(s);
    out.insert(out.end(), ready.begin(), ready.end());
  }
  const auto rest = filter.end();
  out.insert(out.end(), rest.begin(), rest.end());
  return out;
}

// Returns a line to the right at 100 mm/s and 200 Hz, pressure 0.5.
Ink line(int count, double interval_ms = 5.0) {
  Ink stroke;
  for (int i = 0; i < count; ++i) {
    stroke.push_back({{0.1 * interval_ms * i, 20.0}, 0.5, std::llround(interval_ms * 1e6 * i)});
  }
  return stroke;
}

TEST(PenFilter, LatePressureIsFilledInAndNoSampleIsLost) {
  for (const std::optional<double> missing :
       {std::optional<double>{}, std::optional<double>{0.0}}) {
    Ink stroke = line(40);
    for (std::size_t i = 0; i < 4; ++i) stroke[i].pressure = missing;
    EXPECT_EQ(filtered(stroke), line(40));
    stroke.resize(6);  // shorter than the window
    EXPECT_EQ(filtered(stroke), line(6));
  }
}

TEST(PenFilter, WithoutAnyPressureNothingIsFilledIn) {
  Ink mouse = line(40);
  for (InkSample& s : mouse) s.pressure.reset();
  EXPECT_EQ(filtered(mouse), mouse);
}

TEST(PenFilter, BlobAtPenDownIsCappedAtTheLevelAfterIt) {
  Ink stroke = line(60, 1.0);
  for (std::size_t i = 0; i < 5; ++i) stroke[i].pressure = 0.9;
  EXPECT_EQ(filtered(stroke), line(60, 1.0));
}

TEST(PenFilter, SpikeAtPenUpIsCappedAtTheLevelBeforeIt) {
  Ink stroke = line(60, 1.0);
  for (std::size_t i = 56; i < 60; ++i) stroke[i].pressure = 0.95;
  EXPECT_EQ(filtered(stroke), line(60, 1.0));
}

Ink with_hook(double pressure, double step_mm) {
  Ink stroke = line(40);
  for (int i = 1; i <= 3; ++i) {
    const InkSample last = stroke.back();
    stroke.push_back(
        {last.position + Vec{-step_mm, -step_mm}, pressure / i, *last.time_ns + 5'000'000});
  }
  return stroke;
}

TEST(PenFilter, HookAtLiftIsTrimmed) {
  EXPECT_EQ(filtered(with_hook(0.2, 0.2)), line(40));
}

TEST(PenFilter, AReversalUnderPressureOrALongOneIsInk) {
  EXPECT_EQ(filtered(with_hook(0.5, 0.2)).size(), 43u);
  EXPECT_EQ(filtered(with_hook(0.2, 0.6)).size(), 43u);
  EXPECT_EQ(filtered(with_hook(0.2, 0.01)).size(), 43u);
}

TEST(PenFilter, StraySampleIsDropped) {
  Ink stroke = line(40);
  stroke[20].position += Vec{0.0, 60.0};
  Ink expected = line(40);
  expected.erase(expected.begin() + 20);
  EXPECT_EQ(filtered(stroke), expected);

  stroke = line(40);
  stroke.back().position += Vec{-80.0, 60.0};
  EXPECT_EQ(filtered(stroke), line(39));
}

TEST(PenFilter, AStrayStartIsDropped) {
  for (const double interval_ms : {1.0, 5.0, 8.0, 40.0}) {
    for (const int strays : {1, 2, 3}) {
      Ink stroke;
      for (int i = 0; i < strays; ++i) {
        stroke.push_back(
            {{400.0 + 0.2 * i, 20.0}, 0.5, std::llround(-interval_ms * 1e6 * (strays - i))});
      }
      const Ink rest = line(40, interval_ms);
      stroke.insert(stroke.end(), rest.begin(), rest.end());
      if (interval_ms * strays > 30.0) {  // farther back than the window: drawn there
        EXPECT_GE(filtered(stroke).size(), rest.size());
      } else {
        EXPECT_EQ(filtered(stroke), rest) << interval_ms << ' ' << strays;
      }
      stroke.resize(static_cast<std::size_t>(strays) + 2);  // a short line
      if (strays > 1) continue;
      EXPECT_EQ(filtered(stroke), Ink(rest.begin(), rest.begin() + 2));
    }
  }
  Ink two = line(2);
  two[0].position.x = 400.0;
  EXPECT_EQ(filtered(two), two);  // no more than a guess
}

TEST(PenFilter, TheFastestHandIsNotAJump) {
  Ink stroke;  // shading at 2.5 m/s, sampled at 133 Hz
  for (int i = 0; i < 60; ++i) {
    stroke.push_back({{i % 2 == 0 ? 20.0 : 38.75, 20.0 + 0.5 * i}, 0.5, 7'500'000LL * i});
  }
  EXPECT_EQ(filtered(stroke), stroke);
}

TEST(PenFilter, DotsStayDots) {
  for (int count = 1; count <= 6; ++count) {
    Ink dot;
    for (int i = 0; i < count; ++i) {
      dot.push_back({{5.0 + 0.03 * (i % 2), 5.0}, 0.6 / (i + 1), 5'000'000LL * i});
    }
    EXPECT_EQ(filtered(dot), dot);
  }
  EXPECT_TRUE(filtered({}).empty());
}

TEST(PenFilter, HoldsNoLongerThanItSays) {
  PenFilter filter;
  filter.begin();
  for (const InkSample& s : line(200)) {
    filter.push(s);
    EXPECT_LE(*s.time_ns - *filter.held().front().time_ns, 30'000'000);
  }
  filter.begin();
  for (InkSample s : line(2000)) {
    s.time_ns = 0;  // a clock that stands still
    filter.push(s);
    EXPECT_LE(filter.held().size(), PenFilter::kMaxHeld);
  }
}

// A smooth stroke with tapered ends is not changed, at any rate and speed, with or without times.
RC_GTEST_PROP(PenFilter, InkWithoutArtefactsPassesUnchanged, ()) {
  const double rate_hz = *rc::gen::element(60.0, 133.0, 200.0, 1000.0);
  const double radius = *rc::gen::inRange(2, 40), mm_per_s = *rc::gen::inRange(10, 500);
  const bool timed = *rc::gen::arbitrary<bool>();
  const int count = *rc::gen::inRange(1, 400);
  Ink stroke;
  for (int i = 0; i < count; ++i) {
    const double t = i / rate_hz, a = mm_per_s * t / radius;
    const double taper = std::min({1.0, 0.1 + t / 0.05, 0.1 + (count - 1 - i) / rate_hz / 0.05});
    stroke.push_back({{radius * std::cos(a), radius * std::sin(a)}, 0.6 * taper, {}});
    if (timed) stroke.back().time_ns = std::llround(t * 1e9);
  }
  RC_ASSERT(filtered(stroke) == stroke);
}

// For any input, the order and the start stay the same, and the filter removes no more of the end
// than allowed.
RC_GTEST_PROP(PenFilter, LosesNoMoreThanItSays, ()) {
  const auto steps = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::array<int, 4>>>(
      rc::gen::container<std::array<int, 4>>(rc::gen::inRange(-10, 11))));
  Ink stroke;
  Point p{100.0, 100.0};
  std::int64_t t = 0;
  for (const auto& [dx, dy, dp, dt] : steps) {
    p += Vec{0.1 * dx, 0.1 * dy};
    t += dt * 1'000'000;
    stroke.push_back({p, {}, t});
    if (dp > -8) stroke.back().pressure = std::max(dp, 0) / 10.0;
  }
  const Ink out = filtered(stroke);
  RC_ASSERT(!out.empty() && out.size() <= stroke.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    RC_ASSERT(out[i].position == stroke[i].position && out[i].time_ns == stroke[i].time_ns);
  }
  double lost_mm = 0.0;
  for (std::size_t i = out.size(); i < stroke.size(); ++i) {
    lost_mm += distance(stroke[i - 1].position, stroke[i].position);
  }
  RC_ASSERT(lost_mm <= PenFilterOptions{}.hook_max_mm);
}

}  // namespace
}  // namespace felt::pen_filter_test
