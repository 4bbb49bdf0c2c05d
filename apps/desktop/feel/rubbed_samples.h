#pragma once

#include <QIODevice>
#include <QObject>
#include <atomic>

#include "desktop/engine/studio.h"
#include "felt/rt/latest_value.h"
#include "felt/rt/spsc_ring.h"
#include "felt/session/heard_pen.h"
#include "felt/sound/rubbing_sound.h"

namespace felt::desktop {

/// What goes from the edit thread to the sound's: wait-free on both sides, nothing waits for the
/// other. The haptic thread knows nothing of it.
struct RubbedFeed {
  SpscRing<RubbingSample, 8192> samples;
  LatestValue<RubbingPair> pair;
  std::atomic<float> volume{0.5F};  ///< what sound is multiplied by, 0..1
};

/// Tells a feed every sample of a studio's pen. Qt's main thread.
class PenFeed : public QObject {
  Q_OBJECT

 public:
  /// Both must outlive it.
  PenFeed(Studio& studio, RubbedFeed& feed);

 private:
  void take(const PenSample& sample);

  Studio& studio_;
  RubbedFeed& feed_;
  HeardPen pen_;
  RubbingPair told_;
};

/// What a sound device reads from: samples as they are asked for, without end; 48 kHz, one channel.
/// On the sound's thread.
class RubbedSamples final : public QIODevice {
  Q_OBJECT

 public:
  /// Behind the newest sample of the pen, s: a window comes with samples in turns of some 8 ms, now
  /// and then of 16.
  static constexpr double kBehindS = 0.020;

  /// Float samples, or 16 bits. The feed must outlive it.
  RubbedSamples(RubbedFeed& feed, bool is_float);
  [[nodiscard]] bool isSequential() const override { return true; }
  [[nodiscard]] qint64 bytesAvailable() const override;

 protected:
  qint64 readData(char* data, qint64 most) override;
  qint64 writeData(const char* data, qint64 size) override;

 private:
  void take_news();

  RubbedFeed& feed_;
  bool is_float_;
  RubbingSound sound_;
  float volume_ = 0.0F;  // follows the feed's without a leap
};

}  // namespace felt::desktop
