#pragma once

#include <QObject>
#include <QPointF>
#include <QTouchEvent>
#include <cstdint>

#include "desktop/pens/device_clock.h"
#include "desktop/pens/pen_hand.h"
#include "desktop/pens/pen_settings.h"

namespace felt::desktop {

/// Fingers on the canvas: two move, zoom and turn the view at once; one moves it or draws, as the
/// settings say. While a pen is near, and from then on until all fingers are up, a touch is a palm.
/// What it is given must outlive it.
class TouchInput : public QObject {
  Q_OBJECT

 public:
  TouchInput(Canvas& canvas, PenHand& hand, const PenSettings& settings);

  /// `pen_is_near`: it is a palm.
  void take(const QTouchEvent& event, bool pen_is_near);
  /// A pen came: what the fingers began is no more.
  void cancel();

 private:
  enum class Use : std::uint8_t { kNothing, kView, kDraw };

  void begin();
  void draw(const QTouchEvent& event, const QEventPoint& finger);
  void move_view(const QTouchEvent& event);

  Canvas& canvas_;
  PenHand& hand_;
  const PenSettings& settings_;
  DeviceClock clock_;
  Use use_ = Use::kNothing;
  bool is_palm_ = false;
  QList<int> ids_;  // of the fingers that were down at the last event
  QPointF middle_;  // of these
  QPointF first_;   // from the first to the second
};

}  // namespace felt::desktop
