#include "desktop/solid/solid_job.h"

#include <utility>

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
    add_paint(document, request.grain, answer);
  } else {
    answer.notes.push_back(inflated.error().message);
    answer.is_open = inflated.error().code == ErrorCode::kNotFound;
  }
  if (is_cancelled) return answer;
  const bool wants_offer = request.gap_mm || !answer.solid;
  const bool can_search = document.stroke_count() <= kMaxSearchedStrokes;
  if (wants_offer && can_search && document.stroke_count() > 0) {
    const double area = answer.solid ? enclosed_area_mm2(document, answer.gap_mm) : 0.0;
    answer.wider_gap_mm = wider_gap_mm(document, answer.gap_mm, area);
  }
  return answer;
}

}  // namespace felt::desktop
