#pragma once

#include <QWidget>

namespace felt::desktop {

/// The page "Canvas" of the preferences: what the canvas shows besides the drawing.
class CanvasPage : public QWidget {
  Q_OBJECT

 public:
  explicit CanvasPage(QWidget* parent = nullptr);
};

}  // namespace felt::desktop
