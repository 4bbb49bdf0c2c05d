#include "desktop/pens/view_drag.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "desktop/engine/tool_size.h"

namespace felt::desktop {
namespace {

constexpr double kPxPerDoubling = 120.0;

Qt::CursorShape cursor_of(ViewDrag::Kind kind, bool dragging) {
  switch (kind) {
    case ViewDrag::Kind::kPan:
      return dragging ? Qt::ClosedHandCursor : Qt::OpenHandCursor;
    case ViewDrag::Kind::kZoom:
      return Qt::SizeVerCursor;
    case ViewDrag::Kind::kTurn:
      return Qt::SizeAllCursor;
    case ViewDrag::Kind::kSize:
      return Qt::SizeHorCursor;
  }
  return Qt::ArrowCursor;
}

}  // namespace

void ViewDrag::show_cursor() {
  const std::optional<Kind> kind = kind_ ? kind_ : offered_;
  if (!kind) {
    if (before_) canvas_.setCursor(*before_);
    before_.reset();
    return;
  }
  if (!before_) before_ = canvas_.cursor();
  canvas_.setCursor(cursor_of(*kind, kind_.has_value()));
}

void ViewDrag::offer(std::optional<Kind> kind) {
  if (std::exchange(offered_, kind) != kind) show_cursor();
}

void ViewDrag::begin(Kind kind, QPointF px) {
  kind_ = kind;
  start_ = last_ = px;
  const std::optional<ToolSize> size = tool_size(canvas_.studio().session());
  start_size_mm_ = size ? size->mm : 0.0;
  show_cursor();
}

void ViewDrag::move(QPointF px) {
  if (!kind_) return;
  if (*kind_ == Kind::kSize) {
    const double doublings = (px.x() - start_.x() - px.y() + start_.y()) / kPxPerDoubling;
    return set_tool_size(canvas_.studio(), start_size_mm_ * std::exp2(doublings));
  }
  const QPointF way = px - last_;
  CanvasView view = canvas_.view();
  if (*kind_ == Kind::kPan) {
    view.pan(way);
  } else if (*kind_ == Kind::kZoom) {
    view.zoom(std::exp2((way.x() - way.y()) / kPxPerDoubling), start_);
  } else {
    const QPointF middle(view.size().width() / 2, view.size().height() / 2);
    const QPointF from = last_ - middle, to = px - middle;
    const double cross = from.x() * to.y() - from.y() * to.x();
    const double along = from.x() * to.x() + from.y() * to.y();
    view.turn(std::atan2(cross, along) * 180.0 / std::numbers::pi, middle);
  }
  last_ = px;
  canvas_.set_view(view);
}

void ViewDrag::end() {
  if (!kind_) return;
  if (kind_ == Kind::kSize) resize_selected(canvas_.studio());
  kind_.reset();
  show_cursor();
}

}  // namespace felt::desktop
