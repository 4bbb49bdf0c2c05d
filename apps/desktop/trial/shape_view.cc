#include "desktop/trial/shape_view.h"

#include <QPaintEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPainterPathStroker>
#include <algorithm>
#include <cmath>

#include "felt/geometry/polyline.h"
#include "felt/studies/measured_trial.h"

namespace felt::desktop {
namespace {

const QColor kLineColor(208, 210, 214);
const QColor kWallColor(150, 154, 160);
const QColor kStartColor(46, 112, 190);
const QColor kErasedColor(250, 214, 150);
constexpr double kLineMm = 0.8;
constexpr double kErasedMm = 3.0;  // breadth of the mark on the part to be erased
constexpr double kWallMm = 0.4;
constexpr double kStartMm = 1.6;    // radius of the start dot
constexpr double kArrowAtMm = 7.0;  // from the start to the tip of the arrow
constexpr double kArrowMm = 3.2;    // length of its head
constexpr double kTargetMm = 8.0;   // diameter of a target without a width of its own
constexpr double kCornerDeg = 20.0;

StudyPath without_closing_point(StudyPath path) {
  if (path.ends == TrialPathEnds::kClosed && path.points.size() > 1 &&
      path.points.front() == path.points.back()) {
    path.points.pop_back();
  }
  return path;
}

/// Returns the points to connect: the ends, and the corners between them.
std::vector<Point> targets_of(const StudyPath& whole) {
  const StudyPath path = without_closing_point(whole);
  std::vector<Point> targets;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == path.points.size();
    const bool is_last_of_closed = i > 0 && is_end && path.ends == TrialPathEnds::kClosed;
    if (!is_end || is_last_of_closed) {
      const Point next = path.points[(i + 1) % path.points.size()];
      const Vec a = path.points[i] - path.points[i - 1], b = next - path.points[i];
      const double turn = std::abs(std::atan2(cross(a, b), dot(a, b))) * 180.0 / M_PI;
      if (turn < kCornerDeg) continue;
    }
    targets.push_back(path.points[i]);
  }
  return targets;
}

/// Returns the point on the line at a distance from its first point.
QPointF point_at(const QPolygonF& line, double distance) {
  for (qsizetype i = 1; i < line.size(); ++i) {
    const QLineF part(line[i - 1], line[i]);
    if (part.length() >= distance && part.length() > 0.0) {
      return part.pointAt(distance / part.length());
    }
    distance -= part.length();
  }
  return line.back();
}

}  // namespace

ShapeView::ShapeView(Canvas& canvas) : QWidget(&canvas), canvas_(canvas) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  canvas.installEventFilter(this);
  connect(&canvas, &Canvas::view_changed, this, &ShapeView::render);
}

void ShapeView::set_trial(const StudyFiles& files, const PlannedTrial& trial) {
  files_ = &files;
  trial_ = trial;
  is_blank_ = false;
  canvas_.setCursor(canvas_.pen_cursor());
  render();
}

void ShapeView::begin_drawing() {
  if (!files_ || files_->study.conditions[trial_.condition].has_vision) return;
  is_blank_ = true;
  canvas_.setCursor(Qt::BlankCursor);
  update();
}

bool ShapeView::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    resize(canvas_.size());
    render();
  }
  return false;
}

QPolygonF ShapeView::on_screen(const StudyPath& path) const {
  QPolygonF line;
  for (const Point& point : path.points) line.push_back(canvas_.view().to_px(point));
  if (path.ends == TrialPathEnds::kClosed && !line.isEmpty()) line.push_back(line.front());
  return line;
}

