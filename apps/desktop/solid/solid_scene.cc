#include "desktop/solid/solid_scene.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace felt::desktop {
namespace {

/// The first direction shows that the bodies are round; that of feltline inflate --png.
constexpr double kFirstTurnDeg = SolidView().turn_deg, kFirstRiseDeg = SolidView().rise_deg;
constexpr double kDragDegPerPx = 0.5;
constexpr double kKeyDeg = 15.0, kFineKeyDeg = 3.0;
constexpr double kKeyZoom = 1.25;
constexpr double kMinZoom = 0.2, kMaxZoom = 50.0;
constexpr double kWheelStep = 120.0;  // of QWheelEvent::angleDelta() for one step of a wheel
constexpr double kFill = 0.94;        // share of the widget that the bodies fill
constexpr double kLinePx = 2.5;       // of a stroke over the bodies
constexpr double kBallPx = 6.0, kForcePxPerN = 60.0;

bool is_scene_key(int key) {
  switch (key) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
    case Qt::Key_Home:
      return true;
    default:
      return false;
  }
}

}  // namespace

SolidScene::SolidScene(QWidget* parent, Painter painter)
    : QWidget(parent), painter_(painter), turn_deg_(kFirstTurnDeg), rise_deg_(kFirstRiseDeg) {
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, [this] {
    if (gl_) repaint_solid();  // the processor always paints smooth edges
  });
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(tr("Solid"));
  setAccessibleDescription(
      tr("Arrow keys turn the solid, plus and minus zoom, Home shows the first view again"));
}

SolidScene::~SolidScene() = default;

void SolidScene::set_solid(std::shared_ptr<const Solid> solid,
                           std::shared_ptr<const FrontPaint> paint) {
  solid_ = std::move(solid);
  paint_ = std::move(paint);
  is_in_gl_ = false;
  radius_mm_ = left_mm_ = right_mm_ = 0.0;
  if (solid_) {
    for (const SolidBody& body : solid_->bodies) {
      for (const Vec3& p : body.points) {
        radius_mm_ = std::max(radius_mm_, norm(p));
        left_mm_ = std::min(left_mm_, p.x), right_mm_ = std::max(right_mm_, p.x);
      }
    }
  }
  repaint_solid();
}

void SolidScene::show_proxy(const std::optional<SolidTouchMarks>& marks) {
  marks_ = marks;
  update();
}

void SolidScene::set_tool(BodyTool tool) {
  tool_ = tool;
  draws_ = false;
  stroke_.clear();
  tool == BodyTool::kTurn ? unsetCursor() : setCursor(Qt::CrossCursor);
  update();
}

void SolidScene::set_lines(std::vector<std::vector<Vec3>> lines) {
  lines_ = std::move(lines);
  update();
}

std::vector<Vec3> SolidScene::on_plane(const std::vector<QPointF>& px) const {
  const SolidCamera camera = this->camera();
  std::vector<Vec3> points;
  for (const QPointF p : px) {
    points.push_back((p.x() - camera.origin_px.x) / camera.px_per_mm * camera.right +
                     (camera.origin_px.y - p.y()) / camera.px_per_mm * camera.up);
  }
  return points;
}

void SolidScene::set_wireframe(WireframeChoice wireframe) {
  wireframe_ = wireframe;
  repaint_solid();
}

void SolidScene::set_section(std::optional<double> share) {
  section_ = share;
  repaint_solid(SolidGl::Quality::kFast);
}

void SolidScene::set_placeholder(const QString& text) {
  placeholder_ = text;
  if (!solid_) update();
}

void SolidScene::turn(double right_deg, double up_deg) {
  // Turning the body to the right moves the camera to the left.
  turn_deg_ = std::remainder(turn_deg_ - right_deg, 360.0);
  rise_deg_ = std::clamp(rise_deg_ - up_deg, -90.0, 90.0);
  repaint_solid(SolidGl::Quality::kFast);
}

void SolidScene::zoom(double factor, QPointF at) {
  const double now = std::clamp(zoom_ * factor, kMinZoom, kMaxZoom);
  const QPointF from_middle = at - QPointF(0.5 * width(), 0.5 * height());
  shift_ = from_middle + (now / zoom_) * (shift_ - from_middle);
  zoom_ = now;
  repaint_solid(SolidGl::Quality::kFast);
}

void SolidScene::reset_view() {
  turn_deg_ = kFirstTurnDeg;
  rise_deg_ = kFirstRiseDeg;
  zoom_ = 1.0;
  shift_ = {};
  repaint_solid();
}

SolidCamera SolidScene::camera() const {
  SolidCamera camera = solid_camera(turn_deg_, rise_deg_);
  camera.px_per_mm = zoom_ * 0.5 * kFill * std::min(width(), height()) / std::max(radius_mm_, 1e-6);
  camera.origin_px = {0.5 * width() + shift_.x(), 0.5 * height() + shift_.y()};
  return camera;
}

SolidLook SolidScene::look() const {
  const QColor paper = palette().color(QPalette::Base);
  SolidLook look;
  look.paper = {static_cast<std::uint8_t>(paper.red()), static_cast<std::uint8_t>(paper.green()),
                static_cast<std::uint8_t>(paper.blue()), 255};
  look.wireframe = wireframe_;
  look.paint = paint_.get();
  if (section_) look.section_x_mm = left_mm_ + *section_ * (right_mm_ - left_mm_);
  return look;
}

void SolidScene::repaint_solid(SolidGl::Quality quality) {
  is_stale_ = true;
  quality_ = quality;
  if (quality == SolidGl::Quality::kFast) rest_.start();
  update();
}

