#pragma once

#include <QObject>
#include <QPointF>
#include <cstdint>

#include "desktop/canvas/canvas.h"
#include "desktop/pens/pen_hand.h"
#include "desktop/pens/pen_settings.h"

namespace felt::desktop {

/// Recognises a long press: a pen or finger that touches the surface and then rests for kPressNs.
/// It must not have moved farther than kMovePx, or than kMoveMm if the user holds the pen of a
/// device. Each touch is at most one long press.
///
/// Whoever draws dots or begins lines slowly would be disturbed, so it is off unless
/// PenSettings::long_press is on. A touch is not a long press while it means something else: if it
/// offers a shape (hold a line to straighten it), with the tool Read, with a button or key that
/// borrows a tool or is a modifier, in a trial with a guide, by keys, and by the mouse, whose right
/// button opens the ring.
///
/// The time is that of the samples. The arguments of the constructor must outlive this object.
class LongPress : public QObject {
  Q_OBJECT

 public:
  /// As long as the touch and hold of other systems (Android 400 to 500 ms, Windows 1 s), but
  /// longer than people rest at the beginning of a line (chosen).
  static constexpr std::int64_t kPressNs = 600'000'000;
  static constexpr double kMovePx = 4.0, kMoveMm = 1.0;

  LongPress(Canvas& canvas, const PenHand& hand, const PenSettings& settings);

 Q_SIGNALS:
  /// Emitted while the pen still touches. `px` is its position on the canvas.
  void held(QPointF px);

 private:
  void follow();
  [[nodiscard]] bool is_possible() const;
  [[nodiscard]] bool has_moved(Point pen) const;

  Canvas& canvas_;
  Studio& studio_;
  const PenHand& hand_;
  const PenSettings& settings_;
  bool touches_ = false;
  bool waits_ = false;  // this touch may still become a long press
  std::int64_t since_ns_ = 0;
  Point from_;
};

}  // namespace felt::desktop
