#pragma once

#include <optional>

#include "felt/document/edit.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/stroke_guide.h"

namespace felt {

/// A stroke that kept to a guide, and the exact curve that can replace it.
struct ExactOffer {
  StrokeId id;
  StrokePtr drawn;  ///< as it is in the document; the offer is void if it has changed
  StrokePtr exact;
};

/// Returns the line or the arc of a circle or ellipse that a drawn stroke kept to: from the
/// position of its start to that of its end, with the widths, medium and colour of the drawn
/// stroke. A closed stroke becomes the whole ellipse. Arcs consist of cubics of at most 30 degrees;
/// their largest error is 4e-7 of the radius, because the error of a cubic arc is proportional to
/// the sixth power of its angle, and 2.7e-4 for 90 degrees (Goldapp, Computer Aided Geometric
/// Design 8, 1991, DOI 10.1016/0167-8396(91)90007-X). Returns nullopt if the result would be
/// shorter than kMinExactMm, or not a stroke.
std::optional<Stroke> exact_stroke(const Stroke& drawn, const ExactPath& path);
inline constexpr double kMinExactMm = 1.0;

/// Shows an exact curve that is offered: its middle line and its ends.
void draw_exact(const Stroke& exact, Overlay& overlay);

}  // namespace felt