QImage SolidScene::painted(const SolidCamera& camera, QSize size_px) {
  if (!has_tried_gl_ && painter_ == Painter::kAny) gl_ = SolidGl::create();
  has_tried_gl_ = true;
  if (gl_) {
    if (!std::exchange(is_in_gl_, true)) gl_->set_solid(*solid_, paint_.get());
    QImage image = gl_->paint(camera, look(), size_px, quality_);
    if (!image.isNull()) return image;
    gl_.reset();  // the driver has failed; from now on, the processor paints
  }
  Result<Image> image = paint_solid(*solid_, camera, look(), size_px.width(), size_px.height());
  if (!image) return {};
  const Pixels pixels = image->pixels();
  return QImage(pixels.data, pixels.width, pixels.height, qsizetype(pixels.stride),
                QImage::Format_RGBX8888)
      .copy();
}

void SolidScene::render() {
  if (!std::exchange(is_stale_, false)) return;
  const double ratio = devicePixelRatioF();
  SolidCamera scaled = camera();
  scaled.px_per_mm *= ratio;
  scaled.origin_px = {ratio * scaled.origin_px.x, ratio * scaled.origin_px.y};
  image_ = painted(scaled, (QSizeF(size()) * ratio).toSize());
  image_.setDevicePixelRatio(ratio);
}

void SolidScene::paint_marks(QPainter& painter) const {
  if (!marks_) return;
  const SolidCamera camera = this->camera();
  const auto shown = [&camera](const Vec3& p) {
    const Vec3 px = camera.to_px(p);
    return QPointF(px.x, px.y);
  };
  const QPointF proxy = shown(marks_->proxy_mm);
  const Vec3 force_mm = (kForcePxPerN / camera.px_per_mm) * marks_->force_n;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
  painter.drawLine(proxy, shown(marks_->pen_mm));
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.5));
  painter.drawLine(proxy, shown(marks_->proxy_mm + force_mm));
  painter.setPen(QPen(palette().color(QPalette::Text), 1.0));
  painter.setBrush(palette().color(QPalette::Highlight));
  painter.drawEllipse(proxy, kBallPx, kBallPx);
}

/// Paints the stroke in progress and the lines that are shown.
void SolidScene::paint_lines(QPainter& painter) const {
  if (stroke_.empty() && lines_.empty()) return;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(palette().color(QPalette::Highlight), kLinePx, Qt::SolidLine, Qt::RoundCap,
                      Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolyline(stroke_.data(), static_cast<int>(stroke_.size()));
  const SolidCamera camera = this->camera();
  for (const std::vector<Vec3>& line : lines_) {
    std::vector<QPointF> px;
    for (const Vec3& p : line) {
      const Vec3 at = camera.to_px(p);
      px.emplace_back(at.x, at.y);
    }
    painter.drawPolyline(px.data(), static_cast<int>(px.size()));
  }
}

void SolidScene::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (solid_) {
    render();
    painter.drawImage(QPoint(), image_);
    paint_lines(painter);
    paint_marks(painter);
  } else {
    painter.fillRect(rect(), palette().color(QPalette::Base));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                     placeholder_);
  }
  if (hasFocus()) {
    painter.setPen(palette().color(QPalette::Highlight));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void SolidScene::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  repaint_solid(SolidGl::Quality::kFast);
}

void SolidScene::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) repaint_solid();
}

/// Keys of the scene win against the window's shortcuts while it has the focus.
bool SolidScene::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool is_plain = !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier));
    const bool is_escape = key->key() == Qt::Key_Escape && tool_ != BodyTool::kTurn;
    if (is_plain && (is_scene_key(key->key()) || is_escape)) event->accept();
  }
  if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) update();
  return QWidget::event(event);
}

void SolidScene::mousePressEvent(QMouseEvent* event) {
  last_ = event->position();
  draws_ = tool_ != BodyTool::kTurn && event->button() == Qt::LeftButton && solid_;
  if (!draws_) return setCursor(Qt::ClosedHandCursor);
  stroke_ = {last_};
  update();
}

void SolidScene::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton) return;
  if (draws_) {
    stroke_.push_back(event->position());
    return update();
  }
  const QPointF moved = event->position() - std::exchange(last_, event->position());
  turn(kDragDegPerPx * moved.x(), -kDragDegPerPx * moved.y());
}

void SolidScene::mouseReleaseEvent(QMouseEvent*) {
  tool_ == BodyTool::kTurn ? unsetCursor() : setCursor(Qt::CrossCursor);
  if (!std::exchange(draws_, false)) return;
  const std::vector<QPointF> stroke = std::exchange(stroke_, {});
  update();
  Q_EMIT stroke_drawn(stroke);
}

void SolidScene::mouseDoubleClickEvent(QMouseEvent* event) {
  if (tool_ != BodyTool::kTurn) return mousePressEvent(event);
  reset_view();
}

void SolidScene::wheelEvent(QWheelEvent* event) {
  zoom(std::pow(kKeyZoom, event->angleDelta().y() / kWheelStep), event->position());
  event->accept();
}

void SolidScene::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers() & Qt::ShiftModifier ? kFineKeyDeg : kKeyDeg;
  const QPointF middle(0.5 * width(), 0.5 * height());
  switch (event->key()) {
    case Qt::Key_Left:
      return turn(-step, 0.0);
    case Qt::Key_Right:
      return turn(step, 0.0);
    case Qt::Key_Up:
      return turn(0.0, step);
    case Qt::Key_Down:
      return turn(0.0, -step);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(kKeyZoom, middle);
    case Qt::Key_Minus:
      return zoom(1.0 / kKeyZoom, middle);
    case Qt::Key_Home:
      return reset_view();
    case Qt::Key_Escape:
      if (tool_ == BodyTool::kTurn) return QWidget::keyPressEvent(event);
      return Q_EMIT escaped();
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace felt::desktop
