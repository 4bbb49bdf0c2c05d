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
namespace {

// The force of a contour of a picture: 0.15 N at the default of pencil.retrace_n.
constexpr double kContourShare = 1.5;

Result<void> check_count(const std::vector<std::vector<Point>>& contours) {
  std::size_t points = 0;
  for (const auto& contour : contours) points += contour.size();
  if (contours.size() <= UseEdges::kMaxContours && points <= UseEdges::kMaxContourPoints) return {};
  return fail(ErrorCode::kLimitExceeded,
              "contours: are more than 1000, or have more than 20000 points");
}

}  // namespace

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

void Session::follow_guides(const PenSample& sample) {
  const bool draws = tool().info().kind == ToolKind::kDraws && !parts_->guide;
  if (!draws) stroke_guide_->stop();
  stroke_guide_->update(sample, parts_->contact.is_down(),
                        draws ? std::span<const DrawingGuidePtr>(parts_->visible_guides)
                              : std::span<const DrawingGuidePtr>(),
                        seen(), guide_spring_for(options_.device));
  const bool is_guided = parts_->guide || stroke_guide_->force();
  const double retrace_n = options_.device.has_force() && !is_guided ? tool().retrace_n() : 0.0;
  const bool is_down = parts_->contact.is_down();
  parts_->retrace.update(sample, is_down, scene(), retrace_n);
  const bool has_contours = parts_->contours != nullptr;
  parts_->contour_hold.update(sample, is_down,
                              has_contours ? parts_->contours->scene(scene()) : scene(),
                              has_contours ? kContourShare * retrace_n : 0.0);
}

Result<void> Session::use_edges(const UseEdges& event) {
  const Rect& page = event.page;
  const bool is_none = page == Rect{};
  for (const double mm : {page.x0, page.y0, page.x1, page.y1}) {
    if (is_none || (std::isfinite(mm) && !page.empty())) continue;
    return fail(ErrorCode::kInvalidArgument, "page: is not a rectangle");
  }
  if (event.contours != edges_.contours) {
    if (Result<void> fine = check_count(event.contours); !fine) return fine;
    Result<std::unique_ptr<PictureContours>> contours = PictureContours::create(event.contours);
    if (!contours) return tl::unexpected(contours.error());
    parts_->contour_hold.stop();
    parts_->contours = *std::move(contours);
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
