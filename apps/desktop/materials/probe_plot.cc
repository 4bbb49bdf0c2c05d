#include "desktop/materials/probe_plot.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "desktop/panels/tool_icons.h"

namespace felt::desktop {
namespace {

constexpr std::array kTops{0.2, 0.5, 1.0, 2.0, 5.0};  // N
constexpr double kStepMm = 10.0;

}  // namespace

ProbePlot::ProbePlot(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  setAccessibleName(tr("Plot of the force along a stroke of 40 mm"));
}

void ProbePlot::show_figures(const ProbeFigures& figures) {
  figures_ = figures;
  const std::vector<double>& drag = figures_.drag_n;
  mean_n_ = drag.empty()
                ? 0.0
                : std::accumulate(drag.begin(), drag.end(), 0.0) / static_cast<double>(drag.size());
  departure_n_ = 0.0;
  for (const double newton : drag)
    departure_n_ = std::max(departure_n_, std::abs(newton - mean_n_));
  const QLocale locale;
  const QString drag_text = locale.toString(mean_n_, 'f', 2);
  const QString grain_text = locale.toString(departure_n_, 'f', 2);
  setAccessibleDescription(
      departure_n_ >= kFeltN
          ? tr("%1 N of friction; the grain changes it by up to %2 N, which can be felt.")
                .arg(drag_text, grain_text)
          : tr("%1 N of friction; the grain changes it by up to %2 N, which is too little to feel.")
                .arg(drag_text, grain_text));
  setToolTip(accessibleDescription());
  update();
}

QSize ProbePlot::sizeHint() const {
  return {36 * fontMetrics().averageCharWidth(), 9 * fontMetrics().height()};
}

QSize ProbePlot::minimumSizeHint() const {
  return {24 * fontMetrics().averageCharWidth(), 6 * fontMetrics().height()};
}

QRectF ProbePlot::axes() const {
  const QFontMetrics metrics = fontMetrics();
  const double left = metrics.horizontalAdvance(QStringLiteral("0.00 N")) + 8;
  return QRectF(rect()).adjusted(left, 0.6 * metrics.height(), -6, -1.4 * metrics.height());
}

double ProbePlot::top_n() const {
  const double largest = mean_n_ + std::max(departure_n_, 2.0 * kFeltN);
  const auto fits =
      std::find_if(kTops.begin(), kTops.end(), [&](double top) { return top >= largest; });
  return fits == kTops.end() ? std::ceil(largest) : *fits;
}

void ProbePlot::draw_axes(QPainter& painter, const QRectF& in) const {
  QColor faint = palette().color(QPalette::Text);
  faint.setAlphaF(0.25F);
  const QLocale locale;
  const double line = fontMetrics().height();
  for (const double share : {0.0, 0.5, 1.0}) {
    const double y = in.bottom() - share * in.height();
    painter.setPen(faint);
    painter.drawLine(QPointF(in.left(), y), QPointF(in.right(), y));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRectF(0, y - 0.5 * line, in.left() - 4, line),
                     Qt::AlignRight | Qt::AlignVCenter,
                     tr("%1 N").arg(locale.toString(share * top_n(), 'f', top_n() < 1.0 ? 2 : 1)));
  }
  for (double mm = 0.0; mm <= ProbeFigures::kLengthMm; mm += kStepMm) {
    const double x = in.left() + mm / ProbeFigures::kLengthMm * in.width();
    painter.setPen(faint);
    painter.drawLine(QPointF(x, in.top()), QPointF(x, in.bottom()));
    painter.setPen(palette().color(QPalette::Text));
    const bool is_last = mm + kStepMm > ProbeFigures::kLengthMm;
    const QString text = is_last ? tr("%1 mm").arg(mm, 0, 'f', 0) : locale.toString(mm, 'f', 0);
    const double width = 8.0 * fontMetrics().averageCharWidth();
    const QRectF place(is_last ? in.right() - width : x - 0.5 * width, in.bottom() + 2, width,
                       line);
    painter.drawText(place, is_last ? Qt::AlignRight : Qt::AlignHCenter, text);
  }
}

/// Draws the band within which changes of the force are not felt. The band is hatched, so that it
/// is visible without colour.
void ProbePlot::draw_band(QPainter& painter, const QRectF& in) const {
  const auto y = [&](double newton) { return in.bottom() - newton / top_n() * in.height(); };
  const QRectF band =
      QRectF(QPointF(in.left(), y(mean_n_ + kFeltN)), QPointF(in.right(), y(mean_n_ - kFeltN)))
          .intersected(in);
  QColor color = palette().color(QPalette::Text);
  color.setAlphaF(0.30F);
  painter.fillRect(band, QBrush(color, Qt::BDiagPattern));
  painter.setPen(QPen(color, 1.0, Qt::DashLine));
  painter.drawLine(band.topLeft(), band.topRight());
  painter.drawLine(band.bottomLeft(), band.bottomRight());
}

void ProbePlot::draw_line(QPainter& painter, const QRectF& in) const {
  const std::vector<double>& drag = figures_.drag_n;
  const auto y = [&](double newton) { return in.bottom() - newton / top_n() * in.height(); };
  QPolygonF line;
  for (std::size_t i = 0; i < drag.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(drag.size() - 1);
    line << QPointF(in.left() + share * in.width(), y(std::min(drag[i], top_n())));
  }
  const QColor color = accent_on(palette().color(QPalette::Base));
  // Fills the parts outside of the band, down to its edge.
  for (const bool above : {true, false}) {
    const double edge = y(mean_n_ + (above ? kFeltN : -kFeltN));
    QPainterPath path(QPointF(in.left(), edge));
    for (const QPointF& point : line) {
      path.lineTo(point.x(), above ? std::min(point.y(), edge) : std::max(point.y(), edge));
    }
    path.lineTo(in.right(), edge);
    QColor fill = color;
    fill.setAlphaF(0.45F);
    painter.fillPath(path, fill);
  }
  painter.setPen(QPen(color, 1.4));
  painter.drawPolyline(line);
}

void ProbePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF in = axes();
  painter.fillRect(in, palette().color(QPalette::Base));
  draw_axes(painter, in);
  if (figures_.drag_n.size() < 2) return;
  painter.setClipRect(in.adjusted(0, -1, 0, 1));
  draw_band(painter, in);
  draw_line(painter, in);
}

}  // namespace felt::desktop
