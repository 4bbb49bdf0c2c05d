#include "desktop/feel/friction_synth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace felt::desktop {
namespace {

constexpr double kRate = 48000.0;

std::vector<float> rubbed(FrictionSynth& synth, const Rubbing& rubbing, double seconds) {
  std::vector<float> samples(static_cast<std::size_t>(seconds * kRate));
  synth.rub(rubbing);
  synth.render(samples);
  return samples;
}

Rubbing on(const char* material, double speed, double force) {
  return {speed, force, timbre_of(*find_surface(material))};
}

double rms(const std::vector<float>& samples) {
  double sum = 0.0;
  for (const float s : samples) sum += static_cast<double>(s) * static_cast<double>(s);
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

// Crossings of zero a second: twice the middle pitch.
double crossings(const std::vector<float>& samples) {
  int count = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    count += (samples[i] > 0.0F) != (samples[i - 1] > 0.0F) ? 1 : 0;
  }
  return count * kRate / static_cast<double>(samples.size());
}

TEST(FrictionSynth, IsSilentInTheAirAndAtRest) {
  FrictionSynth synth(kRate);
  EXPECT_EQ(rms(rubbed(synth, on("paper", 0.0, 0.0), 0.2)), 0.0);
  EXPECT_GT(rms(rubbed(synth, on("paper", 150.0, 0.3), 0.5)), 0.005);
  rubbed(synth, on("paper", 0.0, 0.0), 0.2);  // fades
  EXPECT_EQ(rms(rubbed(synth, on("paper", 0.0, 0.0), 0.2)), 0.0);
  rubbed(synth, on("paper", 150.0, 0.0), 0.2);  // moves without touching
  EXPECT_EQ(rms(rubbed(synth, on("paper", 150.0, 0.0), 0.2)), 0.0);
}

TEST(FrictionSynth, MoreForceIsLouderAndMoreSpeedIsHigher) {
  for (const char* material : {"paper", "blackboard", "felt", "glass"}) {
    SCOPED_TRACE(material);
    FrictionSynth synth(kRate);
    const auto sound = [&](double speed, double force) {
      rubbed(synth, on(material, speed, force), 0.1);
      return rubbed(synth, on(material, speed, force), 2.0);
    };
    double last = 0.0;
    for (const double force : {0.05, 0.15, 0.3, 0.6}) {
      const double now = rms(sound(120.0, force));
      EXPECT_GT(now, 1.3 * last);
      last = now;
    }
    EXPECT_GT(crossings(sound(100.0, 0.3)), 1.2 * crossings(sound(25.0, 0.3)));
  }
}

TEST(FrictionSynth, MaterialsSoundDifferent) {
  const auto sound = [](const char* material) {
    FrictionSynth synth(kRate);
    rubbed(synth, on(material, 150.0, 0.3), 0.1);
    return rubbed(synth, on(material, 150.0, 0.3), 1.0);
  };
  const auto paper = sound("paper"), felt = sound("felt"), glass = sound("glass");
  EXPECT_GT(crossings(paper), 1.5 * crossings(felt));
  EXPECT_LT(rms(glass), 0.5 * rms(paper));
  EXPECT_GT(crossings(sound("blackboard")), crossings(paper));
}

TEST(FrictionSynth, WhateverIsToldItIsBoundedFiniteAndWithoutClicks) {
  const double odd[] = {0.0,
                        1.0,
                        80.0,
                        900.0,
                        1e9,
                        -5.0,
                        std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<double>::infinity()};
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    FrictionSynth synth(kRate);
    const auto any = [&] { return odd[random() % std::size(odd)]; };
    for (int i = 0; i < 400; ++i) {
      const RubTimbre timbre =
          seed % 2 ? timbre_of(surface_materials()[random() % 4]) : RubTimbre{any(), any(), any()};
      for (const float s : rubbed(synth, {any(), any(), timbre}, 0.005)) {
        ASSERT_TRUE(std::isfinite(s));
        ASSERT_LE(std::fabs(s), static_cast<float>(FrictionSynth::kLoudest));
      }
    }
  }
}

// What a click would be: a leap that is larger than any within the steady sound.
TEST(FrictionSynth, BeginningAndEndingAddNoLeap) {
  const auto steepest = [](const std::vector<float>& samples) {
    float most = 0.0F;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      most = std::max(most, std::fabs(samples[i] - samples[i - 1]));
    }
    return most;
  };
  FrictionSynth synth(kRate);
  rubbed(synth, on("blackboard", 200.0, 0.6), 0.2);
  const float steady = steepest(rubbed(synth, on("blackboard", 200.0, 0.6), 2.0));
  std::vector<float> all;
  for (int i = 0; i < 40; ++i) {
    for (const auto& now : {on("blackboard", 200.0, 0.6), on("blackboard", 0.0, 0.0)}) {
      const std::vector<float> part = rubbed(synth, now, 0.03);
      all.insert(all.end(), part.begin(), part.end());
    }
  }
  EXPECT_LE(steepest(all), 1.05F * steady);
}

TEST(FrictionSynth, HighSoundsDoNotFoldBack) {
  // A pen that is much faster than the grain is fine still sounds no brighter than the material.
  FrictionSynth slow(kRate), fast(kRate);
  rubbed(fast, on("felt", 3000.0, 0.3), 0.1);
  EXPECT_LT(crossings(rubbed(fast, on("felt", 3000.0, 0.3), 1.0)), 2.0 * 3000.0);
}

TEST(FrictionSynth, TheSameCallsGiveTheSameSamples) {
  FrictionSynth a(kRate), b(kRate);
  for (int i = 0; i < 20; ++i) {
    const Rubbing now = on("paper", 20.0 * i, 0.03 * i);
    EXPECT_EQ(rubbed(a, now, 0.01), rubbed(b, now, 0.01));
  }
}

}  // namespace
}  // namespace felt::desktop
