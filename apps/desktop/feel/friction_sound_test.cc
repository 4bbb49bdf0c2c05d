#include "desktop/feel/friction_sound.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <vector>

#include "desktop/engine/settings.h"
#include "desktop/feel/feel_setting_keys.h"
#include "felt/base/constants.h"
#include "felt/material/relief.h"

namespace felt::desktop::friction_sound_test {
namespace {

StudioOptions still() {
  return {.device = QStringLiteral("tablet"), .live = false};
}

/// Draws a stroke with mouse or tablet, with hover movements before and after it.
void draw(Studio& studio, int ms, double pressure = 0.6) {
  for (int i = 0; i < ms; i += 4) {
    studio.point({studio.now_ns(), {20.0 + 0.15 * i, 30.0}, pressure > 0.0, pressure});
    studio.advance(4 * kMs);
  }
}

std::vector<float> read(RubbedSamples& samples, std::size_t count) {
  std::vector<float> all(count);
  const qint64 size = qint64(count * sizeof(float));
  EXPECT_EQ(samples.read(reinterpret_cast<char*>(all.data()), size), size);
  return all;
}

float peak(const std::vector<float>& sound) {
  float largest = 0.0F;
  for (const float s : sound) largest = std::max(largest, std::fabs(s));
  return largest;
}

TEST(FrictionSound, EverySampleOfThePenGoesToTheSoundByTheRing) {
  Studio studio(still());
  RubbedFeed feed;
  PenFeed pen(studio, feed);
  QSignalSpy sampled(&studio, &Studio::sampled);
  draw(studio, 200);
  ASSERT_GE(sampled.count(), 190);
  EXPECT_EQ(feed.samples.size(), std::size_t(sampled.count()));
  ASSERT_TRUE(feed.pair.update());
  const SurfaceMaterial& surface = studio.session().surface();
  EXPECT_EQ(feed.pair.get().relief, surface_grain(surface));  // R47
  RubbingSample sample, last;
  bool pushed = false;
  while (feed.samples.pop(sample)) {
    EXPECT_GT(sample.time_ns, last.time_ns);
    last = sample;
    pushed = pushed || sample.push_n > 0.3;
  }
  EXPECT_TRUE(pushed);
}

TEST(FrictionSound, WhatIsDrawnIsHeardAndWhatHoversIsNot) {
  Studio studio(still());
  RubbedFeed feed;
  feed.volume = 1.0F;
  PenFeed pen(studio, feed);
  RubbedSamples samples(feed, true);
  EXPECT_EQ(peak(read(samples, 4800)), 0.0F);
  const auto heard = [&](double pressure) {
    std::vector<float> all;
    for (int i = 0; i < 30; ++i) {
      draw(studio, 20, pressure);
      const auto part = read(samples, 960);
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  };
  EXPECT_EQ(peak(heard(0.0)), 0.0F);
  EXPECT_GT(peak(heard(0.6)), 0.01F);
  feed.volume = 0.0F;
  static_cast<void>(heard(0.6));
  EXPECT_LT(peak(heard(0.6)), 1e-4F);
  // No samples arrive any more: the sound ends soon and does not start again.
  static_cast<void>(read(samples, 4800));
  EXPECT_EQ(peak(read(samples, 48000)), 0.0F);
}

TEST(FrictionSound, ADeviceOf16BitsHearsTheSame) {
  Studio studio(still());
  RubbedFeed feed, also;
  feed.volume = also.volume = 1.0F;
  PenFeed pen(studio, feed), other(studio, also);
  RubbedSamples floats(feed, true), whole(also, false);
  draw(studio, 100);
  const auto a = read(floats, 4000);
  std::vector<std::int16_t> b(4000);
  ASSERT_EQ(whole.read(reinterpret_cast<char*>(b.data()), 8000), 8000);
  EXPECT_GT(peak(a), 0.0F);
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(b[i], std::lround(32767.0F * a[i])) << i;
  }
}

// When headphones are plugged in, another device continues to read, with the current pair of
// surface and medium.
TEST(FrictionSound, AnotherDeviceHearsThePairThatIsInUse) {
  Studio studio(still());
  studio.apply(SetOption{"surface.material", OptionValue(std::string("canvas"))});
  RubbedFeed feed, also;
  feed.volume = also.volume = 1.0F;
  PenFeed pen(studio, feed), other(studio, also);
  {
    RubbedSamples before(feed, true);
    static_cast<void>(read(before, 480));
    draw(studio, 40);
    static_cast<void>(read(before, 4800));
  }
  RubbedSamples after(feed, true), fresh(also, true);
  RubbingSample lost;
  while (also.samples.pop(lost)) continue;  // read by the previous device
  draw(studio, 100);
  EXPECT_EQ(read(after, 4000), read(fresh, 4000));
}

TEST(FrictionSound, FollowsTheSurfaceAndAnotherDrawing) {
  Studio studio(still());
  RubbedFeed feed;
  PenFeed pen(studio, feed);
  studio.apply(SetOption{"surface.material", OptionValue(std::string("canvas"))});
  draw(studio, 100);
  ASSERT_TRUE(feed.pair.update());
  EXPECT_EQ(feed.pair.get().relief, surface_grain(*find_surface("canvas")));
  studio.open(Document(), studio.page());
  studio.apply(SelectTool{"eraser"});
  draw(studio, 100);
  ASSERT_TRUE(feed.pair.update());
  EXPECT_EQ(feed.pair.get(), [&] {
    RubbingPair pair = rubbing_pair(*find_surface("canvas"), *find_medium("eraser"));
    pair.firm_push_n = feed.pair.get().firm_push_n;
    return pair;
  }());
}

// The tone of the tool Read is heard although the sound of drawing is off.
TEST(FrictionSound, TheToolThatReadsHasATone) {
  Studio studio(still());
  RubbedFeed feed;
  feed.has_rubbing = false;
  feed.volume = 1.0F;
  PenFeed pen(studio, feed);
  RubbedSamples samples(feed, true);
  draw(studio, 200);
  EXPECT_EQ(peak(read(samples, 9600)), 0.0F) << "the pencil is silent";
  draw(studio, 60, 0.0);  // lifted
  studio.apply(SelectTool{"read"});
  draw(studio, 100);
  EXPECT_GT(peak(read(samples, 9600)), 0.05F) << "the line that was drawn is near";
  draw(studio, 60, 0.0);
  studio.apply(SetOption{"read.sound", OptionValue(false)});
  draw(studio, 100);
  read(samples, 9600);
  EXPECT_LT(peak(read(samples, 9600)), 1e-4F);
}

// Sound is off by default. On a machine without a sound device, a message says so, and drawing
// works as before.
TEST(FrictionSound, IsOffAtFirstAndWorksWithoutASoundDevice) {
  Settings::the().reset(QString::fromLatin1(feel_keys::kSound));
  Studio studio(still());
  {
    FrictionSound sound(studio);
    EXPECT_NE(SoundState::the().state(), SoundState::State::kPlaying);
    EXPECT_EQ(SoundState::the().words().isEmpty(), FrictionSound::is_built_in());
    Settings::the().set(QString::fromLatin1(feel_keys::kSound), true);
    draw(studio, 50);
    if (FrictionSound::is_built_in()) {
      EXPECT_TRUE(QTest::qWaitFor(
          [] { return SoundState::the().state() != SoundState::State::kOff; }, 20000));
      EXPECT_EQ(SoundState::the().words().isEmpty(),
                SoundState::the().state() == SoundState::State::kPlaying);
    }
    draw(studio, 50);
    Settings::the().set(QString::fromLatin1(feel_keys::kSound), false);
    EXPECT_NE(SoundState::the().state(), SoundState::State::kPlaying);
  }
  Settings::the().reset(QString::fromLatin1(feel_keys::kSound));
}

}  // namespace
}  // namespace felt::desktop::friction_sound_test
