#include "desktop/solid/solid_job.h"

#include <algorithm>
#include <utility>

#include "felt/solid/inflate.h"

namespace felt::desktop {
namespace {

/// The wider gaps that are offered, in mm.
constexpr std::array kOfferedGapsMm{4.0, 8.0, 16.0, 32.0};

/// Returns the area that outlines enclose, with their holes, in mm^2.
double enclosed_area(const Document& document, double gap_mm) {
  const auto found = find_outlines(document, gap_mm, HoleChoice::kFill, FaultChoice::kLeaveOut);
  double area = 0.0;
  if (found) {
    for (const SolidOutline& outline : found->outlines) area += size_of(outline).area_mm2;
  }
  return area;
}

/// The areas for the automatic gaps.
using GapAreas = std::array<double, SolidRequest::kAutomaticGapsMm.size()>;

double automatic_gap(const GapAreas& areas) {
  const double enough = SolidRequest::kEnoughArea * *std::max_element(areas.begin(), areas.end());
  for (std::size_t i = 0; enough > 0.0 && i < areas.size(); ++i) {
    if (areas[i] >= enough) return SolidRequest::kAutomaticGapsMm[i];
  }
  return SolidRequest::kAutomaticGapsMm.front();
}

/// Returns the smallest gap above `gap_mm` that encloses clearly more than `area_mm2`.
std::optional<double> wider_gap(const Document& document, double gap_mm, double area_mm2) {
  for (const double wider : kOfferedGapsMm) {
    // Larger gaps are only tried if nothing is closed, because they also join separate shapes.
    if (wider > SolidRequest::kAutomaticGapsMm.back() && area_mm2 > 0.0) break;
    if (wider <= gap_mm) continue;
    if (SolidRequest::kEnoughArea * enclosed_area(document, wider) > area_mm2) return wider;
  }
  return std::nullopt;
}

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
  answer.gap_mm = request.gap_mm.value_or(SolidRequest::kAutomaticGapsMm.front());
  const bool can_search = document.stroke_count() <= SolidRequest::kMaxSearchedStrokes;
  if (!request.gap_mm && can_search) {
    GapAreas areas{};
    for (std::size_t i = 0; i < areas.size() && !is_cancelled; ++i) {
      areas[i] = enclosed_area(document, SolidRequest::kAutomaticGapsMm[i]);
    }
    answer.gap_mm = automatic_gap(areas);
  }
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
  if (wants_offer && can_search && document.stroke_count() > 0) {
    const double area = answer.solid ? enclosed_area(document, answer.gap_mm) : 0.0;
    answer.wider_gap_mm = wider_gap(document, answer.gap_mm, area);
  }
  return answer;
}

}  // namespace felt::desktop
