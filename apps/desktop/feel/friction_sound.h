#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "desktop/feel/rubbed_samples.h"

namespace felt::desktop {

/// The state of the sound, for the user. The program has one sound output and therefore one
/// SoundState. The program searches for a sound device only after the sound was switched on. Use it
/// in the main thread.
class SoundState : public QObject {
  Q_OBJECT

 public:
  enum class State {
    kOff,
    kPlaying,   ///< a sound device plays the sound
    kNoDevice,  ///< there is no sound device, or it does not accept 48 kHz
    kNotBuilt,  ///< the program was built without Qt Multimedia
  };
  static SoundState& the();

  [[nodiscard]] State state() const noexcept { return state_; }
  /// Returns a sentence if sound is on but nothing can be heard; otherwise an empty string.
  [[nodiscard]] QString words() const;
  void set(State state);

 Q_SIGNALS:
  void changed();

 private:
  SoundState();
  State state_;
};

/// The sound of the pen on the surface (src/felt/sound). It is off by default and follows the
/// settings kSound and kSoundVolume. It is silent without a sound device and starts when a device
/// appears. While a tool reads with sound (Reading::has_sound), the tone of the distance is heard,
/// also if the sound of the pen is off.
class FrictionSound : public QObject {
  Q_OBJECT

 public:
  /// Returns true if the program was built with sound (Qt Multimedia).
  static bool is_built_in();

  explicit FrictionSound(Studio& studio, QObject* parent = nullptr);
  ~FrictionSound() override;

 private:
  class Player;

  void follow(const QString& key);
  void follow_use();
  void start();
  void stop();

  Studio& studio_;
  RubbedFeed feed_;
  std::unique_ptr<PenFeed> pen_;    // null while off
  std::unique_ptr<Player> player_;  // null while off
};

}  // namespace felt::desktop
