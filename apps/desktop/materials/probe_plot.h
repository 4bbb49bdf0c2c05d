#pragma once

#include <QWidget>

#include "desktop/materials/force_probe.h"

namespace felt::desktop {

/// A plot of the predicted force on the pen during a stroke of 40 mm with even pressure. It shows
/// the force that opposes the motion as a function of the position along the stroke. A band extends
/// from 0.04 N below the mean force to 0.04 N above it. The hand does not feel changes within the
/// band. The parts of the plot outside of the band are filled: they are the grain that the hand
/// feels.
class ProbePlot : public QWidget {
  Q_OBJECT

 public:
  /// Smallest change of a force that is perceived, N (docs/design/simulation.md#perception).
  static constexpr double kFeltN = 0.04;

  explicit ProbePlot(QWidget* parent = nullptr);

  void show_figures(const ProbeFigures& figures);
  /// Returns the largest deviation from the mean, in N; 0 if no stroke was set.
  [[nodiscard]] double departure_n() const noexcept { return departure_n_; }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QRectF axes() const;
  [[nodiscard]] double top_n() const;
  void draw_axes(QPainter& painter, const QRectF& in) const;
  void draw_band(QPainter& painter, const QRectF& in) const;
  void draw_line(QPainter& painter, const QRectF& in) const;

  ProbeFigures figures_;
  double mean_n_ = 0.0;
  double departure_n_ = 0.0;
};

}  // namespace felt::desktop
