#pragma once

#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/stroke/fit/ink_fit.h"

namespace felt::bench {

/// Strokes that were drawn one after the other on the same page, in mm, with times from 0.
struct RealPage {
  std::string name;
  std::vector<std::vector<InkSample>> strokes;
};

/// How strokes whose positions are not known are placed.
enum class Placing { kInLines, kPiled };

/// Reads recordings (docs/formats/ndjson.md). Strokes with the same id up to "#" are one page.
Result<std::vector<RealPage>> read_pen_strokes(const std::string& path, double mm_per_unit,
                                               Placing placing);
/// Reads drawings (.scap) and scales them to this diagonal. The samples are 8 ms apart.
Result<std::vector<RealPage>> read_drawings(const std::string& folder, double diagonal_mm);

/// Reads the notes (.xopp) of a folder. The files have no times: the samples are 8 ms apart.
Result<std::vector<RealPage>> read_notes(const std::string& folder);

/// Offers that real strokes got.
struct FalseOffers {
  std::size_t strokes = 0, scratch_outs = 0, double_loops = 0, accepted_shapes = 0, rests = 0;
  [[nodiscard]] std::size_t wrong() const { return scratch_outs + double_loops + accepted_shapes; }
};
/// Draws all pages in sessions and counts. If `each`, prints the name of each false one.
FalseOffers draw_pages(const std::vector<RealPage>& pages, bool each);

}  // namespace felt::bench
