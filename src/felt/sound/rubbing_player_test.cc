#include "felt/sound/rubbing_player.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <random>

#include "felt/base/constants.h"
#include "felt/sound/testing/rubbed.h"

namespace {
std::size_t allocations = 0;  // allocations of this program, which has one thread
}  // namespace

// Not inline, because g++ would warn about `delete` of memory from malloc.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  std::abort();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace felt::rubbing_player_test {
namespace {

std::vector<float> rendered(RubbingPlayer& sound, double seconds) {
  std::vector<float> samples(static_cast<std::size_t>(seconds * RubbingPlayer::kRateHz));
  sound.render(samples);
  return samples;
}

bool is_zero(const std::vector<float>& sound) {
  return std::all_of(sound.begin(), sound.end(), [](float s) { return s == 0.0F; });
}

float steepest(const std::vector<float>& sound) {
  float largest = 0.0F;
  for (std::size_t i = 1; i < sound.size(); ++i) {
    largest = std::max(largest, std::fabs(sound[i] - sound[i - 1]));
  }
  return largest;
}

/// A part of the path of a hand: its speed, push and duration.
struct Leg {
  double mm_per_s, push_n, seconds;
};
std::vector<float> sound_of_legs(const RubbingPair& pair, const std::vector<Leg>& legs) {
  RubbingPlayer sound;
  sound.set_pair(pair);
  std::vector<float> all;
  double x = 10.0;
  std::int64_t time_ns = 0;
  for (const Leg& leg : legs) {
    for (int i = 0; i < static_cast<int>(leg.seconds * 1000.0); ++i, time_ns += kMs) {
      x += 0.001 * leg.mm_per_s;
      sound.push({time_ns, {x, 0.5 * x}, leg.push_n, 0.0});
      const std::size_t had = all.size();
      all.resize(had + sound.ready());
      sound.render(std::span(all).subspan(had));
    }
  }
  return all;
}

TEST(RubbingPlayer, IsAsLongAsTheWay) {
  RubbingPlayer sound;
  EXPECT_EQ(sound.ready(), 0u);
  sound.push({5 * kMs, {}, 0.0, 0.0});
  EXPECT_EQ(sound.ready(), 1u);
  sound.push({1005 * kMs, {}, 0.0, 0.0});
  EXPECT_EQ(sound.ready(), 48001u);
  rendered(sound, 0.5);
  EXPECT_EQ(sound.ready(), 24001u);
}

TEST(RubbingPlayer, IsSilentInTheAirAtRestAndBeforeTheFirstSample) {
  RubbingPlayer sound;
  sound.set_pair(pair_of("canvas", "chalk"));
  EXPECT_TRUE(is_zero(rendered(sound, 0.1)));
  EXPECT_TRUE(is_zero(sound_of_legs(pair_of("canvas", "chalk"), {{200.0, 0.0, 1.0}})));
  // A pen that came down and stands still makes only the sound of the touch.
  const auto stands = sound_of_legs(pair_of("canvas", "chalk"), {{0.0, 0.0, 0.1}, {0.0, 1.0, 0.5}});
  EXPECT_FALSE(is_zero(stands));
  EXPECT_TRUE(is_zero(after(stands, 0.15)));
}

TEST(RubbingPlayer, IsSilent50MsAfterThePenIsLiftedOrStandsOnEveryPair) {
  for (const SurfaceMaterial& surface : surface_materials()) {
    for (const Medium& medium : media()) {
      SCOPED_TRACE(surface.id + " " + medium.id);
      for (const Leg& end : {Leg{300.0, 0.0, 0.3}, Leg{0.0, 1.5, 0.3}}) {
        const auto all = sound_of_legs(rubbing_pair(surface, medium), {{300.0, 1.5, 0.2}, end});
        EXPECT_GT(rms_of(all), 1e-4);
        EXPECT_TRUE(is_zero(after(all, 0.2 + RubbingSynth::kSilentAfterS)));
      }
    }
  }
}

/// A jump of the device must not sound like very fast motion.
TEST(RubbingPlayer, ALeapIsNoSound) {
  RubbingPlayer sound;
  sound.set_pair(pair_of("canvas", "chalk"));
  for (int i = 0; i < 100; ++i) sound.push({i * kMs, {i < 50 ? 10.0 : 90.0, 5.0}, 1.0, 0.0});
  std::vector<float> all(sound.ready());
  sound.render(all);
  const auto first = all.begin() + 2000;  // the touch is over
  EXPECT_TRUE(is_zero({first, all.end()}));
}

// A click is a step that is larger than any in the steady sound.
TEST(RubbingPlayer, BeginningAndEndingAddNoLeap) {
  for (const char* medium : {"pencil", "chalk", "eraser"}) {
    SCOPED_TRACE(medium);
    const RubbingPair pair = pair_of("blackboard", medium);
    const float steady = steepest(after(sound_of_legs(pair, {{300.0, 1.6, 2.0}}), 0.1));
    std::vector<Leg> legs;
    for (int i = 0; i < 40; ++i) {
      legs.insert(legs.end(), {{300.0, 1.6, 0.03}, {300.0, 0.0, 0.03}, {0.0, 1.6, 0.03}});
    }
    EXPECT_LE(steepest(sound_of_legs(pair, legs)), 1.1F * steady);
  }
}

// A touch is audible, but not louder than rubbing.
TEST(RubbingPlayer, ATouchIsModest) {
  for (const char* medium : {"pencil", "chalk", "brush-pen"}) {
    const RubbingPair pair = pair_of("paper", medium);
    const auto peak = [](const std::vector<float>& sound) {
      float largest = 0.0F;
      for (const float s : sound) largest = std::max(largest, std::fabs(s));
      return largest;
    };
    RubbingPlayer sound;
    sound.set_pair(pair);
    sound.push({0, {}, 0.0, 0.0});
    sound.push({10 * kMs, {}, 1.0, 150.0});
    sound.push({50 * kMs, {}, 1.0, 0.0});
    const float touch = peak(rendered(sound, 0.05));
    EXPECT_GT(touch, 0.005F) << medium;
    EXPECT_LT(touch, 1.5F * peak(after(sound_of_legs(pair, {{150.0, 1.0, 1.0}}), 0.1))) << medium;
  }
}

TEST(RubbingPlayer, TheSameCallsGiveTheSameSamples) {
  const std::vector<Leg> legs{
      {80.0, 0.4, 0.2}, {300.0, 1.2, 0.2}, {50.0, 0.0, 0.1}, {9.0, 2.0, 0.2}};
  const auto once = sound_of_legs(pair_of("wood", "felt-tip"), legs);
  EXPECT_EQ(once, sound_of_legs(pair_of("wood", "felt-tip"), legs));
  EXPECT_NE(once, sound_of_legs(pair_of("wood", "pencil"), legs));
  // The size of the blocks does not matter.
  RubbingPlayer whole, pieces;
  for (RubbingPlayer* sound : {&whole, &pieces}) {
    sound->set_pair(pair_of("wood", "felt-tip"));
    for (int i = 0; i < 200; ++i) sound->push({i * kMs, {0.2 * i, 0.0}, 0.7, 0.0});
  }
  std::vector<float> parts;
  while (pieces.ready() > 0) {
    const auto part = rendered(
        pieces, std::min<double>(7.0, static_cast<double>(pieces.ready())) / 48000.0 + 1e-9);
    parts.insert(parts.end(), part.begin(), part.end());
  }
  std::vector<float> all(parts.size());
  whole.render(all);
  EXPECT_EQ(all, parts);
}

// The tool changes in the middle of a stroke: the old sound fades out, then the new one begins.
TEST(RubbingPlayer, AnotherPairComesWithoutAClick) {
  RubbingPlayer sound;
  sound.set_pair(pair_of("paper", "pencil"));
  auto all = sound_of(sound, {.seconds = 0.5});
  const float steady =
      std::max(steepest(after(all, 0.1)),
               steepest(after(sound_of(pair_of("paper", "eraser"), RubbedStroke{}), 0.1)));
  sound.set_pair(pair_of("paper", "eraser"));
  const auto then = sound_of(sound, {.seconds = 0.5, .from = {80.0, 75.0}}, 500 * kMs);
  EXPECT_LE(steepest(then), 1.1F * steady);
  EXPECT_GT(rms_of(after(then, 0.2)), 1e-3);
}

double any_number(std::mt19937& random) {
  const double odd[] = {0.0,
                        1.0,
                        -3.0,
                        80.0,
                        1e5,
                        -1e9,
                        1e300,
                        1e-310,
                        std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<double>::infinity()};
  return odd[random() % std::size(odd)];
}

TEST(RubbingPlayer, WhateverIsToldItIsBoundedAndFiniteAndNormal) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    RubbingPlayer sound;
    std::int64_t time_ns = 0;
    for (int i = 0; i < 1500; ++i) {
      if (random() % 100 == 0) {
        RubbingPair pair = rubbing_pair(surface_materials()[random() % surface_materials().size()],
                                        media()[random() % media().size()]);
        if (random() % 2) {
          pair.friction = any_number(random);
          pair.loudness = any_number(random);
          pair.stiffness_n_per_m = any_number(random);
          pair.medium_brightness = any_number(random);
          pair.grain_um = any_number(random);
        }
        sound.set_pair(pair);
      }
      time_ns += static_cast<std::int64_t>(random() % 4) * kMs - (random() % 50 == 0 ? 3 * kMs : 0);
      const bool is_odd = random() % 8 == 0;
      const double x = is_odd ? any_number(random) : static_cast<double>(random() % 100);
      sound.push({time_ns,
                  {x, is_odd ? any_number(random) : 5.0},
                  is_odd ? any_number(random) : 0.01 * static_cast<double>(random() % 200),
                  any_number(random)});
      if (random() % 3 == 0) sound.keep_up(0.02);
      for (const float s : rendered(sound, 0.001 * static_cast<double>(random() % 3))) {
        ASSERT_TRUE(std::isfinite(s));
        ASSERT_LT(std::fabs(s), 1.0F);
        ASSERT_TRUE(s == 0.0F || std::isnormal(s));
      }
    }
  }
}

