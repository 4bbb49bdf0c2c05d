#pragma once

#include <QObject>
#include <QPointF>
#include <QTouchEvent>
#include <cstdint>

#include "desktop/pens/device_clock.h"
#include "desktop/pens/pen_hand.h"
#include "desktop/pens/pen_settings.h"
#include "desktop/pens/touch_tap.h"

namespace felt::desktop {

/// Handles fingers on the canvas: two fingers pan, zoom and turn the view together; one finger pans
/// the view or draws, depending on the settings. A tap with two fingers undoes, one with three
/// redoes, if the settings say so; the view then stays as it was before the tap. A touch while a
/// pen is near is treated as a palm until all fingers are lifted. The arguments of the constructor
/// must outlive this object.
class TouchInput : public QObject {
  Q_OBJECT

 public:
  TouchInput(Canvas& canvas, PenHand& hand, const PenSettings& settings);

  /// Handles a touch event. If `pen_is_near`, treats it as a palm.
  void take(const QTouchEvent& event, bool pen_is_near);
  /// Discards what the present touch draws, because a pen came near. The touch then counts as a
  /// palm.
  void cancel();

 private:
  enum class Use : std::uint8_t { kNothing, kView, kDraw };

  void tap(int fingers);
  void draw(std::int64_t time_ns, const QEventPoint& finger);
  void move_view(const QTouchEvent& event);

  Canvas& canvas_;
  PenHand& hand_;
  const PenSettings& settings_;
  DeviceClock clock_;  // its times are on the studio's clock, also those of taps
  TouchTap tap_;
  CanvasView view_before_;  // when the touch began
  Use use_ = Use::kNothing;
  bool is_palm_ = false;
  QList<int> ids_;  // ids of the fingers that were down at the last event
  QPointF middle_;  // middle of these fingers
  QPointF first_;   // vector from the first to the second finger
};

}  // namespace felt::desktop
