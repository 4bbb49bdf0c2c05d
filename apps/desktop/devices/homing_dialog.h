#pragma once

#include <QDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QThreadPool>

#include "desktop/engine/pen_device.h"

namespace felt::desktop {

/// Asks the user to home a device: to put its stylus into the inkwell, to put its arm into the rest
/// pose, or to allow the arm to move by itself. Nothing moves before the user has confirmed. If the
/// arm will move by itself, Enter means "Not now". The window stays responsive.
class HomingDialog : public QDialog {
  Q_OBJECT

 public:
  /// Requires that the device is open and that no haptic loop runs.
  explicit HomingDialog(PenDevice& device, QWidget* parent = nullptr);
  ~HomingDialog() override;

  /// Returns true if the device is homed or needs no homing. Shows no dialog if it needs no
  /// homing.
  static bool bring_home(PenDevice& device, QWidget* parent);

  /// Starts homing. The button calls it; the user presses the button to agree, or when the device
  /// is held as requested.
  void begin();
  [[nodiscard]] bool is_under_way() const noexcept { return is_under_way_; }

  /// Does nothing while an arm moves.
  void reject() override;

 private:
  void ask();
  void take(const Result<void>& home);

  PenDevice& device_;
  Homing homing_;
  bool is_under_way_ = false;
  QThreadPool mover_;
  QLabel* sign_;
  QLabel* title_;
  QLabel* words_;
  QLabel* error_;
  QProgressBar* bar_;
  QPushButton* go_;
  QPushButton* not_now_;
};

}  // namespace felt::desktop
