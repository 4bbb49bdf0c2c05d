#include "desktop/pens/tablet_input.h"

#include <QPointingDevice>
#include <utility>

#include "desktop/engine/tablet_event_tilt.h"

namespace felt::desktop {
namespace {

constexpr std::array kSideButtons = {Qt::RightButton, Qt::MiddleButton};
constexpr double kFixedPressure = 0.5;  // used if pressure is switched off

bool senses_pressure(const QTabletEvent& event) {
  const QPointingDevice* device = event.pointingDevice();
  return !device || device->hasCapability(QInputDevice::Capability::Pressure);
}

}  // namespace

TabletInput::TabletInput(Canvas& canvas, PenHand& hand, ViewDrag& drag, const PenSettings& settings)
    : hand_(hand), drag_(drag), studio_(canvas.studio()), settings_(settings), held_roles_{} {}

bool TabletInput::is_near() const {
  return last_ns_ && studio_.now_ns() - *last_ns_ < kPalmNs;
}

void TabletInput::take(const QTabletEvent& event) {
  if (!is_near()) Q_EMIT came();
  last_ns_ = studio_.now_ns();
  const std::int64_t time_ns = clock_.time_ns(event.timestamp(), studio_.now_ns());
  const QPointF px = event.position();
  use_end(event.pointerType() == QPointingDevice::PointerType::Eraser);
  use_buttons(event.type() == QEvent::TabletRelease && event.button() == Qt::LeftButton
                  ? event.buttons() & ~Qt::MouseButtons(Qt::LeftButton)
                  : event.buttons(),
              px);
  const double raw = event.pressure();
  const bool tip = event.type() != QEvent::TabletRelease || event.button() != Qt::LeftButton
                       ? event.buttons().testFlag(Qt::LeftButton)
                       : false;
  if (tip && drag_.offered() && !drag_.is_on() && !hand_.is_down()) {
    drags_ = true;
    drag_.begin(*drag_.offered(), px);
  }
  if (drag_.is_on() && drags_) {
    drag_.move(px);
    const bool by_button = (held_[0] && held_roles_[0] == ButtonRole::kPan) ||
                           (held_[1] && held_roles_[1] == ButtonRole::kPan);
    if (!tip && !by_button) {
      drags_ = false;
      drag_.end();
    }
    return;
  }
  if (!tip || event.type() == QEvent::TabletPress) ignores_ = false;
  const bool senses = senses_pressure(event);
  const bool touching = tip && !ignores_ && (!senses || settings_.curve.touches(raw));
  note_pressure(event, touching);
  std::optional<double> pressure;
  if (!settings_.pressure_on) pressure = kFixedPressure;
  if (settings_.pressure_on && senses) pressure = settings_.curve(raw);
  hand_.point(PenHand::Source::kTablet, px, time_ns, touching, pressure, tilt_of(event));
}

void TabletInput::note_pressure(const QTabletEvent& event, bool touching) {
  const double raw = event.pressure();
  Q_EMIT pressed(touching ? raw : 0.0);
  // A pen that does not sense pressure usually reports 0 or 1.
  Pressure seen = pressure_seen_;
  if (!senses_pressure(event)) {
    seen = Pressure::kNone;
  } else if (raw > 0.0 && raw < 1.0) {
    seen = Pressure::kSeen;
  }
  if (std::exchange(pressure_seen_, seen) != seen) Q_EMIT pressure_seen_changed();
}

void TabletInput::use_end(bool is_eraser) {
  if (std::exchange(erasing_, is_eraser) == is_eraser) return;
  hand_.lift();  // the pen's other end must not continue the line
  if (is_eraser) {
    hand_.press(ButtonRole::kEraser);
  } else {
    hand_.release(ButtonRole::kEraser);
  }
}

void TabletInput::use_buttons(Qt::MouseButtons now, QPointF px) {
  for (std::size_t i = 0; i < kSideButtons.size(); ++i) {
    const bool down = now.testFlag(kSideButtons[i]);
    if (down != held_[i]) use_button(i, down, px);
  }
}

void TabletInput::use_button(std::size_t which, bool down, QPointF px) {
  held_[which] = down;
  // A press and its release use the same role, even if the setting changes meanwhile.
  if (down) held_roles_[which] = which == 0 ? settings_.lower : settings_.upper;
  const ButtonRole role = held_roles_[which];
  if (role != ButtonRole::kPan) return down ? hand_.press(role) : hand_.release(role);
  if (down && !hand_.is_down() && !drag_.is_on()) {
    drags_ = true;
    drag_.begin(ViewDrag::Kind::kPan, px);
  }
}

void TabletInput::cancel() {
  if (!hand_.is_down(PenHand::Source::kTablet)) return;
  ignores_ = true;
  hand_.cancel();
}

void TabletInput::leave() {
  if (hand_.is_down(PenHand::Source::kTablet)) hand_.lift();
  use_end(false);
  release_all();
}

void TabletInput::release_all() {
  use_buttons(Qt::NoButton, {});
  if (std::exchange(drags_, false)) drag_.end();
}

}  // namespace felt::desktop
