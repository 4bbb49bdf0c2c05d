#include "desktop/feel/friction_sound.h"

#include <cmath>
#include <cstring>

#include "desktop/feel/friction_synth.h"
#include "felt/rt/latest_value.h"

#ifdef FELT_HAS_SOUND
#include <QAudioDevice>
#include <QAudioFormat>
#include <QAudioSink>
#include <QIODevice>
#include <QMediaDevices>
#include <QThread>
#endif

namespace felt::desktop {

#ifdef FELT_HAS_SOUND
namespace {

constexpr int kRateHz = 48000;
constexpr int kBufferMs = 30;

/// What the sound device reads from: samples as they are asked for, without end. On the sound's
/// thread.
class RubbedSamples final : public QIODevice {
 public:
  explicit RubbedSamples(LatestValue<Rubbing>& rubbing) : rubbing_(rubbing), synth_(kRateHz) {
    open(QIODevice::ReadOnly | QIODevice::Unbuffered);
  }
  [[nodiscard]] bool isSequential() const override { return true; }
  [[nodiscard]] qint64 bytesAvailable() const override { return kRateHz * qint64{sizeof(float)}; }

 protected:
  qint64 readData(char* data, qint64 most) override {
    if (rubbing_.update()) synth_.rub(rubbing_.get());
    std::array<float, 256> block{};
    qint64 done = 0;
    while (most - done >= qint64{sizeof(float)}) {
      const auto room = static_cast<std::size_t>(most - done) / sizeof(float);
      const std::size_t n = std::min(room, block.size());
      synth_.render(std::span(block).first(n));
      std::memcpy(data + done, block.data(), n * sizeof(float));
      done += static_cast<qint64>(n * sizeof(float));
    }
    return done;
  }
  qint64 writeData(const char*, qint64) override { return -1; }

 private:
  LatestValue<Rubbing>& rubbing_;
  FrictionSynth synth_;
};

}  // namespace

/// Has a thread of its own, so that a busy window does not make it stutter.
struct FrictionSound::Player {
  Player() {
    thread.setObjectName(QStringLiteral("sound"));
    QObject::connect(&thread, &QThread::started, &on_thread, [this] { begin(); });
    QObject::connect(
        &thread, &QThread::finished, &on_thread, [this] { end(); }, Qt::DirectConnection);
    on_thread.moveToThread(&thread);
    thread.start();
  }
  ~Player() {
    thread.quit();
    thread.wait();
  }

  void begin() {
    const QAudioDevice device = QMediaDevices::defaultAudioOutput();
    QAudioFormat format;
    format.setSampleRate(kRateHz);
    format.setChannelCount(1);
    format.setSampleFormat(QAudioFormat::Float);
    if (device.isNull() || !device.isFormatSupported(format)) return;
    samples = std::make_unique<RubbedSamples>(rubbing);
    sink = std::make_unique<QAudioSink>(device, format);
    sink->setBufferSize(format.bytesForDuration(1000 * kBufferMs));
    sink->start(samples.get());
  }
  void end() {
    if (sink) sink->stop();
    sink.reset();
    samples.reset();
  }

  LatestValue<Rubbing> rubbing;
  QThread thread;
  QObject on_thread;
  std::unique_ptr<RubbedSamples> samples;
  std::unique_ptr<QAudioSink> sink;
};

bool FrictionSound::is_built_in() {
  return true;
}
#else
struct FrictionSound::Player {
  LatestValue<Rubbing> rubbing;
};

bool FrictionSound::is_built_in() {
  return false;
}
#endif

FrictionSound::FrictionSound(Studio& studio, QObject* parent) : QObject(parent), studio_(studio) {
  connect(&studio_, &Studio::ticked, this, &FrictionSound::take);
}

FrictionSound::~FrictionSound() = default;

void FrictionSound::set_on(bool on) {
  if (on == (player_ != nullptr)) return;
  player_ = on ? std::make_unique<Player>() : nullptr;
}

void FrictionSound::take(const TickReport& tick) {
  if (!player_) return;
  Rubbing now;
  now.timbre = timbre_of(studio_.session().sheet().material());
  if (in_contact(tick.sample)) {
    Force rubbing;
    for (const ForceTerms::Term& term : tick.terms) {
      if (std::strcmp(term.name, "friction") == 0 || std::strcmp(term.name, "texture") == 0) {
        rubbing += term.force;
      }
    }
    now.friction_n = norm(rubbing);
    now.speed_mm_per_s = std::hypot(tick.sample.velocity.x, tick.sample.velocity.y);
  }
  player_->rubbing.publish(now);
}

}  // namespace felt::desktop
