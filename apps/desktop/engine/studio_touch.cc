// What the studio does while the pen feels bodies instead of the page.
#include <utility>

#include "desktop/engine/studio.h"
#include "felt/haptics/bricks/solid_surface.h"
#include "felt/material/relief.h"
#include "felt/tools/feel_id.h"

namespace felt::desktop {

void Studio::publish() {
  if (!bodies_ && !is_below_page_) return loop_.publish(session_->force());
  ForceModel model;
  if (!bodies_) {
    // The page would push a pen that is far below it out with all its force.
    model.set_fade_id(FeelId("below the page").value());
    return loop_.publish(model);
  }
  const SurfaceMaterial& surface = session_->surface();
  const Medium& tip = *find_medium("pencil");
  model = ForceModel(make_solid_surface(*bodies_, surface, tip, session_->device(), bodies_number_,
                                        surface_grain(surface)));
  model.set_fade_id(
      FeelId("bodies").with(std::uint64_t{bodies_number_}).with_surface(surface, tip).value());
  loop_.publish(model, bodies_);
}

void Studio::touch(std::shared_ptr<const TriangleTree> bodies) {
  loop_.wake();
  if (!bodies_ && bodies) finish_gesture();
  drain();  // before it is asked where the pen is
  is_held_from_ink_ = is_pen_elsewhere() && in_contact(pen_.sample);
  is_below_page_ = bodies_ && !bodies && in_contact(pen_.sample);
  bodies_ = std::move(bodies);
  if (bodies_) ++bodies_number_;
  publish();
  report_elsewhere();
}

void Studio::report_elsewhere() {
  if (std::exchange(reported_elsewhere_, is_pen_elsewhere()) != is_pen_elsewhere()) {
    Q_EMIT elsewhere_changed(is_pen_elsewhere());
  }
}

std::optional<Vec3> Studio::proxy() {
  const SolidTouch& touch = loop_.tick().solid;
  if (!bodies_ || !touch.is_outside || touch.number != bodies_number_) return std::nullopt;
  return touch.proxy.place();
}

/// Returns the height of the bodies above a position of the page; 0 beside them, or without bodies.
double Studio::height_of_bodies_mm(Point at) const {
  if (!bodies_ || !is_finite(at)) return 0.0;
  const double top = bodies_->high().z + 1.0;
  if (top <= 0.0) return 0.0;
  const std::optional<SweepHit> hit = bodies_->sweep({at.x, at.y, top}, {at.x, at.y, 0.0});
  return hit ? top * (1.0 - hit->t) : 0.0;
}

}  // namespace felt::desktop
