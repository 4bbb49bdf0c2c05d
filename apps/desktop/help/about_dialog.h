#pragma once

#include <QDialog>

namespace felt::desktop {

/// Shows version, licence, the paper, and the libraries.
class AboutDialog : public QDialog {
  Q_OBJECT

 public:
  explicit AboutDialog(QWidget* parent = nullptr);
};

}  // namespace felt::desktop
