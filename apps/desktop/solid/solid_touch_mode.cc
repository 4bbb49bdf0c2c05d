#include "desktop/solid/solid_touch_mode.h"

#include <algorithm>
#include <utility>

#include "felt/geometry/triangle_tree.h"
#include "felt/solid/solid.h"

namespace felt::desktop {

SolidTouchMode::SolidTouchMode(Studio& studio, SolidPanel& panel, Actions& actions, QObject* parent)
    : QObject(parent),
      studio_(studio),
      panel_(panel),
      action_(actions.add_switch(
          QStringLiteral("feel.touch_solid"), tr("&Touch the solid"),
          {QKeySequence(Qt::SHIFT | Qt::Key_F9)},
          tr("The pen feels the bodies of the solid view, and draws nothing meanwhile"), false,
          [this](bool on) { set_on(on); })) {
  panel_.set_touch_action(action_);
  connect(&panel_, &SolidPanel::solid_changed, this, &SolidTouchMode::follow_bodies);
  // A tool that is only borrowed, as by the right button, leaves the pen on the bodies.
  connect(&studio_, &Studio::tool_changed, this, [this] {
    if (!studio_.is_borrowing() && tool() != tool_) set_on(false);
  });
  connect(&studio_.loop(), &HapticLoop::device_changed, this, &SolidTouchMode::follow_device);
  connect(&studio_, &Studio::opened, this, [this] { set_on(false); });
  connect(&studio_, &Studio::shown, this, &SolidTouchMode::show_pen);
  follow_bodies();
}

void SolidTouchMode::set_on(bool on) {
  if (on && !is_on_) {
    const QString why = why_not();
    if (!why.isEmpty()) Q_EMIT studio_.refused(why);
    on = why.isEmpty();
  }
  if (std::exchange(is_on_, on) != on) {
    if (on) {
      tool_ = tool();
      borrow_device();
      touch_bodies();
    } else {
      studio_.touch(nullptr);
      panel_.show_proxy(std::nullopt);
      give_back_device();
    }
  }
  action_->setChecked(on);
}

QString SolidTouchMode::tool() const {
  return QString::fromLatin1(studio_.session().tool().info().id);
}

/// Returns a sentence if the pen cannot touch bodies, or an empty one.
QString SolidTouchMode::why_not() const {
  if (!panel_.solid()) {
    return tr("To touch a body, open the solid view and draw a closed line.");
  }
  const Capabilities& device = studio_.session().device();
  if (device.has_force() && device.actuated_axes < 3) {
    return tr("This device cannot push in three directions, so it cannot let you touch a body.");
  }
  return {};
}

/// The user has chosen another device, or it is gone.
void SolidTouchMode::follow_device() {
  if (!is_on_ || is_borrowing_device_) return;
  if (!studio_.session().device().has_force() || !why_not().isEmpty()) return set_on(false);
  touch_bodies();
}

/// Puts the bodies in front of the device, lowered if their top were out of its reach.
void SolidTouchMode::touch_bodies() {
  double top_mm = 0.0;
  for (const SolidBody& body : panel_.solid()->bodies) {
    for (const Vec3& point : body.points) top_mm = std::max(top_mm, point.z);
  }
  const double reach_mm = studio_.session().device().workspace_max.z - kRoomMm;
  lowered_mm_ = std::max(0.0, top_mm - reach_mm);
  studio_.touch(std::make_shared<const TriangleTree>(page_triangles(*panel_.solid(), lowered_mm_)));
}

void SolidTouchMode::follow_bodies() {
  const bool has_body = panel_.solid() != nullptr;
  const QString why = why_not();
  action_->setToolTip(why.isEmpty() ? tr("The pen feels the bodies of the solid view, and draws "
                                         "nothing meanwhile")
                                    : why);
  if (!has_body) {
    set_on(false);
  } else if (is_on_) {
    touch_bodies();
  }
}

void SolidTouchMode::borrow_device() {
  home_device_.clear();
  if (studio_.session().device().has_force()) return;
  const QString home = studio_.loop().device().info().id;
  is_borrowing_device_ = true;
  if (studio_.use_device(QString::fromLatin1(kTouchStylus))) home_device_ = home;
  is_borrowing_device_ = false;
}

/// The user may have chosen another device meanwhile, which stays.
void SolidTouchMode::give_back_device() {
  const QString home = std::exchange(home_device_, {});
  const bool is_borrowed =
      studio_.loop().device().info().id == QLatin1String(kTouchStylus) && !home.isEmpty();
  if (is_borrowed) studio_.use_device(home);
}

void SolidTouchMode::show_pen() {
  if (!is_on_ || !panel_.solid() || !studio_.pen().is_known) return;
  const Point origin = panel_.solid()->origin;
  const auto on_solid = [&](const Vec3& p) {
    return Vec3{p.x - origin.x, origin.y - p.y, p.z + lowered_mm_};
  };
  const PenState& pen = studio_.pen();
  const Vec3 at = pen.sample.position;
  const std::optional<Vec3> proxy = studio_.proxy();
  const Force& force = pen.sent;
  panel_.show_proxy(SolidTouchMarks{.pen_mm = on_solid(at),
                                    .proxy_mm = on_solid(proxy.value_or(at)),
                                    .force_n = {force.x, -force.y, force.z}});
}

}  // namespace felt::desktop
