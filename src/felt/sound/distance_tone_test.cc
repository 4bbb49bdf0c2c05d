#include "felt/sound/distance_tone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace felt::distance_tone_test {
namespace {

std::vector<double> sound_of(DistanceTone& tone, const ToneInput& input, double seconds) {
  tone.set(input);
  std::vector<double> sound(static_cast<std::size_t>(seconds * DistanceTone::kRateHz));
  for (double& s : sound) s = tone.next();
  return sound;
}

int rising_zeros(const std::vector<double>& sound) {
  int count = 0;
  for (std::size_t i = 1; i < sound.size(); ++i) count += sound[i - 1] < 0.0 && sound[i] >= 0.0;
  return count;
}

/// Counts the pulses: how often the loudness of 2 ms rises above a third of the loudest.
int pulses(const std::vector<double>& sound) {
  int count = 0;
  bool was_loud = false;
  for (std::size_t i = 0; i + 240 <= sound.size(); i += 240) {
    double peak = 0.0;
    for (std::size_t k = i; k < i + 240; ++k) peak = std::max(peak, std::abs(sound[k]));
    const bool is_loud = peak > DistanceTone::kLoudness / 3;
    count += is_loud && !was_loud;
    was_loud = is_loud;
  }
  return count;
}

TEST(DistanceTone, IsFasterAndHigherTheNearerTheLineIs) {
  int last_pulses = 0;
  double last_hz = 0.0;
  for (const float mm : {25.0F, 15.0F, 8.0F, 2.0F}) {
    DistanceTone tone;
    const std::vector<double> sound = sound_of(tone, {mm, true}, 2.0);
    const int count = pulses(sound);
    const double hz = rising_zeros(sound) / 2.0;
    EXPECT_GT(count, last_pulses) << mm;
    EXPECT_GT(hz, last_hz) << mm;
    last_pulses = count;
    last_hz = hz;
  }
  EXPECT_NEAR(last_pulses, 22, 2);
}

TEST(DistanceTone, IsSteadyOnALineAndSilentFarAwayOrOff) {
  DistanceTone tone;
  const std::vector<double> on = sound_of(tone, {0.0F, true}, 1.0);
  EXPECT_NEAR(rising_zeros(on), 165, 2);
  EXPECT_EQ(pulses(on), 1);
  for (const ToneInput& quiet : {ToneInput{31.0F, true}, ToneInput{0.0F, false},
                                 ToneInput{std::numeric_limits<float>::infinity(), true},
                                 ToneInput{std::numeric_limits<float>::quiet_NaN(), true}}) {
    sound_of(tone, quiet, 0.1);
    EXPECT_LT(std::abs(sound_of(tone, quiet, 0.1).back()), 1e-6);
  }
  sound_of(tone, {0.0F, false}, 0.1);
  EXPECT_TRUE(tone.is_silent());
}

TEST(DistanceTone, ClicksOnceForEachMark) {
  DistanceTone tone;
  sound_of(tone, {40.0F, true, 3}, 0.1);  // the first click is that of the first input
  const std::vector<double> same = sound_of(tone, {40.0F, true, 3}, 0.1);
  for (const double s : same) EXPECT_LT(std::abs(s), 1e-6);
  const std::vector<double> click = sound_of(tone, {40.0F, true, 4}, 0.1);
  double peak = 0.0;
  for (const double s : click) peak = std::max(peak, std::abs(s));
  EXPECT_GT(peak, 0.3);
  EXPECT_LT(peak, 1.0);
  EXPECT_LT(std::abs(click.back()), 1e-6) << "15 ms";
}

}  // namespace
}  // namespace felt::distance_tone_test
