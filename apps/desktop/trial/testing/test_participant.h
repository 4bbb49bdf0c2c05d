#pragma once

#include <QApplication>
#include <QKeyEvent>
#include <QTabletEvent>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>

#include "desktop/trial/trial_window.h"

namespace felt::desktop {

/// A participant with a tablet pen, for tests: draws in a TrialWindow and answers questions. `wait`
/// lets the time of the studio pass, in ms.
class TestParticipant {
 public:
  TestParticipant(TrialWindow& window, std::function<void(int)> wait)
      : window_(window), wait_(std::move(wait)) {}

  void press(int key, bool repeats = false) {
    QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier, QString(), repeats);
    QWidget* focus = window_.focusWidget();
    QApplication::sendEvent(focus && focus->isVisible() ? focus : &window_, &event);
  }

  void pen(QEvent::Type type, Point mm, bool down) {
    static const auto* device =
        new QPointingDevice(QStringLiteral("test pen"), 21, QInputDevice::DeviceType::Stylus,
                            QPointingDevice::PointerType::Pen,
                            QInputDevice::Capability::Position | QInputDevice::Capability::Pressure,
                            1, 3, {}, QPointingDeviceUniqueId::fromNumericId(2), qApp);
    Canvas& canvas = window_.trial_screen().canvas();
    const QPointF at = canvas.view().to_px(mm);
    const bool changes = type != QEvent::TabletMove;
    QTabletEvent event(type, device, at, canvas.mapToGlobal(at), down ? 0.5 : 0.0, 0, 0, 0, 0, 0,
                       Qt::NoModifier, changes ? Qt::LeftButton : Qt::NoButton,
                       down ? Qt::LeftButton : Qt::NoButton);
    event.setTimestamp(1000 + static_cast<quint64>(canvas.studio().now_ns() / 1'000'000));
    QApplication::sendEvent(&canvas, &event);
    wait_(5);
  }

  /// Draws the first `share` of a path, at about 100 mm/s.
  void draw(const StudyPath& path, double share = 1.0) {
    std::vector<Point> corners = path.points;
    if (path.ends == TrialPathEnds::kClosed) corners.push_back(corners.front());
    std::vector<Point> line{corners.front()};
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const Point from = line.back();
      const double parts = std::floor(distance(from, corners[i]) / 0.5);
      for (double part = 1; part <= parts; ++part) {
        line.push_back(lerp(from, corners[i], part / parts));
      }
    }
    line.resize(std::max<std::size_t>(1, std::size_t(share * double(line.size()))), Point{});
    dwell(line.front(), false);
    pen(QEvent::TabletPress, line.front(), true);
    dwell(line.front(), true);
    for (const Point& point : line) pen(QEvent::TabletMove, point, true);
    dwell(line.back(), true);
    pen(QEvent::TabletRelease, line.back(), false);
    dwell(line.back(), false);
  }

  /// Chooses the mark `mark` of each scale.
  void answer(int mark) {
    for (auto* scale : window_.question_screen().findChildren<AnswerScale*>()) scale->choose(mark);
  }

 private:
  void dwell(Point at, bool down) {
    for (int i = 0; i < 20; ++i) pen(QEvent::TabletMove, at, down);
  }

  TrialWindow& window_;
  std::function<void(int)> wait_;
};

}  // namespace felt::desktop
