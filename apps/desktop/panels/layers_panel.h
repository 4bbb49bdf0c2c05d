#pragma once

#include <QWidget>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// The layers, the topmost first: seen, locked, named, ordered, used.
class LayersPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LayersPanel(Studio& studio, QWidget* parent = nullptr);

 private:
  Studio& studio_;
};

}  // namespace felt::desktop
