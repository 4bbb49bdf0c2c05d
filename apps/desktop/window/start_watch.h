#pragma once

#include <QObject>

#include "desktop/canvas/canvas.h"

namespace felt::desktop {

/// --measure-start: prints how long after the start of the process the sheet was painted first,
/// then ends the program.
class StartWatch : public QObject {
  Q_OBJECT

 public:
  explicit StartWatch(Canvas& canvas);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool is_done_ = false;
};

}  // namespace felt::desktop
