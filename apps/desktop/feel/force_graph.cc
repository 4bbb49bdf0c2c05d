#include "desktop/feel/force_graph.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "felt/render/plot.h"

namespace felt::desktop {
namespace {

constexpr std::array<double, 6> kTops{0.5, 1.0, 2.0, 3.0, 5.0, 10.0};  // N
constexpr std::int64_t kBinsToMark = 50;
constexpr std::int64_t kBinsToBridge = 20;  // a line bridges gaps of up to kBinsToBridge bins
                                            // without a tick
constexpr double kMinContrast = 3.0;        // WCAG 2.1 for graphics

/// Returns red, green and blue, each 0..1.
std::array<double, 3> channels(const QColor& color) {
  return {static_cast<double>(color.redF()), static_cast<double>(color.greenF()),
          static_cast<double>(color.blueF())};
}

double luminance(const QColor& color) {
  const auto linear = [](double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const auto [red, green, blue] = channels(color);
  return 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue);
}

double contrast(const QColor& a, const QColor& b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

/// Returns `color` with the same hue, moved towards black or white until it is visible on
/// `ground`.
QColor seen_on(const QColor& ground, QColor color) {
  const double towards = luminance(ground) < 0.2 ? 1.0 : 0.0;
  for (int i = 0; i < 20 && contrast(color, ground) < kMinContrast; ++i) {
    const auto mixed = [&](double c) { return static_cast<float>(c + 0.1 * (towards - c)); };
    const auto [red, green, blue] = channels(color);
    color = QColor::fromRgbF(mixed(red), mixed(green), mixed(blue));
  }
  return color;
}

}  // namespace

TrackStyle track_style(std::size_t track, const QPalette& palette) {
  if (track == ForceHistory::kSent) return {palette.color(QPalette::Text), 0, 1.6};
  if (track == ForceHistory::kAsked) {
    QColor pale = palette.color(QPalette::Text);
    pale.setAlphaF(0.3F);
    return {pale, 0, 4.0};
  }
  const Rgba c = plot_color(track - 2);
  return {seen_on(palette.color(QPalette::Base), QColor(c.r, c.g, c.b)),
          static_cast<int>(track - 1), 1.2};
}

void draw_mark(QPainter& painter, int mark, QPointF at, qreal r) {
  const QPointF right(r, 0), down(0, r);
  switch (mark <= 0 ? 0 : 1 + (mark - 1) % 6) {
    case 1:
      painter.drawEllipse(at, r, r);
      break;
    case 2:
      painter.drawRect(QRectF(at - right - down, at + right + down));
      break;
    case 3:
      painter.drawPolygon(QPolygonF{at - down, at + right + down, at - right + down});
      break;
    case 4:
      painter.drawPolygon(QPolygonF{at - down, at + right, at + down, at - right});
      break;
    case 5:
      painter.drawPolygon(QPolygonF{at + down, at + right - down, at - right - down});
      break;
    case 6:
      painter.drawRect(QRectF(at - right - 0.4 * down, at + right + 0.4 * down));
      break;
    default:
      break;
  }
}

ForceGraph::ForceGraph(const ForceHistory& history, QWidget* parent)
    : QWidget(parent), history_(&history) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("Plot of the forces of the last seconds"));
}

void ForceGraph::show_history(const ForceHistory& history) {
  history_ = &history;
  forget();
  update();
}

void ForceGraph::set_bounds(std::vector<ForceBound> bounds) {
  bounds_ = std::move(bounds);
  forget();
  update();
}

void ForceGraph::set_shows_sent(bool shown) {
  shows_sent_ = shown;
  forget();
  update();
}

QSize ForceGraph::sizeHint() const {
  return {30 * fontMetrics().averageCharWidth() + 200, 8 * fontMetrics().height()};
}

QSize ForceGraph::minimumSizeHint() const {
  return {20 * fontMetrics().averageCharWidth(), 5 * fontMetrics().height()};
}

QRectF ForceGraph::axes() const {
  const QFontMetricsF metrics(font());
  const qreal left = metrics.horizontalAdvance(QStringLiteral("0.375 N")) + 6;
  return QRectF(rect()).adjusted(left, 0.6 * metrics.height(), -6, -1.3 * metrics.height());
}

