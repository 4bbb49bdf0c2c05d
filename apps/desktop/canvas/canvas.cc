#include "desktop/canvas/canvas.h"

#include <QPaintEvent>
#include <QPainter>
#include <QPainterPath>

namespace felt::desktop {

Canvas::Canvas(Studio& studio, QWidget* parent) : QWidget(parent), studio_(studio) {
  setAccessibleName(tr("Sheet"));
  setAccessibleDescription(tr("The sheet to draw on"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAttribute(Qt::WA_AcceptTouchEvents);
  setMinimumSize(200, 150);
  ink_.set_document(studio.session().document());
  connect(&studio, &Studio::edited, &ink_, &InkView::apply);
  connect(&studio, &Studio::opened, this,
          [this] { ink_.set_document(studio_.session().document()); });
  connect(&studio, &Studio::shown, this, &Canvas::refresh);
  connect(&studio, &Studio::page_changed, this, QOverload<>::of(&QWidget::update));
  connect(&ink_, &InkView::changed, this, QOverload<>::of(&QWidget::update));
}

void Canvas::refresh() {
  ink_.show(studio_.session().preview());
  update();
}

void Canvas::set_view(const CanvasView& view) {
  const QSizeF size = view_.size();
  view_ = view;
  view_.set_size(size);
  ink_.set_view(view_, devicePixelRatioF());
  update();
  Q_EMIT view_changed();
}

void Canvas::fit_page() {
  CanvasView view = view_;
  view.fit(studio_.page().area());
  set_view(view);
}

void Canvas::fit_selection() {
  CanvasView view = view_;
  view.fit(studio_.session().selection().bounds(studio_.session().document()));
  set_view(view);
}

void Canvas::fit_ink() {
  CanvasView view = view_;
  Rect all = studio_.page().area();
  for (const Layer& layer : studio_.session().document().layers()) {
    for (const StrokeId id : layer.strokes) {
      const Rect box = studio_.session().document().find(id)->bounds();
      all.extend(Point{box.x0, box.y0});
      all.extend(Point{box.x1, box.y1});
    }
  }
  view.fit(all);
  set_view(view);
}

double Canvas::zoom() const {
  return view_.px_per_mm() * 25.4 / logicalDpiX();
}

void Canvas::set_zoom(double zoom) {
  CanvasView view = view_;
  view.set_scale(zoom * logicalDpiX() / 25.4);
  set_view(view);
}

void Canvas::set_outline_mode(bool on) {
  ink_.set_outline_mode(on);
}

void Canvas::set_pen_visible(bool visible) {
  pen_visible_ = visible;
  update();
}

void Canvas::resizeEvent(QResizeEvent*) {
  view_.set_size(size());
  if (!was_fitted_) view_.fit(studio_.page().area());
  was_fitted_ = true;
  ink_.set_view(view_, devicePixelRatioF());
}

void Canvas::paintEvent(QPaintEvent* event) {
  studio_.turn();
  QPainter painter(this);
  painter.fillRect(event->rect(), palette().color(QPalette::Mid));
  painter.setRenderHint(QPainter::Antialiasing);
  painter.save();
  painter.setTransform(view_.transform(), true);
  const SheetPage& page = studio_.page();
  painter.fillRect(QRectF(0, 0, page.width_mm, page.height_mm),
                   QColor(page.paper.r, page.paper.g, page.paper.b, page.paper.a));
  painter.restore();
  ink_.paint(painter, event->rect());
  studio_.session().draw(overlay_);
  painter.setTransform(view_.transform(), true);
  painter.setPen(QPen(Qt::black, 0.5, Qt::SolidLine, Qt::RoundCap));
  for (const auto& segment : overlay_.ink) {
    const auto& p = segment.curve.p;
    QPainterPath path(QPointF(p[0].x, p[0].y));
    path.cubicTo(p[1].x, p[1].y, p[2].x, p[2].y, p[3].x, p[3].y);
    painter.drawPath(path);
  }
}

}  // namespace felt::desktop
