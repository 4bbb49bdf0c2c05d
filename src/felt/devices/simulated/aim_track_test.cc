#include "felt/devices/simulated/aim_track.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/rt/servo.h"

namespace felt::aim_track_test {
namespace {

struct Reported {
  std::int64_t time_ns = 0;     // when the hand was there
  std::int64_t arrives_ns = 0;  // when the program receives it
  Vec3 place;
};

/// Returns `count` different positions, reported every `interval_ns`.
std::vector<Reported> steady(int count, std::int64_t interval_ns) {
  std::vector<Reported> reported;
  for (int i = 0; i < count; ++i) {
    const std::int64_t time_ns = 50 * kMs + i * interval_ns;
    reported.push_back({time_ns, time_ns, {10.0 + 0.05 * i, 30.0 + 5.0 * std::sin(0.05 * i), 0.0}});
  }
  return reported;
}

/// Delays the arrivals in bursts, by up to `max_ns`. The sequence of arrivals stays the same.
void delay(std::vector<Reported>& reported, std::int64_t max_ns, Random& random) {
  std::int64_t burst_end_ns = 0;
  for (Reported& t : reported) {
    if (t.time_ns > burst_end_ns) {
      burst_end_ns = t.time_ns + static_cast<std::int64_t>(random.between(0.0, 1.0) *
                                                           static_cast<double>(max_ns));
    }
    t.arrives_ns = std::max(t.time_ns, burst_end_ns);
  }
}

/// Returns all samples that a loop of 1 kHz reads from a pen that follows these aims.
std::vector<PenSample> play(std::string_view device, std::span<const Reported> reported) {
  SimulatedStylus stylus(*find_stylus_preset(device));
  const auto servo = std::make_unique<Servo>(stylus, ServoOptions{});
  std::vector<PenSample> samples;
  std::size_t next = 0;
  const std::int64_t end_ns = reported.back().arrives_ns + 200 * kMs;
  for (std::int64_t now_ns = 0; now_ns < end_ns; now_ns += kMs) {
    for (; next < reported.size() && reported[next].arrives_ns <= now_ns; ++next) {
      stylus.aim_at(reported[next].time_ns, {reported[next].place, 0.5, 0});
    }
    servo->step(now_ns);
    PenSample sample;
    while (servo->for_edit().pop(sample)) samples.push_back(sample);
  }
  return samples;
}

/// Returns the samples at the positions of `told`, in the same sequence. The test fails if a
/// position has no sample.
std::vector<PenSample> find_all(std::span<const PenSample> samples,
                                std::span<const Reported> reported) {
  std::vector<PenSample> found;
  auto at = samples.begin();
  for (const Reported& t : reported) {
    at =
        std::find_if(at, samples.end(), [&t](const PenSample& s) { return s.position == t.place; });
    if (at == samples.end()) {
      ADD_FAILURE() << "place " << found.size() << " of " << reported.size() << " is in no sample";
      return found;
    }
    found.push_back(*at);
  }
  return found;
}

void expect_times_grow(std::span<const PenSample> samples) {
  for (std::size_t i = 1; i < samples.size(); ++i) {
    ASSERT_GT(samples[i].time_ns, samples[i - 1].time_ns) << i;
  }
}

// At any rate and any delay, the samples contain every position in the right sequence.
TEST(AimTrack, NoPlaceIsSkipped) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    static constexpr std::int64_t kIntervals[] = {8 * kMs, 5 * kMs, 2 * kMs, kMs, 500'000, 125'000};
    std::vector<Reported> reported = steady(1000, kIntervals[seed % std::size(kIntervals)]);
    delay(reported, static_cast<std::int64_t>(random.between(0, 40)) * kMs, random);
    const std::vector<PenSample> samples = play("tablet", reported);
    expect_times_grow(samples);
    EXPECT_EQ(find_all(samples, reported).size(), 1000u);
  }
}

// A tablet reports its tilt 133 times a second. Between two reports the tilt changes evenly, like
// the position.
TEST(AimTrack, TiltMovesOnTheWay) {
  AimTrack track(AimTrack::Play::kJoined);
  track.push({{{0, 0, 0}, 0.5, 0, 20.0}, 0}, 0);
  track.push({{{8, 0, 0}, 0.5, 0, 60.0}, 8 * kMs}, 8 * kMs);
  bool has_moved = false;
  for (std::int64_t now_ns = 8 * kMs; now_ns < 40 * kMs; now_ns += kMs) {
    if (now_ns == 16 * kMs) track.push({{{16, 0, 0}, 0.5, 0, {}}, now_ns}, now_ns);
    while (track.due(now_ns)) track.pass();
    const Aim aim = track.at(now_ns);
    if (aim.target_mm.x <= 8.0) {
      ASSERT_TRUE(aim.tilt_deg.has_value());
      EXPECT_NEAR(*aim.tilt_deg, 20.0 + 5.0 * aim.target_mm.x, 1e-9);
      has_moved = has_moved || (aim.target_mm.x > 0.0 && aim.target_mm.x < 8.0);
    }
  }
  EXPECT_TRUE(has_moved);
  EXPECT_EQ(track.at(40 * kMs).tilt_deg, std::nullopt);
}