TEST(RubbingPlayer, RealTimeTakesNoMemory) {
  RubbingPlayer sound;
  const RubbingPair pencil = pair_of("canvas", "pencil"), chalk = pair_of("blackboard", "chalk");
  std::vector<float> block(256);
  const std::size_t before = allocations;
  for (int i = 0; i < 2000; ++i) {
    if (i % 500 == 0) sound.set_pair(i % 1000 == 0 ? pencil : chalk);
    sound.push({i * kMs, {0.15 * i, 0.0}, i % 300 < 250 ? 1.0 : 0.0, 0.0});
    sound.keep_up(0.02);
    sound.render(std::span(block).first(48));
  }
  EXPECT_EQ(allocations, before);
}

/// A loudspeaker that needs 10 ms at a time, and a path that arrives every 8 ms.
struct Loudspeaker {
  RubbingPlayer sound;
  std::int64_t pen_ns = 0;
  std::vector<float> heard;
  void pen(int ms) {
    for (int i = 0; i < ms; ++i, pen_ns += kMs) {
      sound.push({pen_ns, {1e-6 * static_cast<double>(pen_ns) * 0.15, 0.0}, 0.8, 0.0});
    }
  }
  void play(int ms) {
    sound.keep_up(0.02);
    const auto block = rendered(sound, 0.001 * ms);
    heard.insert(heard.end(), block.begin(), block.end());
  }
};

