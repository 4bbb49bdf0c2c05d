#pragma once

#include <QBackingStore>
#include <QCoreApplication>
#include <QImage>
#include <QPixmap>
#include <optional>
#include <string>
#include <vector>

#include "desktop/canvas/canvas.h"

namespace felt::desktop {

/// A fixture that draws on a canvas, for tests and pictures. Its functions move the hand, and each
/// move also advances the studio's clock.
class Fixture {
 public:
  explicit Fixture(QSize size = {640, 480}, const QString& device = QStringLiteral("tablet"))
      : studio({.device = device, .live = false, .first_options = false}), canvas(studio) {
    canvas.resize(size);
    canvas.show();
    canvas.set_pen_visible(true);
    settle();
  }

  void tool(const std::string& id) { studio.apply(SelectTool{id}); }
  void option(const std::string& id, OptionValue value) {
    studio.apply(SetOption{id, std::move(value)});
  }
  /// Sends one event of the pointer, 8 ms after the last one.
  void move(Point to, bool down, std::optional<double> pressure = {}, std::uint32_t buttons = 0) {
    studio.point({studio.now_ns(), to, down, pressure, buttons});
    studio.advance(8'000'000);
    at = to;
  }
  /// Moves the pointer to `to` in a straight line, 2 mm per event.
  void go(Point to, bool down, std::optional<double> pressure = {}, std::uint32_t buttons = 0) {
    const Point from = at;
    const double steps = std::max(1.0, std::ceil(distance(from, to) / 2.0));
    for (double i = 1; i <= steps; ++i) move(lerp(from, to, i / steps), down, pressure, buttons);
  }
  void touch(std::optional<double> pressure = {}, std::uint32_t buttons = 0) {
    move(at, true, pressure, buttons);
  }
  void lift() {
    for (int i = 0; i < 6; ++i) move(at, false);
  }
  /// Draws a line through these points.
  void draw(const std::vector<Point>& way, std::optional<double> pressure = {}) {
    go(way.front(), false);
    touch(pressure);
    for (const Point& p : way) go(p, true, pressure);
    lift();
  }

  /// Waits until everything that was requested is painted.
  void settle() {
    canvas.ink().finish();
    for (int i = 0; i < 3; ++i) QCoreApplication::processEvents();
  }
  /// Returns the pixels that the window shows now, after its partial repaints.
  QImage seen() {
    settle();
    const auto* window = dynamic_cast<QImage*>(canvas.backingStore()->paintDevice());
    const QSize size = canvas.grab().toImage().size();
    return window ? window->copy(QRect(QPoint(0, 0), size)).convertToFormat(QImage::Format_RGB32)
                  : QImage();
  }
  /// Returns the pixels that the window shows after a full repaint.
  QImage anew() {
    settle();
    return canvas.grab().toImage().convertToFormat(QImage::Format_RGB32);
  }

  Studio studio;
  Canvas canvas;
  Point at{20, 20};
};

}  // namespace felt::desktop
