#include "felt/tools/lasso/lasso_take.h"

#include <utility>

#include "felt/stroke/edit/point_marks.h"

namespace felt {

namespace {

void mark_points_inside(const Stroke& stroke, const LassoArea& area, Selection::Marks& marks) {
  const auto& points = stroke.data().points;
  for (std::size_t i = 0; i < points.size(); ++i) marks[i] = area.contains(points[i]) ? 1 : 0;
}

}  // namespace

Selection::Marks marks_inside(const Stroke& stroke, const LassoArea& area, LassoTake take) {
  const auto& points = stroke.data().points;
  Selection::Marks marks(points.size(), 0);
  switch (take) {
    case LassoTake::kParts: {
      const double inside = area.share_inside(stroke);
      if (inside >= 1.0 - kTailShare) {
        marks.assign(points.size(), 1);
      } else if (inside > 0.0) {
        mark_points_inside(stroke, area, marks);
      }
      break;
    }
    case LassoTake::kPoints:
      mark_points_inside(stroke, area, marks);
      break;
    case LassoTake::kOnCurve:
      for (std::size_t i = 0; i < points.size(); i += 3) {
        if (!area.contains(points[i])) continue;
        marks[i] = 1;
        if (i > 0) marks[i - 1] = 1;
        if (i + 1 < points.size()) marks[i + 1] = 1;
      }
      break;
    case LassoTake::kStrokes:
      if (area.touches(stroke)) marks.assign(points.size(), 1);
      break;
  }
  return marks;
}

Selection taken_by(const LassoArea& area, LassoTake take, const Document& document,
                   const StrokeIndex& index) {
  Selection taken;
  // The index contains the ink only, but handles may lie outside of it.
  const double reach = take == LassoTake::kPoints ? index.farthest_handle_mm() : 0.0;
  for (const StrokeId id : index.strokes_in(area.bounds().inflated(reach))) {
    const StrokePtr stroke = document.find(id);
    Selection::Marks marks = marks_inside(*stroke, area, take);
    close_marks(*stroke, marks);
    taken.set(id, std::move(marks));
  }
  return taken;
}

Selection combined(const Document& document, const Selection& before, const Selection& taken,
                   LassoCombine combine) {
  if (combine == LassoCombine::kReplace) return taken;
  Selection result = before;
  for (const auto& [id, marks] : taken.strokes()) {
    const Selection::Marks* old = before.find(id);
    if (!old || old->size() != marks.size()) {
      if (combine == LassoCombine::kAdd) result.set(id, marks);
      continue;
    }
    Selection::Marks both = *old;
    for (std::size_t i = 0; i < both.size(); ++i) {
      if (marks[i]) both[i] = combine == LassoCombine::kAdd ? 1 : 0;
    }
    close_marks(*document.find(id), both);
    result.set(id, std::move(both));
  }
  return result;
}

}  // namespace felt
