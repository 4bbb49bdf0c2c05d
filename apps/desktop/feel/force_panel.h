#pragma once

#include <QWidget>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// What the pen feels: each term of the force over time, the sum, the limits, the loop's rate.
class ForcePanel : public QWidget {
  Q_OBJECT

 public:
  explicit ForcePanel(Studio& studio, QWidget* parent = nullptr);

 private:
  Studio& studio_;
};

}  // namespace felt::desktop
