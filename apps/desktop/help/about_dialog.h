#pragma once

#include <QDialog>

namespace felt::desktop {

/// What this is: version, licence, the paper, the libraries.
class AboutDialog : public QDialog {
  Q_OBJECT

 public:
  explicit AboutDialog(QWidget* parent = nullptr);
};

}  // namespace felt::desktop
