#include "desktop/feel/feel_icons.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/render/grain.h"

namespace felt::desktop {
namespace {

// The colours of paper and ink do not depend on the theme.
constexpr QColor kPaper(0xff, 0xff, 0xff), kInk(0x23, 0x26, 0x2d);
constexpr QColor kStopOnLight(0xc0, 0x32, 0x26), kStopOnDark(0xff, 0x7d, 0x6e);
constexpr double kStopTint = 0.14;

bool is_dark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128;
}

QPixmap blank(QSize size, qreal dpr) {
  QPixmap pixmap(size * dpr);
  pixmap.setDevicePixelRatio(dpr);
  pixmap.fill(Qt::transparent);
  return pixmap;
}

// All icons are drawn in a square of 16 x 16 units.
void draw_check(QPainter& painter) {
  painter.drawEllipse(QRectF(1.5, 1.5, 13, 13));
  painter.drawPolyline(QPolygonF{{4.7, 8.3}, {7.2, 10.9}, {11.4, 5.5}});
}

void draw_off(QPainter& painter) {
  painter.drawEllipse(QRectF(1.5, 1.5, 13, 13));
  painter.drawLine(QPointF(3.7, 12.3), QPointF(12.3, 3.7));
}

void draw_eye(QPainter& painter) {
  QPainterPath lid(QPointF(1.2, 8));
  lid.quadTo(8, 0.6, 14.8, 8);
  lid.quadTo(8, 15.4, 1.2, 8);
  painter.drawPath(lid);
  painter.setBrush(painter.pen().color());
  painter.drawEllipse(QPointF(8, 8), 1.9, 1.9);
}

void draw_dots(QPainter& painter) {
  painter.drawEllipse(QRectF(1.5, 1.5, 13, 13));
  painter.setBrush(painter.pen().color());
  for (const double x : {4.8, 8.0, 11.2}) painter.drawEllipse(QPointF(x, 8), 0.6, 0.6);
}

void draw_mark_in(QPainter& painter) {
  painter.drawLine(QPointF(8, 6.2), QPointF(8, 9.4));
  painter.setBrush(painter.pen().color());
  painter.drawEllipse(QPointF(8, 12), 0.35, 0.35);
}

void draw_triangle(QPainter& painter) {
  painter.drawPolygon(QPolygonF{{8, 1.8}, {15, 14.2}, {1, 14.2}});
  draw_mark_in(painter);
}

void draw_stop(QPainter& painter) {
  painter.setBrush(painter.pen().color());
  painter.drawPolygon(
      QPolygonF{{5, 1}, {11, 1}, {15, 5}, {15, 11}, {11, 15}, {5, 15}, {1, 11}, {1, 5}});
  painter.setPen(Qt::NoPen);
  painter.setCompositionMode(QPainter::CompositionMode_Clear);
  painter.drawRect(QRectF(4, 6.8, 8, 2.4));
}

QPixmap material_swatch(const SurfaceMaterial& material, QSize size, qreal dpr) {
  const Grain grain(surface_grain(material));
  const QSize pixels = size * dpr;
  QImage image(pixels, QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(dpr);
  const double mm = 1.0 / (kScreenPxPerMm * dpr);
  for (int y = 0; y < pixels.height(); ++y) {
    auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
    const double across = std::abs(2.0 * (y + 0.5) / pixels.height() - 1.0);
    for (int x = 0; x < pixels.width(); ++x) {
      const double along = (x + 0.5) / pixels.width();
      // The stroke is wide, with blank paper above and below it, and fades in from the left.
      const double within = std::clamp((0.72 - across) * pixels.height() / 4.0, 0.0, 1.0);
      const double pressure = 0.05 + 0.75 * along;
      const double seen = 0.85 * within * grain.alpha({mm * x, mm * y}, pressure, "pencil") *
                          (grain.is_smooth() ? pressure : 1.0);
      const auto mix = [&](int from, int to) {
        return static_cast<int>(from + seen * (to - from));
      };
      row[x] = qRgb(mix(kPaper.red(), kInk.red()), mix(kPaper.green(), kInk.green()),
                    mix(kPaper.blue(), kInk.blue()));
    }
  }
  return QPixmap::fromImage(image);
}

/// Adds an outline, because white paper on a white button would have no visible edge.
QPixmap outlined(QPixmap swatch) {
  QPainter painter(&swatch);
  painter.setPen(QPen(QColor(0, 0, 0, 70), 1.0));
  painter.drawRect(QRectF(QPointF(0, 0), swatch.deviceIndependentSize()).adjusted(0, 0, -1, -1));
  return swatch;
}

/// Adds the frame that shows that a swatch is chosen.
QPixmap framed(QPixmap swatch, const QPalette& palette) {
  QPainter painter(&swatch);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor color = palette.color(QPalette::Highlight);
  const QRectF all(QPointF(0, 0), swatch.deviceIndependentSize());
  painter.setPen(QPen(color, 4, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawRect(all.adjusted(1, 1, -1, -1));
  const QPointF middle = all.bottomRight() - QPointF(9, 9);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawEllipse(middle, 8, 8);
  painter.setPen(QPen(palette.color(QPalette::HighlightedText), 1.8, Qt::SolidLine, Qt::RoundCap));
  painter.drawPolyline(QPolygonF{middle + QPointF(-3.6, 0.4), middle + QPointF(-0.9, 3.2),
                                 middle + QPointF(3.8, -3.0)});
  return swatch;
}

}  // namespace

QPixmap level_icon(FeelLevel level, const QPalette& palette, int size, qreal dpr) {
  QPixmap pixmap = blank({size, size}, dpr);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(size / 16.0, size / 16.0);
  painter.setPen(
      QPen(palette.color(QPalette::WindowText), 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  switch (level) {
    case FeelLevel::kShown:
      draw_eye(painter);
      break;
    case FeelLevel::kOff:
      draw_off(painter);
      break;
    case FeelLevel::kWaiting:
      draw_dots(painter);
      break;
    case FeelLevel::kOn:
      draw_check(painter);
      break;
    case FeelLevel::kLimited:
      draw_triangle(painter);
      break;
    case FeelLevel::kStopped:
      draw_stop(painter);
      break;
  }
  return pixmap;
}

QPixmap ring_icon(bool asks, const QPalette& palette, int size, qreal dpr) {
  QPixmap pixmap = blank({size, size}, dpr);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(size / 16.0, size / 16.0);
  const QColor color = palette.color(QPalette::WindowText);
  painter.setPen(QPen(color, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawEllipse(QRectF(1.5, 1.5, 13, 13));
  if (asks) {
    QPainterPath hook(QPointF(5.9, 6.3));
    hook.cubicTo(5.9, 3.6, 10.1, 3.6, 10.1, 6.3);
    hook.cubicTo(10.1, 8.0, 8.0, 7.9, 8.0, 9.7);
    painter.drawPath(hook);
  }
  painter.setBrush(color);
  const double radius = asks ? 0.35 : 2.2;
  painter.drawEllipse(QPointF(8, asks ? 12.0 : 8.0), radius, radius);
  return pixmap;
}

QIcon stop_icon(const QPalette& palette, int size, qreal dpr) {
  QPalette red = palette;
  red.setColor(QPalette::WindowText, is_dark(palette) ? kStopOnDark : kStopOnLight);
  return QIcon(level_icon(FeelLevel::kStopped, red, size, dpr));
}

QPalette stop_palette(QPalette palette) {
  const QColor red = is_dark(palette) ? kStopOnDark : kStopOnLight;
  const QColor from = palette.color(QPalette::Button);
  const auto mix = [](int a, int b) { return static_cast<int>(a + kStopTint * (b - a)); };
  palette.setColor(QPalette::Button,
                   QColor(mix(from.red(), red.red()), mix(from.green(), red.green()),
                          mix(from.blue(), red.blue())));
  return palette;
}

QIcon swatch_icon(const QPixmap& swatch, const QPalette& palette) {
  const QPixmap plain = outlined(swatch);
  QIcon icon(plain);
  icon.addPixmap(framed(plain, palette), QIcon::Normal, QIcon::On);
  return icon;
}

QIcon material_icon(const SurfaceMaterial& material, const QPalette& palette, QSize size,
                    qreal dpr) {
  return swatch_icon(material_swatch(material, size, dpr), palette);
}

}  // namespace felt::desktop
