#pragma once

#include <QDialog>
#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <memory>
#include <vector>

#include "desktop/engine/pen_device.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Asks the user to touch three corners of the wanted drawing area, and computes the plane from
/// them. A picture shows the moving pen. Reads the device itself, or in its own loop if the
/// vendor's loop must run it; sends no force.
class CalibrationDialog : public QDialog {
  Q_OBJECT

 public:
  static constexpr std::size_t kCorners = 3;

  /// `device` reports positions in its own frame or through an older calibration. The new drawing
  /// area will lie around `middle` on the page.
  CalibrationDialog(std::unique_ptr<PenDevice> device, Point middle, QWidget* parent = nullptr);
  ~CalibrationDialog() override;

  /// Calibrates the device in use, while mouse and tablet replace it, and stores the result unless
  /// it is cancelled. The device stays open, so that it keeps its homing.
  static void run(Studio& studio, QWidget* parent);

  /// Records the pen's position as the corner that was asked for. Called by the button, Space and
  /// the pen's first button.
  void take();
  void start_again();
  /// Returns the plane once all corners were touched and are plausible.
  [[nodiscard]] const std::optional<PlaneFit>& found() const noexcept { return found_; }
  /// Returns the part of the plane between the corners.
  [[nodiscard]] std::optional<DrawingArea> area() const;
  /// Stops reading the device and returns it; null if it is unresponsive.
  std::unique_ptr<PenDevice> take_device();

 private:
  /// Reads the pen's position; returns the buttons that were pressed since the last call.
  std::uint32_t read();
  void look();
  void tell();
  void draw();
  [[nodiscard]] QPointF in_picture(const Vec3& device_mm) const;

  std::unique_ptr<PenDevice> device_;
  std::unique_ptr<Servo> servo_;  // if the vendor's loop runs it
  std::unique_ptr<RealtimeThread> loop_;
  PlaneCalibration old_;
  PlaneCalibration usual_;  // the usual plane, for the picture until the new one is known
  DrawingArea reach_;
  Point middle_;
  std::vector<Vec3> corners_;  // in the device's frame
  std::optional<Vec3> place_;  // of the pen, in the device's frame
  std::uint32_t buttons_ = 0;
  std::optional<PlaneFit> found_;
  QElapsedTimer clock_;
  QTimer timer_;
  QLabel* picture_;
  QLabel* words_;
  QLabel* where_;
  QPushButton* take_;
  QPushButton* again_;
  QPushButton* keep_;
};

}  // namespace felt::desktop
