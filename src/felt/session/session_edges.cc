// Edges that are felt as soft ridges.
#include <cmath>
#include <memory>

#include "felt/session/session.h"
#include "felt/tools/edge_ridges.h"
#include "felt/tools/feel_id.h"

namespace felt {

ForceModel Session::force() const {
  Scene now = scene();
  const Guide* edge = edge_ridges_ ? edge_ridges_->force() : nullptr;
  // A guide of the drawing that is far away does not hold the pen.
  if (edge && !parts_->guide && !now.guide.softens_friction) now.guide = {};
  ForceModel model = tool().force(now);
  const ToolKind kind = tool().info().kind;
  // Only one Guide can act at a time, because all of them use the same memory (ForceMemory::guide).
  const bool has_guide = now.guide.force || kind == ToolKind::kFills || kind == ToolKind::kReads;
  if (!edge || has_guide || !model.add(*edge)) return model;
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

}  // namespace felt
