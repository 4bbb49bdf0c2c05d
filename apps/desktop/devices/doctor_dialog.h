#pragma once

#include <QDialog>
#include <QPushButton>
#include <QTextBrowser>
#include <vector>

#include "desktop/engine/driver_watch.h"

namespace felt::desktop {

/// Shows which haptic devices this computer finds, what is missing, and how to fix it step by step.
/// The dialog shows the same findings as `feltline doctor`; the user can copy them for a support
/// request.
class DoctorDialog : public QDialog {
  Q_OBJECT

 public:
  explicit DoctorDialog(QWidget* parent = nullptr);

  /// Asks the drivers again. The findings arrive asynchronously.
  void look();
  [[nodiscard]] bool is_looking() const noexcept { return is_looking_; }
  void show_findings(std::vector<DriverFindings> findings);
  /// Returns the text that the button "Copy" copies.
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
