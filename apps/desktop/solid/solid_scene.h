#pragma once

#include <QImage>
#include <QString>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "desktop/solid/body_tool.h"
#include "desktop/solid/solid_gl.h"
#include "desktop/solid/solid_touch_marks.h"
#include "felt/solid/solid.h"
#include "felt/solid/solid_picture.h"

namespace felt::desktop {

/// Shows bodies, lit, and lets the user turn them: a drag with any button of mouse or pen turns,
/// the wheel zooms at the pointer, a double click resets. With the focus: arrow keys turn (with
/// Shift in small steps), + and - zoom, Home resets. If another tool is set, a drag with the left
/// button or the pen draws a stroke instead; it is shown while it is drawn.
///
/// Painted with OpenGL (SolidGl), or with paint_solid() if there is no OpenGL. While the user turns
/// the bodies, their edges are not smooth; they are kRestMs later.
class SolidScene : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kRestMs = 150;
  /// With what it is painted.
  enum class Painter : std::uint8_t { kAny, kSoftware };

  explicit SolidScene(QWidget* parent = nullptr, Painter painter = Painter::kAny);
  ~SolidScene() override;

  /// Sets the bodies, null if there are none, and the ink on them, null if there is none. The
  /// directions and the zoom stay.
  void set_solid(std::shared_ptr<const Solid> solid, std::shared_ptr<const FrontPaint> paint = {});
  /// Returns the bodies that are shown, or null.
  [[nodiscard]] const std::shared_ptr<const Solid>& solid() const noexcept { return solid_; }
  /// Shows a pen that touches a body, or removes it. Cheap: only the marks are painted again.
  void show_proxy(const std::optional<SolidTouchMarks>& marks);

  /// Sets what a drag with the left button or the pen does. Discards the stroke in progress.
  void set_tool(BodyTool tool);
  /// Shows lines over the bodies, in the frame of the solid, in mm, instead of the previous ones.
  void set_lines(std::vector<std::vector<Vec3>> lines);
  /// Returns the points under pixels of the widget, on the plane through the origin of the solid
  /// that faces the camera.
  [[nodiscard]] std::vector<Vec3> on_plane(const std::vector<QPointF>& px) const;

  void set_wireframe(WireframeChoice wireframe);
  /// Cuts away what is farther to the right than this share of the width, 0..1. Nullopt: nothing.
  void set_section(std::optional<double> share);
  /// Sets the sentence that is shown while there is no body.
  void set_placeholder(const QString& text);

  /// Turns the bodies to the right and upwards, in degrees.
  void turn(double right_deg, double up_deg);
  /// Zooms by a factor, so that the point at `at` (in pixels of the widget) stays.
  void zoom(double factor, QPointF at);
  /// Shows all bodies from the first direction again.
  void reset_view();

  /// Returns the camera of the picture, in pixels of the widget.
  [[nodiscard]] SolidCamera camera() const;
  /// Returns true if the last picture was painted with OpenGL.
  [[nodiscard]] bool uses_opengl() const noexcept { return gl_ != nullptr; }

  [[nodiscard]] QSize sizeHint() const override { return {420, 420}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 160}; }

 Q_SIGNALS:
  /// The user has drawn a stroke with the tool, in pixels of the widget.
  void stroke_drawn(const std::vector<QPointF>& px);
  /// The user has pressed Escape, which turns the tool off.
  void escaped();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void repaint_solid(SolidGl::Quality quality = SolidGl::Quality::kSmooth);
  void render();
  [[nodiscard]] QImage painted(const SolidCamera& camera, QSize size_px);
  [[nodiscard]] SolidLook look() const;
  void paint_marks(QPainter& painter) const;
  void paint_lines(QPainter& painter) const;

  Painter painter_;
  std::shared_ptr<const Solid> solid_;
  std::shared_ptr<const FrontPaint> paint_;
  std::optional<SolidTouchMarks> marks_;
  std::unique_ptr<SolidGl> gl_;
  bool has_tried_gl_ = false, is_in_gl_ = false, is_stale_ = true;
  SolidGl::Quality quality_ = SolidGl::Quality::kSmooth;
  QTimer rest_;
  QImage image_;
  QString placeholder_;
  WireframeChoice wireframe_ = WireframeChoice::kHide;
  std::optional<double> section_;
  double radius_mm_ = 1.0;                 // of a ball around the origin that contains all bodies
  double left_mm_ = 0.0, right_mm_ = 0.0;  // the range of x
  double turn_deg_, rise_deg_;
  double zoom_ = 1.0;
  QPointF shift_;  // of the origin from the middle, in pixels
  QPointF last_;   // position of the drag
  BodyTool tool_ = BodyTool::kTurn;
  bool draws_ = false;           // the drag is a stroke of the tool
  std::vector<QPointF> stroke_;  // in progress, in pixels
  std::vector<std::vector<Vec3>> lines_;
};

}  // namespace felt::desktop