double ForceGraph::wanted_top() const {
  float largest = 0.0F;
  for (std::size_t track = 0; track < history_->tracks(); ++track) {
    largest = std::max(largest, history_->largest(track));
  }
  for (const double top : kTops) {
    if (static_cast<double>(largest) <= 0.95 * top) return top;
  }
  return 1.25 * static_cast<double>(largest);
}

void ForceGraph::paintEvent(QPaintEvent* event) {
  static_cast<void>(event);
  const QRectF in = axes();
  if (in.width() < 20 || in.height() < 20) return;
  const double top = wanted_top();
  const QSize pixels = size() * devicePixelRatioF();
  if (ground_.isNull() || top != top_n_ || ground_.size() != pixels) {
    top_n_ = top;
    draw_ground(in);
    lines_ = {};
  }
  bring_lines_up(in.size());
  QPainter painter(this);
  painter.drawPixmap(QPointF(0, 0), ground_);
  painter.drawPixmap(in.topLeft(), lines_);
}

void ForceGraph::changeEvent(QEvent* event) {
  forget();
  QWidget::changeEvent(event);
}

QPixmap ForceGraph::blank(QSizeF size) const {
  const qreal dpr = devicePixelRatioF();
  QPixmap pixmap((size * dpr).toSize());
  pixmap.setDevicePixelRatio(dpr);
  pixmap.fill(Qt::transparent);
  return pixmap;
}

void ForceGraph::draw_ground(const QRectF& in) {
  ground_ = blank(size());
  QPainter painter(&ground_);
  painter.setFont(font());
  painter.fillRect(in, palette().color(QPalette::Base));
  draw_grid(painter, in);
  draw_bounds(painter, in);
}

