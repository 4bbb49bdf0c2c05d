#include "felt/solid/gap_search.h"

#include <algorithm>

#include "felt/solid/inflate.h"

namespace felt {
namespace {

/// The wider gaps that are offered, in mm.
constexpr std::array kOfferedGapsMm{4.0, 8.0, 16.0, 32.0};

}  // namespace

double enclosed_area_mm2(const Document& document, double gap_mm) {
  const auto found = find_outlines(document, gap_mm, HoleChoice::kFill, FaultChoice::kLeaveOut);
  double area_mm2 = 0.0;
  if (found) {
    for (const SolidOutline& outline : found->outlines) area_mm2 += size_of(outline).area_mm2;
  }
  return area_mm2;
}

double automatic_gap_mm(const Document& document, const std::atomic<bool>& is_cancelled) {
  if (document.stroke_count() > kMaxSearchedStrokes) return kAutomaticGapsMm.front();
  std::array<double, kAutomaticGapsMm.size()> areas{};
  for (std::size_t i = 0; i < areas.size() && !is_cancelled; ++i) {
    areas[i] = enclosed_area_mm2(document, kAutomaticGapsMm[i]);
  }
  const double enough = kEnoughArea * *std::max_element(areas.begin(), areas.end());
  for (std::size_t i = 0; enough > 0.0 && i < areas.size(); ++i) {
    if (areas[i] >= enough) return kAutomaticGapsMm[i];
  }
  return kAutomaticGapsMm.front();
}

double automatic_gap_mm(const Document& document) {
  const std::atomic<bool> never{false};
  return automatic_gap_mm(document, never);
}

std::optional<double> wider_gap_mm(const Document& document, double gap_mm, double area_mm2) {
  for (const double wider : kOfferedGapsMm) {
    // Larger gaps are only tried if nothing is closed, because they also join separate shapes.
    if (wider > kAutomaticGapsMm.back() && area_mm2 > 0.0) break;
    if (wider <= gap_mm) continue;
    if (kEnoughArea * enclosed_area_mm2(document, wider) > area_mm2) return wider;
  }
  return std::nullopt;
}

}  // namespace felt
