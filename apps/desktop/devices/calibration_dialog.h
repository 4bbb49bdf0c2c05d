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

/// Asks a person to touch three corners of what shall be the drawing area, and finds the plane from
/// them. Its picture shows the pen as it moves. Reads the device itself, or by a loop of its own
/// where the maker's must run it; no force is sent meanwhile.
class CalibrationDialog : public QDialog {
  Q_OBJECT

 public:
  static constexpr std::size_t kCorners = 3;

  /// The device in its own frame or through an older calibration; the drawing area comes to lie
  /// around `middle` of the sheet.
  CalibrationDialog(std::unique_ptr<PenDevice> device, Point middle, QWidget* parent = nullptr);
  ~CalibrationDialog() override;

  /// For the device in use, which mouse and tablet stand in for meanwhile; keeps what was found
  /// unless it is cancelled. It stays open: whatever it needed to find its home it keeps.
  static void run(Studio& studio, QWidget* parent);

  /// The pen is at the corner that is asked for. The button, Space and the pen's first button.
  void take();
  void start_again();
  /// Once all corners are known and make sense.
  [[nodiscard]] const std::optional<PlaneFit>& found() const noexcept { return found_; }
  /// The part of the plane between the corners.
  [[nodiscard]] std::optional<DrawingArea> area() const;
  /// Ends reading it, and gives it back; null where it hangs in its maker's call.
  std::unique_ptr<PenDevice> take_device();

 private:
  /// Where the pen is; returns the buttons that went down.
  std::uint32_t read();
  void look();
  void tell();
  void draw();
  [[nodiscard]] QPointF in_picture(const Vec3& device_mm) const;

  std::unique_ptr<PenDevice> device_;
  std::unique_ptr<Servo> servo_;  // where the maker's loop runs it
  std::unique_ptr<RealtimeThread> loop_;
  PlaneCalibration old_;
  PlaneCalibration usual_;  // where the plane may lie, for the picture until it is known
  DrawingArea reach_;
  Point middle_;
  std::vector<Vec3> corners_;  // in the device's frame
  std::optional<Vec3> place_;  // of the pen, likewise
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
