#include "desktop/feel/rubbed_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace felt::desktop {

PenFeed::PenFeed(Studio& studio, RubbedFeed& feed)
    : studio_(studio), feed_(feed), pen_(studio.session()) {
  connect(&studio_, &Studio::sampled, this, &PenFeed::take);
  connect(&studio_, &Studio::opened, this, [this] { pen_.follow(studio_.session()); });
}

ToneInput tone_of(const Studio& studio) {
  const Reading* reading = studio.session().tool().reading();
  if (!reading || !reading->is_down || !reading->has_sound) {
    return {1e9F, false, reading ? reading->clicks : 0};
  }
  const double mm = std::min(reading->distance_mm, 1e9);
  return {static_cast<float>(mm), true, reading->clicks};
}

void PenFeed::take(const PenSample& sample) {
  if (const ToneInput tone = tone_of(studio_); tone != reported_tone_) {
    reported_tone_ = tone;
    feed_.tone.publish(tone);
  }
  // If the queue is full, no sound device reads it, and lost samples do not matter.
  static_cast<void>(feed_.samples.push(pen_.sample(sample)));
  if (pen_.pair() == reported_) return;
  reported_ = pen_.pair();
  feed_.pair.publish(reported_);
}

RubbedSamples::RubbedSamples(RubbedFeed& feed, bool is_float) : feed_(feed), is_float_(is_float) {
  open(QIODevice::ReadOnly | QIODevice::Unbuffered);
}

qint64 RubbedSamples::bytesAvailable() const {
  return qint64(RubbingPlayer::kRateHz) * qint64(is_float_ ? sizeof(float) : sizeof(std::int16_t));
}

void RubbedSamples::take_news() {
  // Sets the pair even if it is not new, because a previous sound device may already have received
  // it, but a new device needs it, too.
  static_cast<void>(feed_.pair.update());
  sound_.set_pair(feed_.pair.get());
  if (feed_.tone.update()) tone_.set(feed_.tone.get());
  std::array<RubbingSample, 64> batch;
  for (std::size_t n = 0; (n = feed_.samples.pop(batch)) > 0;) {
    for (const RubbingSample& sample : std::span(batch).first(n)) sound_.push(sample);
  }
  sound_.keep_up(kBehindS);
}

qint64 RubbedSamples::readData(char* data, qint64 max_bytes) {
  constexpr float kFollow = 0.002F;  // time constant 10 ms
  take_news();
  const qint64 size = is_float_ ? sizeof(float) : sizeof(std::int16_t);
  std::array<float, 256> block{};
  qint64 done = 0;
  while (max_bytes - done >= size) {
    const auto n = std::min(static_cast<std::size_t>((max_bytes - done) / size), block.size());
    sound_.render(std::span(block).first(n));
    if (!feed_.has_rubbing.load(std::memory_order_relaxed)) block.fill(0.0F);
    const float volume = feed_.volume.load(std::memory_order_relaxed);
    for (std::size_t i = 0; i < n; ++i, done += size) {
      volume_ += kFollow * (volume - volume_);
      const float sum = block[i] + static_cast<float>(tone_.next());
      const float value = volume_ * std::clamp(sum, -1.0F, 1.0F);
      const auto whole = static_cast<std::int16_t>(std::lround(32767.0F * value));
      if (is_float_) {
        std::memcpy(data + done, &value, sizeof value);
      } else {
        std::memcpy(data + done, &whole, sizeof whole);
      }
    }
  }
  return done;
}

qint64 RubbedSamples::writeData(const char*, qint64) {
  return -1;
}

}  // namespace felt::desktop
