#pragma once

#include <QToolButton>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Shows the colour of new ink at all times as a filled button. A click opens the colours panel
/// beside it.
class ColorWell : public QToolButton {
  Q_OBJECT

 public:
  explicit ColorWell(Studio& studio, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void follow();

  Studio& studio_;
};

}  // namespace felt::desktop
