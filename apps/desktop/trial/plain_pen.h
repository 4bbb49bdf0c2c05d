#pragma once

#include <QObject>

#include "desktop/pens/pen_input.h"

namespace felt::desktop {

/// Lets the participant of a study only draw: passes the left button of a mouse and the tip of a
/// tablet pen to the canvas. Other buttons, the eraser of the pen, fingers, the wheel and keys
/// would change the tool or the view, so they do nothing. Keys go to the window. The canvas must
/// outlive this object.
class PlainPen : public QObject {
  Q_OBJECT

 public:
  explicit PlainPen(Canvas& canvas);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void pass_mouse(const QMouseEvent& event);
  void pass_tablet(const QTabletEvent& event);

  Canvas& canvas_;
  PenInput& input_;  // owned by the canvas
};

}  // namespace felt::desktop
