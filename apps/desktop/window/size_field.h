#pragma once

#include <QDoubleSpinBox>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Shows the size of the current tool (tool_size.h) as a number in the top bar, and gives the
/// size to the selected lines. The field's arrows
/// and the wheel step through the same round numbers as the keys [ and ].
class SizeField : public QDoubleSpinBox {
  Q_OBJECT

 public:
  explicit SizeField(Studio& studio, QWidget* parent = nullptr);

  void stepBy(int steps) override;

 private:
  void follow();

  Studio& studio_;
};

}  // namespace felt::desktop