void ForceGraph::draw_grid(QPainter& painter, const QRectF& in) const {
  QColor grid = palette().color(QPalette::Text);
  grid.setAlphaF(0.18F);
  const QFontMetricsF metrics(font());
  const int parts = in.height() > 7 * metrics.height() ? 4 : 2;
  for (int i = 0; i <= parts; ++i) {
    const double newton = top_n_ * i / parts;
    const qreal y = in.bottom() - in.height() * i / parts;
    painter.setPen(QPen(grid, 1));
    painter.drawLine(QPointF(in.left(), y), QPointF(in.right(), y));
    painter.setPen(palette().color(QPalette::WindowText));
    const QString text = tr("%L1 N").arg(newton, 0, 'g', 3);
    painter.drawText(QRectF(0, y - metrics.height() / 2, in.left() - 4, metrics.height()),
                     Qt::AlignRight | Qt::AlignVCenter, text);
  }
  constexpr int kSeconds =
      static_cast<int>(ForceHistory::kBins * ForceHistory::kBinNs / 1'000'000'000);
  for (int s = 0; s <= kSeconds; ++s) {
    const qreal x = in.left() + in.width() * s / kSeconds;
    painter.setPen(QPen(grid, 1));
    painter.drawLine(QPointF(x, in.top()), QPointF(x, in.bottom()));
    painter.setPen(palette().color(QPalette::WindowText));
    const QString text = s == kSeconds ? tr("now") : tr("%1 s").arg(s - kSeconds);
    const qreal wide = metrics.horizontalAdvance(text) + 2;
    const qreal from = std::min(x - wide / 2, in.right() - wide);
    painter.drawText(QRectF(from, in.bottom() + 2, wide, metrics.height()), Qt::AlignCenter, text);
  }
}

void ForceGraph::draw_bounds(QPainter& painter, const QRectF& in) const {
  const QFontMetricsF metrics(font());
  for (const ForceBound& bound : bounds_) {
    if (!(bound.newton > 0.0 && bound.newton <= top_n_)) continue;
    const qreal y = in.bottom() - in.height() * bound.newton / top_n_;
    painter.setPen(QPen(palette().color(QPalette::Text), 1, Qt::DashLine));
    painter.drawLine(QPointF(in.left(), y), QPointF(in.right(), y));
    const qreal wide = metrics.horizontalAdvance(bound.label) + 6;
    const bool below = y - metrics.height() < in.top();
    const QRectF place(in.left() + 4, below ? y + 1 : y - metrics.height() - 1, wide,
                       metrics.height());
    painter.fillRect(place, palette().color(QPalette::Base));
    painter.drawText(place, Qt::AlignCenter, bound.label);
  }
}

std::int64_t ForceGraph::column_of(std::int64_t bin) const {
  return (bin + 1) * lines_.width() / std::int64_t{ForceHistory::kBins};
}

/// Draws the lines up to the newest complete bin. Bins that may still grow are left out, which
/// delays the plot by about 10 ms.
void ForceGraph::bring_lines_up(QSizeF size) {
  const std::int64_t to = history_->newest() - 1;
  const bool anew = lines_.isNull() || to < drawn_to_ ||
                    to - drawn_to_ >= std::int64_t{ForceHistory::kBins} || drawn_to_ < 0;
  if (anew) {
    lines_ = blank(size);
    draw_lines(to - std::int64_t{ForceHistory::kBins}, to);
  } else if (to > drawn_to_) {
    const auto moved = static_cast<int>(column_of(to) - column_of(drawn_to_));
    lines_.scroll(-moved, 0, QRect(QPoint(0, 0), lines_.size()));
    draw_lines(drawn_to_, to);
  }
  drawn_to_ = to;
}

/// Draws the bins after `from`, up to and including `to`, at the right end of the picture.
void ForceGraph::draw_lines(std::int64_t from, std::int64_t to) {
  const qreal dpr = lines_.devicePixelRatio();
  const qreal width = lines_.width() / dpr, height = lines_.height() / dpr;
  const qreal strip = static_cast<qreal>(column_of(to) - column_of(from)) / dpr;
  QPainter painter(&lines_);
  const QRectF fresh(width - strip, 0, strip, height);
  painter.setCompositionMode(QPainter::CompositionMode_Source);
  painter.fillRect(fresh, Qt::transparent);
  painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
  painter.setRenderHint(QPainter::Antialiasing);
  draw_track(painter, ForceHistory::kAsked, from, to);
  for (std::size_t track = 2; track < history_->tracks(); ++track) {
    draw_track(painter, track, from, to);
  }
  if (shows_sent_) draw_track(painter, ForceHistory::kSent, from, to);
}

void ForceGraph::draw_track(QPainter& painter, std::size_t track, std::int64_t from,
                            std::int64_t to) const {
  const TrackStyle style = track_style(track, palette());
  const qreal dpr = lines_.devicePixelRatio();
  const qreal height = lines_.height() / dpr, right = lines_.width() / dpr;
  // Each line starts at its last point before these bins, so that it continues the line that was
  // drawn before.
  std::int64_t first = from;
  while (first > from - kBinsToBridge && history_->at(track, first) < 0.0F) --first;
  std::array<QPointF, ForceHistory::kBins + kBinsToBridge + 1> line;
  std::array<QPointF, ForceHistory::kBins / kBinsToMark + 2> marks;
  std::size_t points = 0, marked = 0;
  for (std::int64_t bin = first; bin <= to; ++bin) {
    const float value = history_->at(track, bin);
    if (value < 0.0F) continue;
    const QPointF at(right - static_cast<qreal>(column_of(to) - column_of(bin)) / dpr,
                     height * (1.0 - static_cast<double>(value) / top_n_));
    // The marks of different tracks are at different bins. A mark is drawn slightly to the left of
    // its bin, so that it is not cut off at the right end.
    const std::int64_t turn = bin + 13 * static_cast<std::int64_t>(track);
    if (bin > from && turn % kBinsToMark == 0 && value > 0.0F) marks[marked++] = at;
    line[points++] = at;
  }
  painter.setPen(QPen(style.color, style.width, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolyline(line.data(), static_cast<int>(points));
  painter.setBrush(style.color);
  for (std::size_t i = 0; i < marked; ++i) {
    draw_mark(painter, style.mark, marks[i] - QPointF(3.0, 0.0), 3.0);
  }
}

}  // namespace felt::desktop
