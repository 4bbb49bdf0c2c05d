#pragma once

#include <QWidget>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// The options of the tool in hand, made from its table (OptionSpec): a row each, its help as the
/// tip.
class OptionsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit OptionsPanel(Studio& studio, QWidget* parent = nullptr);

 private:
  Studio& studio_;
};

}  // namespace felt::desktop
