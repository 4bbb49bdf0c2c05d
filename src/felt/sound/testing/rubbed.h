#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "felt/sound/rubbing_player.h"

/// Helpers for tests and measurements: strokes, and numbers that describe a sound.
namespace felt {

/// Returns the pair of two built-in materials by their ids.
inline RubbingPair pair_of(const char* surface, const char* medium) {
  return rubbing_pair(*find_surface(surface), *find_medium(medium));
}

/// A straight stroke at constant speed and push, with one sample per millisecond.
struct RubbedStroke {
  double mm_per_s = 150.0;
  double push_n = 0.8;
  double seconds = 1.0;
  Vec along{0.8, 0.6};
  Point from{20.0, 30.0};
};

/// Returns the sound of a stroke up to its last sample.
inline std::vector<float> sound_of(RubbingPlayer& sound, const RubbedStroke& stroke,
                                   std::int64_t start_ns = 0) {
  std::vector<float> all;
  const int ticks = static_cast<int>(stroke.seconds * 1000.0);
  for (int i = 0; i < ticks; ++i) {
    const double way = stroke.mm_per_s * 0.001 * i;
    sound.push({start_ns + 1'000'000 * std::int64_t{i}, stroke.from + way * stroke.along,
                stroke.push_n, 0.0});
    const std::size_t had = all.size();
    all.resize(had + sound.ready());
    sound.render(std::span(all).subspan(had));
  }
  return all;
}

inline std::vector<float> sound_of(const RubbingPair& pair, const RubbedStroke& stroke) {
  RubbingPlayer sound;
  sound.set_pair(pair);
  return sound_of(sound, stroke);
}

/// Returns the sound without its first `seconds`, which contain the sound of the touch.
inline std::vector<float> after(const std::vector<float>& sound, double seconds) {
  const auto n = static_cast<std::ptrdiff_t>(seconds * RubbingPlayer::kRateHz);
  return {sound.begin() + n, sound.end()};
}

inline double rms_of(const std::vector<float>& sound) {
  double sum = 0.0;
  for (const float s : sound) sum += static_cast<double>(s) * static_cast<double>(s);
  return std::sqrt(sum / static_cast<double>(sound.size()));
}

/// Returns the power of a block at a frequency, with a Hann window (Goertzel).
inline double power_at(const std::vector<float>& sound, std::size_t from, std::size_t n,
                       double hz) {
  const double w = 2.0 * 3.14159265358979324 * hz / RubbingPlayer::kRateHz;
  const double turn = 2.0 * std::cos(w);
  double s1 = 0.0, s2 = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(n);
    const double window = 0.5 - 0.5 * std::cos(2.0 * 3.14159265358979324 * part);
    const double s = window * static_cast<double>(sound[from + i]) + turn * s1 - s2;
    s2 = s1;
    s1 = s;
  }
  return (s1 * s1 + s2 * s2 - turn * s1 * s2) / static_cast<double>(n * n);
}

/// Returns the power in each of the 26 bands of a third of an octave from 50 Hz to 16 kHz.
inline std::vector<double> spectrum_of(const std::vector<float>& sound) {
  constexpr std::size_t kBlock = 2048;
  std::vector<double> bands;
  for (double hz = 50.0; hz < 16001.0; hz *= 1.25992105) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t from = 0; from + kBlock <= sound.size(); from += kBlock) {
      for (const double part : {0.92, 1.0, 1.08}) sum += power_at(sound, from, kBlock, part * hz);
      count += 3;
    }
    bands.push_back(sum / count * hz);
  }
  return bands;
}

/// Returns the mean frequency in Hz, weighted by power.
inline double centroid_of(const std::vector<float>& sound) {
  double sum = 0.0, all = 0.0, hz = 50.0;
  for (const double power : spectrum_of(sound)) {
    sum += power * hz;
    all += power;
    hz *= 1.25992105;
  }
  return sum / all;
}

}  // namespace felt
