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

/// Asks the user to touch three corners of the intended drawing area, and computes the plane from
/// them. A picture shows the moving pen. The dialog reads the device directly, or through a Servo
/// if the device works only in the vendor's own loop. It sends no force.
class CalibrationDialog : public QDialog {
  Q_OBJECT

 public:
  static constexpr std::size_t kCorners = 3;

  /// `device` reports positions in its own frame or through an older calibration. The centre of
  /// the new drawing area will be at `middle` on the page.
  CalibrationDialog(std::unique_ptr<PenDevice> device, Point middle, QWidget* parent = nullptr);
  ~CalibrationDialog() override;

  /// Calibrates the device in use and stores the result unless the user cancels. While the dialog
  /// is open, mouse and tablet replace the device in the studio. The device is not closed, so that
  /// it does not have to be homed again.
  static void run(Studio& studio, QWidget* parent);

  /// Records the pen's position as the requested corner. Called by the button, Space and the pen's
  /// first button.
  void take();
  void start_again();
  /// Returns the plane if all corners were touched and are plausible.
  [[nodiscard]] const std::optional<PlaneFit>& found() const noexcept { return found_; }
  /// Returns the rectangle between the corners in the plane.
  [[nodiscard]] std::optional<DrawingArea> area() const;
  /// Stops reading the device and returns it, or null if the device is unresponsive.
  std::unique_ptr<PenDevice> take_device();

 private:
  /// Reads the pen's position. Returns the buttons that were pressed since the last call.
  std::uint32_t read();
  void look();
  void report();
  void draw();
  [[nodiscard]] QPointF in_picture(const Vec3& device_mm) const;

  std::unique_ptr<PenDevice> device_;
  std::unique_ptr<Servo> servo_;  // null unless the device works only in the vendor's own loop
  std::unique_ptr<RealtimeThread> loop_;
  PlaneCalibration old_;
  PlaneCalibration usual_;  // the default plane; the picture shows it until the new plane is known
  DrawingArea reach_;
  Point middle_;
  std::vector<Vec3> corners_;  // in the frame of the device
  std::optional<Vec3> place_;  // position of the pen in the frame of the device
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