void ShapeView::render() {
  if (!files_ || size().isEmpty()) return;
  picture_ = QPixmap(size() * devicePixelRatioF());
  picture_.setDevicePixelRatio(devicePixelRatioF());
  picture_.fill(Qt::white);
  QPainter painter(&picture_);
  painter.setRenderHint(QPainter::Antialiasing);
  const StudyShape& shape = files_->study.shapes[trial_.shape];
  const StudyPath& path = files_->paths[trial_.shape];
  if (!files_->study.conditions[trial_.condition].has_vision) {
    if (shape.task != StudyTask::kFind) paint_start(painter, path, false);
    return update();
  }
  switch (shape.task) {
    case StudyTask::kTrace:
    case StudyTask::kClose:
      paint_path(painter, path, kLineMm);
      paint_start(painter, path, true);
      break;
    case StudyTask::kTunnel:
      paint_tunnel(painter, path, shape.tunnel_mm);
      paint_start(painter, path, true);
      break;
    case StudyTask::kCopy:
      paint_path(painter, model_of(path), kLineMm);
      paint_start(painter, model_of(path), true);
      break;
    case StudyTask::kConnect:
      paint_targets(painter, path,
                    geometry_of(*files_, trial_).target_width_mm.value_or(kTargetMm));
      break;
    case StudyTask::kFind:
      break;
    case StudyTask::kRetrace:  // the line is ink
      paint_start(painter, path, true);
      break;
    case StudyTask::kWidth:
      paint_path(painter, path, shape.width_mm);
      paint_start(painter, path, true);
      break;
    case StudyTask::kErase:
      paint_erased(painter);
      break;
  }
  update();
}

void ShapeView::paint_path(QPainter& painter, const StudyPath& path, double width_mm) const {
  painter.setPen(QPen(kLineColor, width_mm * canvas_.view().px_per_mm(), Qt::SolidLine,
                      Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(on_screen(path));
}

void ShapeView::paint_erased(QPainter& painter) const {
  const ErasedPage page = erased_page_of(*files_, trial_);
  const CanvasView& view = canvas_.view();
  painter.setPen(QPen(kErasedColor, kErasedMm * view.px_per_mm(), Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(view.to_px(point_at_length(page.line, page.from_mm)),
                   view.to_px(point_at_length(page.line, page.to_mm)));
}

void ShapeView::paint_tunnel(QPainter& painter, const StudyPath& path, double width_mm) const {
  QPainterPath line;
  line.addPolygon(on_screen(path));
  if (path.ends == TrialPathEnds::kClosed) line.closeSubpath();
  QPainterPathStroker stroker;
  stroker.setWidth(width_mm * canvas_.view().px_per_mm());
  stroker.setCapStyle(Qt::FlatCap);
  stroker.setJoinStyle(Qt::RoundJoin);
  stroker.setCurveThreshold(0.1);
  painter.setPen(QPen(kWallColor, kWallMm * canvas_.view().px_per_mm(), Qt::SolidLine, Qt::RoundCap,
                      Qt::RoundJoin));
  painter.drawPath(stroker.createStroke(line).simplified());
}

void ShapeView::paint_targets(QPainter& painter, const StudyPath& path, double width_mm) const {
  const double px = canvas_.view().px_per_mm(), radius = 0.5 * width_mm * px;
  QFont font = this->font();
  font.setPixelSize(std::max(8, static_cast<int>(std::min(0.6 * width_mm, 5.0) * px)));
  painter.setFont(font);
  int number = 0;
  for (const Point& target : targets_of(path)) {
    const QPointF at = canvas_.view().to_px(target);
    painter.setPen(QPen(kStartColor, kWallMm * px));
    painter.setBrush(Qt::white);
    painter.drawEllipse(at, radius, radius);
    painter.drawText(QRectF(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius),
                     Qt::AlignCenter | Qt::TextDontClip, QString::number(++number));
  }
}

void ShapeView::paint_start(QPainter& painter, const StudyPath& path, bool has_arrow) const {
  const QPolygonF line = on_screen(path);
  if (line.isEmpty()) return;
  const double px = canvas_.view().px_per_mm();
  painter.setPen(Qt::NoPen);
  painter.setBrush(kStartColor);
  painter.drawEllipse(line.front(), kStartMm * px, kStartMm * px);
  if (!has_arrow) return;
  const QPointF tip = point_at(line, kArrowAtMm * px);
  const QLineF along(point_at(line, (kArrowAtMm - kArrowMm) * px), tip);
  if (along.length() <= 0.0) return;
  const QPointF side = QPointF(-along.dy(), along.dx()) / along.length() * (0.55 * kArrowMm * px);
  painter.drawPolygon(QPolygonF({tip, along.p1() + side, along.p1() - side}));
}

void ShapeView::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  if (is_blank_) {
    painter.fillRect(event->rect(), Qt::white);
    return;
  }
  painter.setCompositionMode(QPainter::CompositionMode_Multiply);
  const double dpr = picture_.devicePixelRatio();
  const QRectF part(event->rect());
  painter.drawPixmap(part, picture_, QRectF(part.topLeft() * dpr, part.size() * dpr));
}

}  // namespace felt::desktop
