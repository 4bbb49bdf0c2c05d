#pragma once

#include <QString>
#include <cstdint>

#include "desktop/canvas/canvas.h"
#include "desktop/canvas/desk.h"
#include "desktop/canvas/first_minute.h"
#include "desktop/canvas/marks.h"
#include "desktop/canvas/wet_ink_view.h"
#include "felt/devices/simulated/pseudo_cursor.h"

namespace felt::desktop {

/// What a canvas shows now, apart from dry ink. The next refresh is compared with it.
struct Canvas::Shown {
  Overlay overlay;
  Desk desk;
  MarkLook look{Qt::white};
  BandView bands;
  WetInkView wet;
  Marks marks, next;
  InkBrush brush;
  FirstMinute first_minute;
  bool shows_first_minute = false;
  PseudoCursor cursor;
  std::int64_t cursor_ns = 0;  // when it was last computed
  QTimer size_ring;            // while the ring is shown
  QTimer place;                // until `place_changed`: a user reads more slowly than a pen moves
};

}  // namespace felt::desktop
