#pragma once

#include <QDialog>
#include <QPushButton>
#include <QTextBrowser>
#include <vector>

#include "desktop/engine/driver_watch.h"

namespace felt::desktop {

/// What this computer sees of haptic devices, what is missing, and what to do about it, step by
/// step: the findings that `feltline doctor` prints, to be read, and copied for those who help.
class DoctorDialog : public QDialog {
  Q_OBJECT

 public:
  explicit DoctorDialog(QWidget* parent = nullptr);

  /// Asks again; findings come when they come.
  void look();
  [[nodiscard]] bool is_looking() const noexcept { return is_looking_; }
  void show_findings(std::vector<DriverFindings> findings);
  /// As it is copied.
  [[nodiscard]] QString plain_text() const;

 private:
  void draw();
  void changeEvent(QEvent* event) override;

  std::vector<DriverFindings> findings_;
  bool is_looking_ = false;
  QTextBrowser* text_;
  QPushButton* again_;
  QPushButton* copy_;
};

}  // namespace felt::desktop
