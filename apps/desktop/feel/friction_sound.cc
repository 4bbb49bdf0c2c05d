#include "desktop/feel/friction_sound.h"

#include <algorithm>
#include <utility>

#include "desktop/engine/settings.h"
#include "desktop/feel/feel_setting_keys.h"

#ifdef FELT_HAS_SOUND
#include <QAudioDevice>
#include <QAudioFormat>
#include <QAudioSink>
#include <QMediaDevices>
#include <QThread>
#endif

namespace felt::desktop {

#ifdef FELT_HAS_SOUND
namespace {

/// Buffer requested from the sound device. Together with RubbedSamples::kBehindS, the latency from
/// the pen to the device is some 45 ms. The device may have an additional latency.
constexpr int kBufferMs = 25;

/// Returns a format with 48 kHz and one channel that the device accepts, or an invalid format if
/// the device accepts none.
QAudioFormat format_for(const QAudioDevice& device) {
  QAudioFormat format;
  format.setSampleRate(int(RubbingPlayer::kRateHz));
  format.setChannelCount(1);
  for (const QAudioFormat::SampleFormat samples : {QAudioFormat::Float, QAudioFormat::Int16}) {
    format.setSampleFormat(samples);
    if (!device.isNull() && device.isFormatSupported(format)) return format;
  }
  return {};
}

}  // namespace

/// Plays on its own thread, so that a busy window does not interrupt the sound, and a hanging
/// sound service does not block drawing.
class FrictionSound::Player {
 public:
  explicit Player(RubbedFeed& feed) : feed_(feed) {
    thread_.setObjectName(QStringLiteral("sound"));
    QObject::connect(&thread_, &QThread::started, &on_thread_, [this] { begin(); });
    QObject::connect(
        &thread_, &QThread::finished, &on_thread_, [this] { end(); }, Qt::DirectConnection);
    on_thread_.moveToThread(&thread_);
    thread_.start();
  }
  ~Player() {
    thread_.quit();
    thread_.wait();
  }

 private:
  void begin() {
    devices_ = std::make_unique<QMediaDevices>();
    QObject::connect(devices_.get(), &QMediaDevices::audioOutputsChanged, devices_.get(),
                     [this] { follow_device(); });
    follow_device();
  }
  /// Plays on the present default device.
  void follow_device() {
    const QAudioDevice device = QMediaDevices::defaultAudioOutput();
    if (sink_ && device.id() == in_use_) return;
    in_use_ = device.id();
    stop_sink();
    const QAudioFormat format = format_for(device);
    if (format.isValid()) {
      samples_ =
          std::make_unique<RubbedSamples>(feed_, format.sampleFormat() == QAudioFormat::Float);
      sink_ = std::make_unique<QAudioSink>(device, format);
      sink_->setBufferSize(format.bytesForDuration(1000 * kBufferMs));
      sink_->start(samples_.get());
      if (sink_->error() != QAudio::NoError) stop_sink();
    }
    const auto state = sink_ ? SoundState::State::kPlaying : SoundState::State::kNoDevice;
    QMetaObject::invokeMethod(
        &here_, [state] { SoundState::the().set(state); }, Qt::QueuedConnection);
  }
  void stop_sink() {
    if (sink_) sink_->stop();
    sink_.reset();
    samples_.reset();
  }
  void end() {
    stop_sink();
    devices_.reset();
  }

  RubbedFeed& feed_;
  QObject here_;  // belongs to the main thread; calls that are queued for it are dropped when it is
                  // destroyed
  QThread thread_;
  QObject on_thread_;
  // Only the playing thread uses the following members.
  std::unique_ptr<QMediaDevices> devices_;
  std::unique_ptr<RubbedSamples> samples_;
  std::unique_ptr<QAudioSink> sink_;
  QByteArray in_use_;
};

bool FrictionSound::is_built_in() {
  return true;
}
#else
class FrictionSound::Player {
 public:
  explicit Player(RubbedFeed&) {}
};

bool FrictionSound::is_built_in() {
  return false;
}
#endif

SoundState& SoundState::the() {
  static SoundState state;
  return state;
}

SoundState::SoundState() : state_(FrictionSound::is_built_in() ? State::kOff : State::kNotBuilt) {}

QString SoundState::words() const {
  switch (state_) {
    case State::kNoDevice:
      return tr("There is no sound device. Sound starts when one is connected.");
    case State::kNotBuilt:
      return tr("This program was built without sound.");
    case State::kOff:
    case State::kPlaying:
      break;
  }
  return {};
}

void SoundState::set(State state) {
  if (state_ == State::kNotBuilt || std::exchange(state_, state) == state) return;
  Q_EMIT changed();
}

FrictionSound::FrictionSound(Studio& studio, QObject* parent) : QObject(parent), studio_(studio) {
  static_cast<void>(SoundState::the());  // makes the SoundState now, so that it belongs to the main
                                         // thread
  connect(&Settings::the(), &Settings::changed, this, &FrictionSound::follow);
  connect(&studio_, &Studio::tool_changed, this, &FrictionSound::follow_use);
  connect(&studio_, &Studio::option_changed, this, &FrictionSound::follow_use);
  connect(&studio_, &Studio::opened, this, &FrictionSound::follow_use);
  follow(QString::fromLatin1(feel_keys::kSoundVolume));
  follow(QString::fromLatin1(feel_keys::kSound));
}

FrictionSound::~FrictionSound() = default;

void FrictionSound::follow(const QString& key) {
  const Settings& settings = Settings::the();
  if (key == QLatin1String(feel_keys::kSoundVolume)) {
    const double share = std::clamp(settings.number(key, feel_keys::kSoundVolumeDefault), 0.0, 1.0);
    // The setting is squared to match human hearing: half of the range reduces the level by about
    // 12 dB.
    feed_.volume.store(float(share * share), std::memory_order_relaxed);
  }
  if (key == QLatin1String(feel_keys::kSound)) follow_use();
}

/// Starts or stops the sound: it is needed for rubbing, or for a tool that reads.
void FrictionSound::follow_use() {
  const bool rubs =
      Settings::the().flag(QString::fromLatin1(feel_keys::kSound), feel_keys::kSoundDefault);
  const Reading* reading = studio_.session().tool().reading();
  feed_.has_rubbing.store(rubs, std::memory_order_relaxed);
  if (rubs || (reading && reading->has_sound)) {
    start();
  } else {
    stop();
  }
}

void FrictionSound::start() {
  if (player_) return;
  pen_ = std::make_unique<PenFeed>(studio_, feed_);
  player_ = std::make_unique<Player>(feed_);
}

void FrictionSound::stop() {
  pen_.reset();
  player_.reset();
  SoundState::the().set(SoundState::State::kOff);
}

}  // namespace felt::desktop