TEST(RubbingPlayer, InTimeItStaysWithThePen) {
  Loudspeaker loudspeaker;
  loudspeaker.sound.set_pair(pair_of("paper", "pencil"));
  for (int i = 0; i < 100; ++i) {
    loudspeaker.pen(5);
    if (i % 2 == 1) loudspeaker.play(10);
  }
  EXPECT_LT(loudspeaker.sound.ready(), 0.035 * 48000.0);
  const float steady = steepest(after(loudspeaker.heard, 0.1));
  EXPECT_GT(steady, 0.0F);
  // The window freezes for half a second. It sounds as if the pen stopped and then continued.
  loudspeaker.heard.clear();
  for (int i = 0; i < 50; ++i) loudspeaker.play(10);
  EXPECT_TRUE(is_zero(after(loudspeaker.heard, 0.1)));
  loudspeaker.pen(500);
  for (int i = 0; i < 50; ++i) {
    loudspeaker.pen(10);
    loudspeaker.play(10);
  }
  EXPECT_LT(loudspeaker.sound.ready(), 0.05 * 48000.0);
  EXPECT_LE(steepest(loudspeaker.heard), 1.5F * steady);
  EXPECT_GT(rms_of(after(loudspeaker.heard, 0.7)), 1e-3);
}

}  // namespace
}  // namespace felt::rubbing_player_test
