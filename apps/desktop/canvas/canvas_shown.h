#pragma once

#include <QString>
#include <cstdint>
#include <memory>
#include <vector>

#include "desktop/canvas/canvas.h"
#include "desktop/canvas/desk.h"
#include "desktop/canvas/first_minute.h"
#include "desktop/canvas/marks.h"
#include "desktop/canvas/mirrored_ink_view.h"
#include "felt/devices/simulated/pseudo_cursor.h"

namespace felt::desktop {

/// The state that a canvas shows now, apart from dry ink. A refresh compares it with the new
/// state.
struct Canvas::Shown {
  Overlay overlay;
  Overlay notes;   // marks that do not come from the tool
  Overlay guides;  // of the drawing
  Desk desk;
  MarkLook look{Qt::white};
  BandView bands;
  MirroredInkView wet;
  std::unique_ptr<InkView> onion;    // below the ink; usually null
  std::vector<LayerId> out_of_view;  // the layers that the ink view does not show (UseView)
  Marks marks, next;
  InkBrush brush;
  FirstMinute first_minute;
  bool shows_first_minute = false;
  PseudoCursor cursor;
  std::int64_t cursor_ns = 0;  // time at which `cursor` was last computed
  QTimer size_ring;            // active while the size ring is shown
  QTimer place;                // delays `place_changed`, because users cannot read the position as
                               // fast as a pen moves
};

}  // namespace felt::desktop
