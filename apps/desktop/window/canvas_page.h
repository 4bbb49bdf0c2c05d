#pragma once

#include <QWidget>

namespace felt::desktop {

/// What the sheet shows besides the drawing.
class CanvasPage : public QWidget {
  Q_OBJECT

 public:
  explicit CanvasPage(QWidget* parent = nullptr);
};

}  // namespace felt::desktop
