#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/stroke/fit/ink_fit.h"

namespace felt::bench {

/// Strokes that were drawn one after the other on the same page, in mm, with times from 0.
struct RealPage {
  std::string name;
  std::vector<std::vector<InkSample>> strokes;
  /// For each stroke the line of the drawing that it is part of, if that is known.
  std::vector<std::uint32_t> labels = {};
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

/// How a page is changed as a whole: the strokes keep their order, their positions relative to each
/// other, their pressures and their times. So a larger page is drawn faster, and rests last as
/// long.
struct PageVariant {
  bool is_mirrored = false;  ///< left and right are exchanged
  double turn_deg = 0.0;     ///< from +x to +y, as on a turned sheet
  double scale = 1.0;

  /// Returns for example "mirrored, 20 degrees, x 1.4".
  [[nodiscard]] std::string name() const;
};
/// Returns all variants but the unchanged page: mirrored or not; turned by -20, 0 or 20 degrees;
/// scaled by 0.35, 0.7, 1, 1.4 or 2.
std::vector<PageVariant> page_variants();
/// Returns the changed pages. The top left corner of the box around a page stays.
std::vector<RealPage> varied(const std::vector<RealPage>& pages, const PageVariant& variant);

/// Offers that real strokes got, and strokes that were held to a line as if they retraced it.
struct FalseOffers {
  std::size_t strokes = 0, scratch_outs = 0, double_loops = 0, accepted_shapes = 0, rests = 0;
  std::size_t holds = 0;     ///< to another line than that of the label
  std::size_t retraced = 0;  ///< held to a stroke of the same label
  [[nodiscard]] std::size_t wrong() const { return scratch_outs + double_loops + accepted_shapes; }
  FalseOffers& operator+=(const FalseOffers& other) noexcept;
};
/// Draws all pages in sessions and counts. If `each`, prints the name of each false one.
FalseOffers draw_pages(const std::vector<RealPage>& pages, bool each);

}  // namespace felt::bench
