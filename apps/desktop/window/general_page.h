#pragma once

#include <QWidget>

namespace felt::desktop {

/// Theme, language, and what happens at the start.
class GeneralPage : public QWidget {
  Q_OBJECT

 public:
  explicit GeneralPage(QWidget* parent = nullptr);
};

}  // namespace felt::desktop
