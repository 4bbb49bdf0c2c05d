#include "desktop/solid/solid_job.h"

#include <utility>

#include "felt/solid/body_edits.h"
#include "felt/solid/gap_search.h"
#include "felt/solid/inflate.h"

namespace felt::desktop {
namespace {

/// Adds the ink on the bodies. If there is too little memory for it, they stay unpainted.
void add_paint(const Document& document, const Grain& grain, SolidAnswer& answer) {
  Result<std::optional<FrontPaint>> paint = front_paint(document, *answer.solid, grain);
  if (!paint) {
    answer.notes.push_back(paint.error().message);
  } else if (*paint) {
    answer.paint = std::make_shared<const FrontPaint>(**std::move(paint));
  }
}

/// Applies the edits of the body, and the new one after them.
Solid edited(Solid solid, const Document& document, const std::optional<BodyEdit>& new_edit,
             const std::atomic<bool>& is_cancelled, SolidAnswer& answer) {
  std::vector<BodyEdit> edits = body_edits_of(document);
  if (edits.empty() && !new_edit) return solid;
  if (new_edit) edits.push_back(*new_edit);
  EditedSolid result = apply_body_edits(std::move(solid), edits, &is_cancelled);
  if (new_edit) {
    if (!result.reasons.back().empty()) answer.new_edit_refusal = result.reasons.back();
    result.refusals.pop_back();
  }
  for (std::string& refusal : result.refusals) {
    if (!refusal.empty()) answer.notes.push_back(std::move(refusal));
  }
  return std::move(result.solid);
}

}  // namespace

SolidAnswer make_solid(const Document& document, const SolidRequest& request,
                       const std::atomic<bool>& is_cancelled) {
  SolidAnswer answer;
  answer.gap_mm = request.gap_mm ? *request.gap_mm : automatic_gap_mm(document, is_cancelled);
  if (is_cancelled) return answer;
  InflateOptions options;
  options.max_gap_mm = answer.gap_mm;
  options.holes = request.holes;
  options.faults = FaultChoice::kLeaveOut;
  Result<InflatedDrawing> inflated = inflate(document, options);
  if (inflated) {
    answer.notes = std::move(inflated->notes);
    answer.solid = std::make_shared<const Solid>(std::move(inflated->solid));
    add_paint(document, request.grain, answer);  // the ink lies on the bodies as they were drawn
    answer.solid = std::make_shared<const Solid>(
        edited(*answer.solid, document, request.new_edit, is_cancelled, answer));
  } else {
    answer.notes.push_back(inflated.error().message);
    answer.is_open = inflated.error().code == ErrorCode::kNotFound;
  }
  if (is_cancelled) {
    answer.solid = nullptr;
    return answer;
  }
  const bool wants_offer = request.gap_mm || !answer.solid;
  const bool can_search = document.stroke_count() <= kMaxSearchedStrokes;
  if (wants_offer && can_search && document.stroke_count() > 0) {
    const double area = answer.solid ? enclosed_area_mm2(document, answer.gap_mm) : 0.0;
    answer.wider_gap_mm = wider_gap_mm(document, answer.gap_mm, area);
  }
  return answer;
}

}  // namespace felt::desktop
