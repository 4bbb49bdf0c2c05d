#include "felt/devices/simulated/writing_hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "felt/devices/simulated/hand_path.h"
#include "felt/devices/simulated/samples/drawings.h"
#include "felt/devices/simulated/samples/sample_sets.h"

namespace felt::writing_hand_test {
namespace {

TEST(WritingHand, TheSameSeedDrawsTheSame) {
  for (const Gesture& g : exercise_page()) {
    const auto samples = WritingHand({.seed = 4}).draw(g);
    EXPECT_EQ(samples, WritingHand({.seed = 4}).draw(g));
    EXPECT_NE(samples, WritingHand({.seed = 5}).draw(g));
  }
}

TEST(WritingHand, SamplesAreThoseOfATablet) {
  for (const std::int64_t interval_ns : {7'500'000, 1'000'000}) {
    WritingHand hand({.interval_ns = interval_ns});
    std::int64_t last_ns = -1;
    for (const Gesture& g : cat_drawing()) {
      const auto stroke = hand.draw(g);
      ASSERT_FALSE(stroke.empty());
      EXPECT_GT(stroke.front().time_ns, last_ns);
      for (std::size_t i = 0; i < stroke.size(); ++i) {
        const HandSample& s = stroke[i];
        EXPECT_NEAR(std::remainder(s.position.x, 0.03), 0.0, 1e-9);
        EXPECT_GT(s.pressure, 0.0);
        EXPECT_LE(s.pressure, 1.0);
        if (i == 0) continue;
        EXPECT_EQ(s.time_ns - stroke[i - 1].time_ns, interval_ns);
        const double mm = distance(s.position, stroke[i - 1].position);
        EXPECT_LT(mm / (static_cast<double>(interval_ns) * 1e-9), 600.0);  // mm/s
      }
      last_ns = stroke.back().time_ns;
    }
  }
}

TEST(WritingHand, DrawsAnyGesture) {
  WritingHand hand;
  std::size_t samples = 0;
  for (const Gesture& g : random_gestures(11, 500)) {
    const auto stroke = hand.draw(g);
    ASSERT_FALSE(stroke.empty());
    samples += stroke.size();
    for (const HandSample& s : stroke) {
      ASSERT_TRUE(is_finite(s.position));
      ASSERT_TRUE(s.pressure > 0.0 && s.pressure <= 1.0);
    }
  }
  EXPECT_GT(samples, 10'000u);
}

TEST(WritingHand, StaysNearTheAim) {
  const auto stroke = WritingHand({.seed = 9}).draw(straight_line({10.0, 10.0}, {90.0, 10.0}));
  for (const HandSample& s : stroke) EXPECT_NEAR(s.position.y, 10.0, 0.8);
  EXPECT_NEAR(stroke.front().position.x, 10.0, 0.8);
  EXPECT_NEAR(stroke.back().position.x, 90.0, 1.2);
}

TEST(WritingHand, PressureRisesAndFalls) {
  const auto stroke = WritingHand().draw(straight_line({10.0, 10.0}, {90.0, 10.0}));
  const double middle = stroke[stroke.size() / 2].pressure;
  EXPECT_LT(stroke.front().pressure, 0.7 * middle);
  EXPECT_LT(stroke.back().pressure, 0.7 * middle);
}

TEST(WritingHand, ADotIsSmall) {
  const auto dot = WritingHand().draw({.via = {{5.0, 5.0}}});
  ASSERT_GE(dot.size(), 3u);
  for (const HandSample& s : dot) EXPECT_LT(distance(s.position, {5.0, 5.0}), 0.8);
  EXPECT_TRUE(WritingHand().draw({}).empty());
}

TEST(HandPath, PassesThroughTheViaPoints) {
  const std::vector<Point> via{{0, 0}, {10, 3}, {12, 9}, {12, 9}, {4, 9}};
  const auto path = smooth_path(via);
  for (const Point p : via) {
    const auto nearest = std::min_element(path.begin(), path.end(), [p](Point a, Point b) {
      return distance(a, p) < distance(b, p);
    });
    EXPECT_LT(distance(*nearest, p), 1e-9);
  }
}

// Tests v ~ curvature^(-1/3) on circles, because there the hand has time to reach its speed.
TEST(HandPath, KeepsTheTwoThirdsPowerLaw) {
  const auto speed_on_circle = [](double radius_mm) {
    std::vector<Point> via;
    for (int i = 0; i <= 60; ++i) {
      via.push_back({radius_mm * std::cos(0.3 * i), radius_mm * std::sin(0.3 * i)});
    }
    const auto timed = pace(smooth_path(via), 1.0);
    const TimedPoint a = timed[timed.size() / 3], b = timed[timed.size() / 3 + 40];
    return distance(a.position, b.position) / (b.t_s - a.t_s);
  };
  EXPECT_NEAR(std::log(speed_on_circle(8.0) / speed_on_circle(2.0)) / std::log(4.0), 1.0 / 3.0,
              0.03);
}

TEST(HandPath, StopsInCorners) {
  const auto timed = pace(smooth_path(zigzag({0, 0}, {6, 10}, 3).via), 1.0);
  for (std::size_t i = 1; i < timed.size(); ++i) {
    const double mm = distance(timed[i - 1].position, timed[i].position);
    if (std::fabs(timed[i].position.y - 10.0) > 0.02 || mm == 0.0) continue;
    EXPECT_LT(mm / (timed[i].t_s - timed[i - 1].t_s), 15.0);
  }
}

std::string read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  for (const char* p = text.c_str(); *p != '\0';) {
    char* end = nullptr;
    const double x = std::strtod(p, &end);
    if (end != p) numbers.push_back(x);
    p = end == p ? p + 1 : end;
  }
  return numbers;
}

// If libm rounds differently, a coordinate may differ by one step of the tablet.
TEST(SampleSets, AreTheFilesInShare) {
  for (const SampleSet& set : make_sample_sets()) {
    const std::string file = read_file("share/samples/" + set.file_name);
    const auto ours = numbers_in(to_ndjson(set)), theirs = numbers_in(file);
    ASSERT_EQ(ours.size(), theirs.size()) << set.file_name;
    std::size_t exact = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      EXPECT_NEAR(ours[i], theirs[i], 0.031) << set.file_name << ", number " << i;
      if (ours[i] == theirs[i]) ++exact;
    }
    EXPECT_GE(static_cast<double>(exact), 0.999 * static_cast<double>(ours.size()));
  }
}

}  // namespace
}  // namespace felt::writing_hand_test
