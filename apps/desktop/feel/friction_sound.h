#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "desktop/feel/rubbed_samples.h"

namespace felt::desktop {

/// Whether drawing is heard, for people; one for the program, since there is one place that sound
/// comes out of. Nobody looks for a sound device before somebody wants to hear one. Main thread.
class SoundState : public QObject {
  Q_OBJECT

 public:
  enum class State {
    kOff,
    kHeard,
    kNoDevice,  ///< there is none, or it takes no sound of 48 kHz
    kNotBuilt,  ///< a program without Qt Multimedia
  };
  static SoundState& the();

  [[nodiscard]] State state() const noexcept { return state_; }
  /// A sentence where nothing is heard though it should be; else empty.
  [[nodiscard]] QString words() const;
  void set(State state);

 Q_SIGNALS:
  void changed();

 private:
  SoundState();
  State state_;
};

/// The rubbing of the pen, heard (src/felt/sound). Off at first, and follows the settings kSound
/// and kSoundVolume. Where there is no sound device it is silent, and begins once there is one.
class FrictionSound : public QObject {
  Q_OBJECT

 public:
  /// The program was built with sound (Qt Multimedia).
  static bool is_built_in();

  explicit FrictionSound(Studio& studio, QObject* parent = nullptr);
  ~FrictionSound() override;

 private:
  class Player;

  void follow(const QString& key);
  void start();
  void stop();

  Studio& studio_;
  RubbedFeed feed_;
  std::unique_ptr<PenFeed> pen_;    // null while off
  std::unique_ptr<Player> player_;  // null while off
};

}  // namespace felt::desktop
