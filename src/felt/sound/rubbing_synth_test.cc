#include "felt/sound/rubbing_synth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "felt/geometry/height_field.h"
#include "felt/material/relief.h"
#include "felt/sound/testing/rubbed.h"

namespace felt::rubbing_synth_test {
namespace {

/// Returns the sound of a stroke without its touch.
std::vector<float> rubbed(const RubbingPair& pair, const RubbedStroke& stroke) {
  return after(sound_of(pair, stroke), 0.1);
}

/// Returns the loudness of a sound, 500 times a second.
std::vector<float> loudness_of(const std::vector<float>& sound) {
  constexpr std::size_t kBlock = 96;
  std::vector<float> blocks;
  for (std::size_t from = 0; from + kBlock <= sound.size(); from += kBlock) {
    const auto first = sound.begin() + static_cast<std::ptrdiff_t>(from);
    blocks.push_back(static_cast<float>(rms_of({first, first + kBlock})));
  }
  return blocks;
}

/// Returns the correlation, -1..1, of two sounds, one of them shifted.
double likeness(const std::vector<float>& a, const std::vector<float>& b, std::size_t shift) {
  double ab = 0.0, aa = 0.0, bb = 0.0;
  double mean_a = 0.0, mean_b = 0.0;
  const std::size_t n = std::min(a.size(), b.size() - shift);
  for (std::size_t i = 0; i < n; ++i) mean_a += static_cast<double>(a[i]);
  for (std::size_t i = 0; i < n; ++i) mean_b += static_cast<double>(b[i + shift]);
  mean_a /= static_cast<double>(n);
  mean_b /= static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(a[i]) - mean_a;
    const double y = static_cast<double>(b[i + shift]) - mean_b;
    ab += x * y;
    aa += x * x;
    bb += y * y;
  }
  return ab / std::sqrt(aa * bb);
}

// R47: the forces, the picture and the sound use the same height field object.
TEST(RubbingSynth, R47_TheEarHasTheReliefOfHandAndEye) {
  for (const SurfaceMaterial& surface : surface_materials()) {
    for (const Medium& medium : media()) {
      EXPECT_EQ(rubbing_pair(surface, medium).relief, surface_grain(surface)) << surface.id;
    }
  }
}

// If two pairs differ only in the relief, the difference is audible.
TEST(RubbingSynth, R47_AnotherReliefIsAnotherSound) {
  const RubbingPair canvas = pair_of("canvas", "pencil");
  RubbingPair other = canvas;
  other.relief = surface_grain(*find_surface("wood"));
  EXPECT_NE(rubbed(canvas, {}), rubbed(other, {}));
}

// The threads of a canvas, 2.5 mm apart, pass 40 times a second at 100 mm/s. The loudness varies
// with them. On a canvas without relief it does not.
TEST(RubbingSynth, R47_TheHillsOfTheReliefAreHeardAsTheyPass) {
  const auto swing = [](const RubbingPair& pair) {
    const auto loud =
        loudness_of(rubbed(pair, {.mm_per_s = 100.0, .seconds = 4.0, .along = {1.0, 0.0}}));
    return std::max(likeness(loud, loud, 12), likeness(loud, loud, 13));  // shifted by one thread
  };
  RubbingPair smooth = pair_of("canvas", "pencil");
  smooth.relief = nullptr;
  EXPECT_GT(swing(pair_of("canvas", "pencil")), 0.25);
  EXPECT_LT(swing(smooth), 0.15);
}

// The noise depends on the position and not on the time, so the same path sounds the same again.
TEST(RubbingSynth, TheSameWaySoundsTheSameTwice) {
  // The last 0.2 s of a path, after another path.
  const auto at_last = [](Point from) {
    RubbingPlayer sound;
    sound.set_pair(pair_of("rough-paper", "pencil"));
    static_cast<void>(sound_of(sound, {.seconds = 0.1, .along = {0.0, 1.0}}));
    const auto all = sound_of(sound, {.seconds = 0.3, .from = from}, 187'654'321);
    return std::vector<float>(all.end() - 9600, all.end());
  };
  const auto once = after(sound_of(pair_of("rough-paper", "pencil"), {.seconds = 0.3}), 0.1);
  const auto again = at_last({20.0, 30.0}), there = at_last({33.0, 12.0});
  double same = 0.0, other = 0.0;
  for (std::size_t shift = 0; shift < 100; ++shift) {
    for (const bool back : {false, true}) {
      const auto like = [&](const auto& a, const auto& b) {
        return back ? likeness(b, a, shift) : likeness(a, b, shift);
      };
      same = std::max(same, like(once, again));
      other = std::max(other, like(once, there));
    }
  }
  EXPECT_GT(same, 0.9);
  EXPECT_LT(other, 0.5);
}

TEST(RubbingSynth, MorePushIsLouderOnEveryPair) {
  for (const SurfaceMaterial& surface : surface_materials()) {
    for (const Medium& medium : media()) {
      SCOPED_TRACE(surface.id + " " + medium.id);
      double last = 0.0;
      for (const double push_n : {0.1, 0.3, 0.9, 1.8}) {
        const double now =
            rms_of(rubbed(rubbing_pair(surface, medium), {.push_n = push_n, .seconds = 0.3}));
        EXPECT_GT(now, 1.15 * last) << push_n << " N";
        last = now;
      }
    }
  }
}

/// Returns all surfaces with a pencil, and all media on a blackboard.
std::vector<RubbingPair> pairs() {
  std::vector<RubbingPair> all;
  for (const SurfaceMaterial& surface : surface_materials()) {
    all.push_back(rubbing_pair(surface, *find_medium("pencil")));
  }
  for (const Medium& medium : media()) {
    all.push_back(rubbing_pair(*find_surface("blackboard"), medium));
  }
  return all;
}

TEST(RubbingSynth, MoreSpeedIsLouderAndBrighterOnEveryPairThatDoesNotSqueak) {
  int number = 0;
  for (RubbingPair pair : pairs()) {
    SCOPED_TRACE(number++);
    pair.squeak = 0.0;
    double last = 0.0, last_hz = 0.0;
    for (const double mm_per_s : {15.0, 45.0, 150.0, 450.0}) {
      const auto sound = rubbed(pair, {.mm_per_s = mm_per_s, .seconds = 0.5});
      EXPECT_GT(rms_of(sound), 1.15 * last) << mm_per_s << " mm/s";
      last = rms_of(sound);
      if (mm_per_s > 200.0) continue;  // at its brightest for this pair
      const double hz = centroid_of(sound);
      EXPECT_GT(hz, 1.1 * last_hz) << mm_per_s << " mm/s";
      last_hz = hz;
    }
  }
}

TEST(RubbingSynth, BrighterIsHigherAndLouderIsLouder) {
  for (const bool of_surface : {false, true}) {
    double last_hz = 0.0;
    for (const double bright : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      RubbingPair pair = pair_of("paper", "pencil");
      (of_surface ? pair.surface_brightness : pair.medium_brightness) = bright;
      const double hz = centroid_of(rubbed(pair, {}));
      EXPECT_GT(hz, 1.05 * last_hz) << bright;
      last_hz = hz;
    }
  }
  RubbingPair quiet = pair_of("paper", "pencil");
  quiet.loudness *= 0.5;
  EXPECT_LT(rms_of(rubbed(quiet, {})), 0.55 * rms_of(rubbed(pair_of("paper", "pencil"), {})));
  quiet.loudness = 0.0;
  EXPECT_EQ(rms_of(rubbed(quiet, {})), 0.0);
}

// Surfaces and media differ in sound: in loudness and pitch together by at least 0.1 in log2.
TEST(RubbingSynth, EverySurfaceAndEveryMediumHasItsOwnSound) {
  struct Received {
    std::string name;
    double rms, hz;
  };
  std::vector<Received> surfaces, pens;
  for (const SurfaceMaterial& surface : surface_materials()) {
    const auto sound = rubbed(rubbing_pair(surface, *find_medium("pencil")), {.seconds = 1.0});
    surfaces.push_back({surface.id, rms_of(sound), centroid_of(sound)});
  }
  for (const Medium& medium : media()) {
    const auto sound = rubbed(rubbing_pair(*find_surface("paper"), medium), {.seconds = 1.0});
    pens.push_back({medium.id, rms_of(sound), centroid_of(sound)});
  }
  for (const auto& all : {surfaces, pens}) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const double loud = std::fabs(std::log2(all[i].rms / all[j].rms));
        const double high = std::fabs(std::log2(all[i].hz / all[j].hz));
        EXPECT_GT(loud + high, 0.10) << all[i].name << " " << all[j].name;
      }
    }
  }
}

