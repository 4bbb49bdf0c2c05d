#include "desktop/pens/long_press.h"

#include <QLineF>
#include <utility>

namespace felt::desktop {

LongPress::LongPress(Canvas& canvas, const PenHand& hand, const PenSettings& settings)
    : canvas_(canvas), studio_(canvas.studio()), hand_(hand), settings_(settings) {
  connect(&studio_, &Studio::shown, this, &LongPress::follow);
}

void LongPress::follow() {
  const PenSample& pen = studio_.pen().sample;
  const bool touches = studio_.pen().is_known && in_contact(pen);
  if (std::exchange(touches_, touches) != touches) {
    waits_ = touches;
    since_ns_ = pen.time_ns;
    from_ = on_page(pen.position);
  }
  if (!waits_) return;
  if (!is_possible() || has_moved(on_page(pen.position))) {
    waits_ = false;
    return;
  }
  if (pen.time_ns - since_ns_ < kPressNs) return;
  waits_ = false;
  Q_EMIT held(canvas_.view().to_px(on_page(pen.position)));
}

/// Returns true if a rest of this touch means nothing else.
bool LongPress::is_possible() const {
  const Session& session = studio_.session();
  const bool by_pen =
      hand_.is_down(PenHand::Source::kTablet) || hand_.is_down(PenHand::Source::kFinger);
  const bool by_device = !hand_.is_down() && !studio_.loop().is_pointed() &&
                         studio_.session().device().actuated_axes > 2;
  return settings_.long_press && (by_pen || by_device) && !studio_.is_borrowing() &&
         !studio_.is_pen_elsewhere() && studio_.pen().sample.buttons == 0 &&
         session.tool().info().kind != ToolKind::kReads && !session.ring() && !session.guide() &&
         !session.offered();
}

bool LongPress::has_moved(Point pen) const {
  if (!studio_.loop().is_pointed()) return distance(pen, from_) > kMoveMm;
  const CanvasView& view = canvas_.view();
  return QLineF(view.to_px(from_), view.to_px(pen)).length() > kMovePx;
}

}  // namespace felt::desktop
