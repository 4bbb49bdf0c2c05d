// What the pen feels: the force of the tool with the edges that are felt as soft ridges, or that of
// an open ring.
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/session/session.h"
#include "felt/session/session_parts.h"
#include "felt/tools/choice_ring.h"
#include "felt/tools/edge_ridges.h"
#include "felt/tools/feel_id.h"

namespace felt {

ForceModel Session::force() const {
  if (parts_->surface.plane_only()) {
    const PlaneOptions plane = plane_for(surface(), options_.device);
    ForceModel model{Plane(plane)};
    model.set_fade_id(
        FeelId("plane").with(plane.stiffness_n_per_m).with(plane.damping_n_s_per_m).value());
    return model;
  }
  if (ring_) return ring_force(*ring_, surface(), options_.device);
  Scene now = scene();
  const Guide* edge = edge_ridges_ ? edge_ridges_->force() : nullptr;
  // A guide of the drawing that is far away does not hold the pen.
  if (edge && !guide() && !now.guide.softens_friction) now.guide = {};
  ForceModel model = tool().force(now);
  if (!edge || !model.add(*edge)) return model;
  model.set_fade_id(FeelId("edge")
                        .with(std::uint64_t{model.fade_id()})
                        .with(std::uint64_t{edge_ridges_->number()})
                        .value());
  return model;
}

Result<void> Session::use_edges(const UseEdges& event) {
  const Rect& page = event.page;
  const bool is_none = page == Rect{};
  for (const double mm : {page.x0, page.y0, page.x1, page.y1}) {
    if (is_none || (std::isfinite(mm) && !page.empty())) continue;
    return fail(ErrorCode::kInvalidArgument, "page: is not a rectangle");
  }
  edges_ = event;
  const bool is_felt = !is_none || event.selection;
  // The old ridges stay if they are changed, because of EdgeRidges::number().
  if (is_felt && !edge_ridges_) edge_ridges_ = std::make_unique<EdgeRidges>();
  if (!is_felt && edge_ridges_) edge_ridges_->set({}, {});
  return {};
}

Result<void> Session::use_ring(const UseRing& event) {
  if (!event.is_open) {
    // A touch that began in the ring must not draw.
    must_lift_ = must_lift_ || (ring_ && touches_ring_);
    ring_.reset();
    return {};
  }
  if (gesture_in_progress()) return {};
  const Vec up = event.top - event.middle, right = event.right - event.middle;
  if (!is_pen_position({event.middle.x, event.middle.y, 0.0}) ||
      !(std::fabs(cross(up, right)) > 0.0) ||
      !std::isfinite(norm_squared(up) + norm_squared(right))) {
    return fail(ErrorCode::kInvalidArgument, "points: are not those of a ring");
  }
  // The tool does not see the next touch, so ink that it holds back must not wait for it. An offer
  // stays.
  std::optional<Offer> offer = std::move(offer_);
  if (Result<void> settled = settle(); !settled) return settled;
  offer_ = std::move(offer);
  if (!ring_) touches_ring_ = false;
  ring_ = std::make_unique<ChoiceRing>(event.middle, up, right);
  return {};
}

void Session::follow_ring(PenSample& sample) {
  if (!ring_) return;
  ring_->move({sample.position.x, sample.position.y});
  touches_ring_ = in_contact(sample);
  lift(sample);
}

void Session::draw_ring(Overlay& overlay) const {
  if (!ring_) return;
  const double radius_mm = ring_->radius_mm();
  overlay.rings.push_back(
      {ring_->middle(), ChoiceRing::kMiddle * radius_mm, Overlay::Role::kReach});
  overlay.rings.push_back({ring_->middle(), radius_mm, Overlay::Role::kReach});
  for (std::size_t i = 0; i < ChoiceRing::kWells; ++i) {
    const bool is_chosen = ring_->chosen() == i;
    overlay.dots.push_back(
        {ring_->well(i), is_chosen ? Overlay::Role::kSnap : Overlay::Role::kHandle});
  }
}

}  // namespace felt
