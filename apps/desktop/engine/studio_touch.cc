// What the studio does while the pen feels bodies instead of the page.
#include <utility>

#include "desktop/engine/studio.h"
#include "felt/haptics/bricks/solid_surface.h"
#include "felt/material/relief.h"
#include "felt/tools/feel_id.h"

namespace felt::desktop {

void Studio::publish() {
  if (!bodies_) return loop_.publish(session_->force());
  const SurfaceMaterial& surface = session_->surface();
  const Medium& tip = *find_medium("pencil");
  ForceModel model(make_solid_surface(*bodies_, surface, tip, session_->device(), bodies_number_,
                                      surface_grain(surface)));
  model.set_fade_id(
      FeelId("bodies").with(std::uint64_t{bodies_number_}).with_surface(surface, tip).value());
  loop_.publish(model, bodies_);
}

void Studio::touch(std::shared_ptr<const TriangleTree> bodies) {
  loop_.wake();
  if (!bodies_ && bodies) finish_gesture();
  is_held_from_ink_ = is_held_from_ink_ || (bodies_ && in_contact(pen_.sample));
  bodies_ = std::move(bodies);
  if (bodies_) ++bodies_number_;
  publish();
  report_touching();
}

void Studio::report_touching() {
  if (std::exchange(reported_touching_, is_touching()) != is_touching()) {
    Q_EMIT touching_changed(is_touching());
  }
}

std::optional<Vec3> Studio::proxy() {
  const SolidTouch& touch = loop_.tick().solid;
  if (!bodies_ || !touch.is_outside || touch.number != bodies_number_) return std::nullopt;
  return touch.proxy.place();
}

/// Lifts the pen of a sample while it feels bodies, and until a touch that began meanwhile ends.
void Studio::lift_for_bodies(PenSample& sample) {
  is_held_from_ink_ = is_touching() && in_contact(sample);
  if (is_touching()) lift(sample);
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
