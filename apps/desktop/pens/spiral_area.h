#pragma once

#include <QWidget>
#include <cstdint>
#include <optional>
#include <vector>

#include "felt/haptics/pen_sample.h"
#include "felt/stroke/fit/ink_fit.h"

namespace felt::desktop {

/// An area with a spiral that the user traces with mouse, tablet, or a device that the user holds.
/// It collects the samples of the pen while it touches; they are not part of a drawing, and nothing
/// stores them.
class SpiralArea : public QWidget {
  Q_OBJECT

 public:
  explicit SpiralArea(QWidget* parent = nullptr);

  [[nodiscard]] const std::vector<InkSample>& samples() const noexcept { return samples_; }
  /// Returns the time in s during which the pen has touched.
  [[nodiscard]] double drawn_s() const noexcept { return drawn_s_; }
  void clear();
  /// Handles a sample of a device that the user holds. Its first touch is in the middle of the
  /// spiral, wherever the device is.
  void add(const PenSample& sample);
  [[nodiscard]] QSize sizeHint() const override;

 Q_SIGNALS:
  /// Emitted for each sample while the pen touches.
  void drawn();
  /// Emitted when the pen is lifted.
  void lifted();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void tabletEvent(QTabletEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void point(QPointF at, bool touching, std::uint64_t stamp_ms);
  void point(QPointF at, Point mm, bool touching, std::int64_t time_ns);
  [[nodiscard]] double mm_per_px() const;

  std::vector<InkSample> samples_;
  std::optional<Point> middle_mm_;  // of the spiral, where the device touched first
  std::vector<QPointF> ink_;        // the samples in pixels; a NaN separates lines
  double drawn_s_ = 0.0;
  bool touches_ = false;
};

}  // namespace felt::desktop
