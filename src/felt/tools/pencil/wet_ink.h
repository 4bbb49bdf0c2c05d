#pragma once

#include <vector>

#include "felt/stroke/ink_fitter.h"
#include "felt/stroke/width_map.h"
#include "felt/tools/overlay.h"

namespace felt {

/// The picture of a stroke that is being drawn: the fitter's stable prefix, cut into pieces short
/// enough that a straight change of width does, and the provisional tail.
///
/// A piece is made once, when its segment becomes stable: a sample costs what it adds, whatever the
/// length of the stroke. Only showing copies them all.
class WetInk {
 public:
  static constexpr double kPieceMm = 2.0;

  void begin(const WidthMapOptions& widths);
  /// After each sample of the fitter; `sample` is the one that it was given.
  void update(const InkFitter& fitter, const InkSample& sample);
  /// Width at the pen, mm.
  [[nodiscard]] double width_mm() const noexcept { return pen_width_mm_; }
  /// Adds the stroke as it is now.
  void draw(InkFitter& fitter, Overlay& overlay) const;

 private:
  void add_segment(const InkFitter& fitter, int i);

  std::vector<Overlay::InkSegment> pieces_;
  int segments_ = 0;         // of the fitter, in pieces_
  std::size_t places_ = 0;   // likewise
  std::size_t samples_ = 0;  // likewise
  WidthMap stable_widths_;   // of the samples as the fitter took them, up to samples_
  WidthMap pen_widths_;      // of the samples as they came
  double stable_width_mm_ = 0.0;
  double pen_width_mm_ = 0.0;
};

}  // namespace felt
