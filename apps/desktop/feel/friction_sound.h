#pragma once

#include <QObject>
#include <memory>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// The rubbing of the pen, heard. Off at first. Where there is no sound device it is silent.
class FrictionSound : public QObject {
  Q_OBJECT

 public:
  /// The program was built with sound (Qt Multimedia).
  static bool is_built_in();

  explicit FrictionSound(Studio& studio, QObject* parent = nullptr);
  ~FrictionSound() override;

  void set_on(bool on);

 private:
  struct Player;

  void take(const TickReport& tick);

  Studio& studio_;
  std::unique_ptr<Player> player_;  // null while off
};

}  // namespace felt::desktop
