#pragma once

#include <QDialog>

namespace felt::desktop {

/// Shows the version, the licence, the paper on which Feltline is based, and the libraries.
class AboutDialog : public QDialog {
  Q_OBJECT

 public:
  explicit AboutDialog(QWidget* parent = nullptr);
};

}  // namespace felt::desktop