/// Returns the fraction of the power that is in the strongest band of a third of an octave.
double tone_of(const std::vector<float>& sound) {
  const auto bands = spectrum_of(sound);
  double all = 0.0;
  for (const double band : bands) all += band;
  return *std::max_element(bands.begin(), bands.end()) / all;
}

TEST(RubbingSynth, ChalkThatIsPushedHardSqueaksOnABoardAndNotOnFelt) {
  const RubbedStroke hard{.mm_per_s = 80.0, .push_n = 1.6};
  EXPECT_GT(tone_of(rubbed(pair_of("blackboard", "chalk"), hard)), 0.5);
  EXPECT_LT(tone_of(rubbed(pair_of("felt", "chalk"), hard)), 0.35);
  EXPECT_LT(tone_of(rubbed(pair_of("blackboard", "pencil"), hard)), 0.35);
  const RubbedStroke light{.mm_per_s = 80.0, .push_n = 0.4};
  EXPECT_LT(tone_of(rubbed(pair_of("blackboard", "chalk"), light)), 0.35);
  const RubbedStroke fast{.mm_per_s = 500.0, .push_n = 1.6};
  EXPECT_LT(tone_of(rubbed(pair_of("blackboard", "chalk"), fast)), 0.35);
}

}  // namespace
}  // namespace felt::rubbing_synth_test