// After a stall of 1.5 s all waiting aims are played, and the delay is the same as before.
TEST(AimTrack, CatchesUpAfterAStall) {
  std::vector<Reported> reported = steady(4000, kMs);
  for (std::size_t i = 500; i < 2000; ++i) reported[i].arrives_ns = reported[2000].time_ns;
  const std::vector<PenSample> samples = play("tablet", reported);
  expect_times_grow(samples);
  const std::vector<PenSample> found = find_all(samples, reported);
  ASSERT_EQ(found.size(), reported.size());
  EXPECT_LT(found.back().time_ns - reported.back().time_ns, AimTrack::kMaxDelayNs);
}

// Events that arrive up to 8 ms late, several at once, keep their original spacing and are never
// older than the limit of the delay.
TEST(AimTrack, KeepsTheSpacing) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<Reported> reported = steady(1500, 2 * kMs);
    delay(reported, 8 * kMs, random);
    const std::vector<PenSample> found = find_all(play("tablet", reported), reported);
    ASSERT_EQ(found.size(), reported.size());
    int uneven = 0;
    for (std::size_t i = 500; i < found.size(); ++i) {
      const std::int64_t spacing_ns = found[i].time_ns - found[i - 1].time_ns;
      uneven += std::abs(spacing_ns - 2 * kMs) > kMs / 2 ? 1 : 0;
      EXPECT_LE(found[i].time_ns - reported[i].arrives_ns, AimTrack::kMaxDelayNs + kMs);
    }
    EXPECT_LT(uneven, 50) << "of 1000";
  }
}

// The delay of a steady tablet is one event interval plus about one tick.
TEST(AimTrack, ASteadyTabletIsHardlyDelayed) {
  for (const auto& [interval_ns, max_ns] :
       {std::pair<std::int64_t, std::int64_t>{kMs, 3 * kMs}, {5 * kMs, 7 * kMs}}) {
    const std::vector<Reported> reported = steady(1000, interval_ns);
    const std::vector<PenSample> found = find_all(play("tablet", reported), reported);
    ASSERT_EQ(found.size(), reported.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_LE(found[i].time_ns - reported[i].time_ns, max_ns) << i;
    }
  }
}

// Between two positions of a slow tablet the pen moves evenly and does not jump.
TEST(AimTrack, JoinsPlacesEvenly) {
  const std::vector<Reported> reported = steady(200, 8 * kMs);
  const std::vector<PenSample> samples = play("tablet", reported);
  double longest_mm = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (samples[i - 1].pressure.value_or(0.0) == 0.0) continue;
    longest_mm = std::max(longest_mm, norm(samples[i].position - samples[i - 1].position));
  }
  double longest_reported_mm = 0.0;
  for (std::size_t i = 1; i < reported.size(); ++i) {
    longest_reported_mm =
        std::max(longest_reported_mm, norm(reported[i].place - reported[i - 1].place));
  }
  EXPECT_LT(longest_mm, 0.3 * longest_reported_mm);
}

// A pen with a body also keeps every touch, even if several touches arrive together.
TEST(AimTrack, TouchesOfAHandWithABodyAreKept) {
  SimulatedStylus stylus(*find_stylus_preset("touch"));
  std::int64_t now_ns = 0;
  stylus.aim_at(0, {{10, 10, 4}, {}, 0});
  for (; now_ns < 300 * kMs; now_ns += kMs) static_cast<void>(stylus.read(now_ns));
  for (int i = 0; i < 5; ++i) {
    stylus.aim_at(now_ns, {{10, 10, 4}, {}, 1});
    stylus.aim_at(now_ns, {{10, 10, 4}, {}, 0});
  }
  int presses = 0;
  bool was_down = false;
  for (int i = 0; i < 300; ++i, now_ns += kMs) {
    const bool is_down = stylus.read(now_ns)->buttons == 1;
    presses += is_down && !was_down ? 1 : 0;
    was_down = is_down;
    ASSERT_TRUE(stylus.write({}).has_value());
  }
  EXPECT_EQ(presses, 5);
}

TEST(AimTrack, SurvivesAnyTimes) {
  for (const char* device : {"tablet", "touch"}) {
    Random random(5);
    SimulatedStylus stylus(*find_stylus_preset(device));
    std::int64_t now_ns = 0;
    for (int i = 0; i < 3000; ++i) {
      now_ns += i % 100 == 99 ? -20 * kMs : kMs;
      static constexpr std::int64_t kOdd[] = {INT64_MIN, INT64_MAX, 0, -kMs};
      const bool odd = i % 5 == 0;
      stylus.aim_at(odd ? kOdd[(i / 5) % 4] : now_ns - 3 * kMs,
                    {{random.between(0, 50), random.between(0, 50), 0.0}, 0.5, 0});
      if (i % 50 == 0) stylus.aim({20, 20, 0}, 0.5, 0);
      const auto sample = stylus.read(now_ns);
      ASSERT_TRUE(sample.has_value());
      ASSERT_TRUE(is_finite(sample->position) && is_finite(sample->velocity));
      ASSERT_LE(sample->time_ns, now_ns);
      ASSERT_TRUE(stylus.write({}).has_value());
    }
  }
}

}  // namespace
}  // namespace felt::aim_track_test
