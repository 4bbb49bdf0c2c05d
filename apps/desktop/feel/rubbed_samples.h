#pragma once

#include <QIODevice>
#include <QObject>
#include <atomic>

#include "desktop/engine/studio.h"
#include "felt/rt/latest_value.h"
#include "felt/rt/spsc_ring.h"
#include "felt/session/sound_input.h"
#include "felt/sound/distance_tone.h"
#include "felt/sound/rubbing_player.h"

namespace felt::desktop {

/// The channel from the main thread to the sound thread. It is wait-free on both sides. The haptic
/// thread does not use it.
struct RubbedFeed {
  SpscRing<RubbingSample, 8192> samples;
  LatestValue<RubbingPair> pair;
  LatestValue<ToneInput> tone;          ///< of a tool that reads
  std::atomic<bool> has_rubbing{true};  ///< false: only the tone is heard
  std::atomic<float> volume{0.5F};      ///< factor of the sound, 0..1
};

/// Sends every sample of a studio's pen to a feed. Use it in Qt's main thread.
class PenFeed : public QObject {
  Q_OBJECT

 public:
  /// `studio` and `feed` must outlive this object.
  PenFeed(Studio& studio, RubbedFeed& feed);

 private:
  void take(const PenSample& sample);

  Studio& studio_;
  RubbedFeed& feed_;
  SoundInput pen_;
  RubbingPair reported_;
  ToneInput reported_tone_;
};

/// Returns what the tone says: the reading of the studio's tool, if it has sound.
ToneInput tone_of(const Studio& studio);

/// The source from which a sound device reads: endless samples on request, 48 kHz, one channel.
/// Use it in the sound thread.
class RubbedSamples final : public QIODevice {
  Q_OBJECT

 public:
  /// Delay from a sample of the pen to its sound, in s. The delay is needed because the main thread
  /// delivers samples in batches, usually every 8 ms and sometimes every 16 ms.
  static constexpr double kBehindS = 0.020;

  /// The samples are floats if `is_float`, otherwise 16-bit integers. `feed` must outlive this
  /// object.
  RubbedSamples(RubbedFeed& feed, bool is_float);
  [[nodiscard]] bool isSequential() const override { return true; }
  [[nodiscard]] qint64 bytesAvailable() const override;

 protected:
  qint64 readData(char* data, qint64 max_bytes) override;
  qint64 writeData(const char* data, qint64 size) override;

 private:
  void take_news();

  RubbedFeed& feed_;
  bool is_float_;
  RubbingPlayer sound_;
  DistanceTone tone_;
  float volume_ = 0.0F;  // approaches the feed's volume smoothly
};

}  // namespace felt::desktop
