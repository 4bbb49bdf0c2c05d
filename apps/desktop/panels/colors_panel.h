#pragma once

#include <QWidget>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// The colour of new ink: a wheel of recent ones, palettes (.gpl), any colour by its number.
class ColorsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ColorsPanel(Studio& studio, QWidget* parent = nullptr);

 private:
  Studio& studio_;
};

}  // namespace felt::desktop
