#include "tests/desktop/injected_pen.h"

#include <qpa/qwindowsysteminterface.h>
#include <QApplication>
#include <QPointingDevice>
#include <chrono>

namespace felt::desktop {
namespace {

std::unique_ptr<QPointingDevice> make_pen(QPointingDevice::PointerType type, qint64 id) {
  using Can = QInputDevice::Capability;
  auto pen = std::make_unique<QPointingDevice>(
      QStringLiteral("injected pen"), id, QInputDevice::DeviceType::Stylus, type,
      Can::Position | Can::Pressure | Can::Hover, 1, 3, QString(),
      QPointingDeviceUniqueId::fromNumericId(4711));
  QWindowSystemInterface::registerInputDevice(pen.get());
  return pen;
}

ulong stamp_ms() {
  using namespace std::chrono;
  return static_cast<ulong>(
      duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count());
}

}  // namespace

InjectedPen::InjectedPen(Canvas& canvas)
    : window_(canvas.window()->windowHandle()),
      origin_(canvas.mapTo(canvas.window(), QPointF(0, 0))),
      window_origin_(window_->mapToGlobal(QPointF(0, 0))),
      tip_(make_pen(QPointingDevice::PointerType::Pen, 101)),
      eraser_(make_pen(QPointingDevice::PointerType::Eraser, 102)) {}

InjectedPen::~InjectedPen() = default;

void InjectedPen::turn_over(bool eraser) {
  is_turned_ = eraser;
}

void InjectedPen::point(QPointF px, double pressure, Qt::MouseButtons side) {
  const QPointF local = origin_ + px;
  const Qt::MouseButtons buttons = side | (pressure > 0.0 ? Qt::LeftButton : Qt::NoButton);
  const QPointingDevice* device = is_turned_ ? eraser_.get() : tip_.get();
  QWindowSystemInterface::handleTabletEvent(window_, stamp_ms(), device, local,
                                            window_origin_ + local, buttons, pressure, 0, 0, 0.0,
                                            0.0, 0);
}

}  // namespace felt::desktop
