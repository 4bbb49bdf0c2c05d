#pragma once

#include <QDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QThreadPool>

#include "desktop/engine/pen_device.h"

namespace felt::desktop {

/// Asks a person to bring a device home: to put its stylus into the inkwell, its arm into the rest
/// pose, or to agree that the arm moves by itself. Nothing moves before they have said so, and for
/// an arm that moves by itself "Not now" is what Enter does. The window goes on meanwhile.
class HomingDialog : public QDialog {
  Q_OBJECT

 public:
  /// The device is open, and no loop runs.
  explicit HomingDialog(PenDevice& device, QWidget* parent = nullptr);
  ~HomingDialog() override;

  /// True: it is at home, or needs none; at once where it needs none.
  static bool bring_home(PenDevice& device, QWidget* parent);

  /// As the button does: the person agrees, or holds it as asked.
  void begin();
  [[nodiscard]] bool is_under_way() const noexcept { return is_under_way_; }

  /// Not while an arm moves.
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
