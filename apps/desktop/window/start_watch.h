#pragma once

#include <QObject>

#include "desktop/canvas/canvas.h"

namespace felt::desktop {

/// Implements --measure-start: prints the time from the start of the process to the first paint of
/// the canvas, then ends the program.
class StartWatch : public QObject {
  Q_OBJECT

 public:
  explicit StartWatch(Canvas& canvas);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool is_done_ = false;
};

}  // namespace felt::desktop
