#pragma once

#include <QToolButton>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// A button that is filled with the colour of new ink and is always visible. A click opens a
/// colours panel beside it.
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
