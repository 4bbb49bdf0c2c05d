#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/gather/line_sections.h"

namespace felt {

/// How two rough lines lie beside each other, measured on the sections of both. Lengths are
/// relative to the scale of the drawing.
struct LinePair {
  std::uint32_t a = 0, b = 0;  ///< a < b
  /// The number of values in `features`.
  static constexpr std::size_t kFeatures = 6;
  /// In this order: logarithm of the median of the widest gap between a and b on a section, where
  /// lines in between divide gaps; the same of its largest tenth; the logarithm of the first
  /// relative to the usual gap of the drawing; the mean angle in radians; the share of the line
  /// that lies beside the other, for the line with the smaller share; the logarithm of the length
  /// beside each other relative to the gap.
  std::array<double, kFeatures> features{};
  double overlap = 0.0;      ///< length over which both lie beside each other
  bool in_hatching = false;  ///< both are lines of one hatching (HatchingFinder)

  friend bool operator==(const LinePair&, const LinePair&) = default;
};

/// Returns the sections with which line_pairs measures a drawing of this scale.
SectionOptions pair_sections(double scale_mm);

/// Returns all pairs of lines that lie beside each other within 6 % of `scale_mm`, sorted by a and
/// b. Requires points in range and scale_mm > 0. Fails with kUnsupported and the position if so
/// many lines lie on each other that the comparison would take more than 400 million tests.
Result<std::vector<LinePair>> line_pairs(std::span<const RoughLine> lines, double scale_mm,
                                         double ink_mm = 0.0);

/// Returns the logarithm of the odds that both lines of a pair belong to the same strip: positive
/// if they probably do.
///
/// A logistic regression with the squares and products of the features. Its weights come from the
/// labelled drawings of StrokeStrip (doi:10.1145/3450626.3459777): `./dev bench gather --fit`.
double log_odds(const LinePair& pair) noexcept;

/// The number of terms of the regression.
inline constexpr std::size_t kOddsTerms = (LinePair::kFeatures + 1) * (LinePair::kFeatures + 2) / 2;

/// Returns the terms of the regression: the products of all pairs of 1 and the features, after
/// these were normalised by `mean` and `spread` and limited to 3 spreads.
std::array<double, kOddsTerms> odds_terms(
    const std::array<double, LinePair::kFeatures>& features,
    const std::array<double, LinePair::kFeatures>& mean,
    const std::array<double, LinePair::kFeatures>& spread) noexcept;

}  // namespace felt
