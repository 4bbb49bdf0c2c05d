#pragma once

#include <QToolButton>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// The colour of new ink, always visible: a button filled with it. A click opens the colours beside
/// it.
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
