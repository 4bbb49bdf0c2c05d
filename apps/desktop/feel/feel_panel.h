#pragma once

#include <QWidget>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// How it shall feel: the sheet's material, master strength, and the large switch of the forces.
class FeelPanel : public QWidget {
  Q_OBJECT

 public:
  explicit FeelPanel(Studio& studio, QWidget* parent = nullptr);

 private:
  Studio& studio_;
};

}  // namespace felt::desktop
