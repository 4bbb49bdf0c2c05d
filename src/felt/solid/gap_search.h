#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>

#include "felt/document/document.h"

namespace felt {

/// The gaps that automatic_gap_mm() tries, in mm.
inline constexpr std::array kAutomaticGapsMm{2.0, 4.0, 8.0};
/// A gap encloses enough if it encloses this share of what the best one encloses. Chosen so that
/// the parts which an open outline leaves closed (the head of the sample cat, 43 % of its area) do
/// not count as the whole drawing.
inline constexpr double kEnoughArea = 0.8;
/// In larger drawings, no gap is searched: each search would take seconds.
inline constexpr std::size_t kMaxSearchedStrokes = 2000;

/// Returns the area that the outlines of a drawing enclose, with their holes, in mm^2; 0 if no line
/// is closed.
double enclosed_area_mm2(const Document& document, double gap_mm);

/// Returns the smallest of kAutomaticGapsMm that encloses enough, or the first of them if there is
/// nothing to enclose or if the drawing has more than kMaxSearchedStrokes. If `is_cancelled`
/// becomes true, no further gap is tried.
double automatic_gap_mm(const Document& document, const std::atomic<bool>& is_cancelled);
double automatic_gap_mm(const Document& document);

/// Returns a gap above `gap_mm` that encloses clearly more than `area_mm2`, for an offer to the
/// user.
std::optional<double> wider_gap_mm(const Document& document, double gap_mm, double area_mm2);

}  // namespace felt
