#include <QFocusEvent>
#include <QPaintEvent>
#include <QPainter>
#include <cmath>

#include "desktop/canvas/canvas.h"
#include "desktop/canvas/canvas_shown.h"

namespace felt::desktop {
namespace {

constexpr int kMaxParts = 6;  // if a region has more rectangles, paint their bounding rectangle

/// Splits a region of the widget into rectangles that are painted one after the other. Qt clips
/// painting to whole device pixels. At a fractional scale, a rectangle may end within a device
/// pixel and cover it only in part, so that the previous picture would shine through. In this case
/// the function returns one slightly enlarged bounding rectangle; Qt's clipping leaves the rest
/// unchanged. Several enlarged rectangles would overlap, and ink with alpha would be painted
/// twice.
QList<QRect> parts_of(const QRegion& region, double dpr) {
  const bool is_whole = std::abs(dpr - std::round(dpr)) < 1e-6;
  if (!is_whole) return {region.boundingRect().adjusted(-2, -2, 2, 2)};
  if (region.rectCount() > kMaxParts) return {region.boundingRect()};
  return {region.begin(), region.end()};
}

}  // namespace

void Canvas::resizeEvent(QResizeEvent*) {
  view_.set_size(size());
  if (keeps_page_fitted_) {
    fit_page();
  } else {
    lay_out();
    Q_EMIT view_changed();
  }
}

bool Canvas::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::Enter:
      set_pen_visible(true);
      break;
    case QEvent::PaletteChange:
    case QEvent::StyleChange:
    case QEvent::FontChange:
      take_look();
      lay_out();
      break;
    case QEvent::LanguageChange:
      setAccessibleName(tr("Drawing area"));
      take_status();
      Q_EMIT hint_changed();
      break;
    case QEvent::FocusIn: {
      const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
      focus_by_key_ = reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason ||
                      reason == Qt::ShortcutFocusReason;
      update();
      break;
    }
    case QEvent::FocusOut:
      focus_by_key_ = false;
      update();
      break;
    default:
      break;
  }
  return QWidget::event(event);
}

void Canvas::paintEvent(QPaintEvent* event) {
  const qint64 begin_ns = clock_.nsecsElapsed();
  if (dpr_ != devicePixelRatioF()) lay_out();
  if (is_stale_ && !pace_.isActive()) flush();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painting_ = event->region();
  ink_.paint(painter, {});  // paints nothing, but accepts the tiles that the worker has finished;
                            // because painting_ is set, this part is not scheduled again
  if (shown_->onion) shown_->onion->paint(painter, {});
  painting_ = {};
  paint_ground(painter, event->region());
  paint_marks(painter, event->region());
  if (focus_by_key_) {
    QColor color = palette().color(QPalette::Highlight);
    color.setAlpha(170);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(color, 2.0));
    painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
  }
  paint_ms_ = static_cast<double>(clock_.nsecsElapsed() - begin_ns) * 1e-6;
}

/// Paints the background, the paper, the bands and the ink, one rectangle after the other.
void Canvas::paint_ground(QPainter& painter, const QRegion& region) {
  Shown& s = *shown_;
  const QList<QRect> parts = parts_of(region, dpr_);
  for (const QRect& part : parts) {
    painter.setClipRect(part);
    s.desk.paint(painter, part, view_);
    s.bands.paint(painter, part, s.brush, [&s](Overlay::Role role) {
      const QColor c = s.look.band(role);
      return Rgba{static_cast<std::uint8_t>(c.red()), static_cast<std::uint8_t>(c.green()),
                  static_cast<std::uint8_t>(c.blue()), 255};
    });
    if (s.onion) s.onion->paint(painter, part);
    ink_.paint(painter, part);
    const Layer* layer = studio_.session().document().layer(studio_.session().layer());
    const LayerGroup* group = layer ? layer->group.get() : nullptr;
    const bool multiplies = (layer && layer->blend == BlendMode::kMultiply) ||
                            (group && group->blend == BlendMode::kMultiply);
    painter.setOpacity((layer ? layer->opacity : 1.0) * (group ? group->opacity : 1.0));
    if (multiplies) painter.setCompositionMode(QPainter::CompositionMode_Multiply);
    s.wet.paint(painter, part, [this](QImage& ink, QPoint at) { ink_.cover(ink, at); });
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
    painter.setOpacity(1.0);
  }
  painter.setClipping(false);
}

/// Paints the lines and texts over the ink. Each one is painted only once, and Qt clips it to the
/// whole region.
void Canvas::paint_marks(QPainter& painter, const QRegion& region) {
  Shown& s = *shown_;
  if (s.shows_first_minute && region.intersects(s.first_minute.area(size(), font()))) {
    const Point middle = view_.to_mm({0.5 * width(), 0.5 * height()});
    const bool on_paper = studio_.page().area().contains(middle);
    const QColor ground = on_paper ? s.desk.paper() : s.desk.color();
    s.first_minute.paint(painter, size(), font(), MarkLook(ground).text(), ground);
  }
  for (const Mark& mark : s.marks) {
    if (region.intersects(mark.box)) paint_mark(painter, mark, s.look, font());
  }
}

}  // namespace felt::desktop
