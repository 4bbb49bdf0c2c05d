#include "swell_output.h"

#include <utility>

#include "console.h"
#include "felt/document/visible_strokes.h"
#include "felt/tactile/swell_paper.h"

namespace felt::cli {
namespace {

/// Returns the A4 page on which the ink fits, or nullopt.
std::optional<Rect> a4_for(const Rect& ink) {
  constexpr double kLong = TactileLimits::kLongMm, kShort = TactileLimits::kShortMm;
  for (const Rect page : {Rect{0.0, 0.0, kLong, kShort}, Rect{0.0, 0.0, kShort, kLong}}) {
    const bool fits = !ink.empty() && ink.x0 >= page.x0 && ink.y0 >= page.y0 && ink.x1 <= page.x1 &&
                      ink.y1 <= page.y1;
    if (fits) return page;
  }
  return std::nullopt;
}

}  // namespace

Result<void> make_swell_drawing(Drawing& drawing, PictureOptions& picture,
                                const std::string& output, Console& console) {
  SwellReport report;
  Result<Drawing> swell = prepare_for_swell_paper(drawing, report);
  if (!swell) return tl::unexpected(with_context(swell.error(), output));
  drawing = *std::move(swell);
  if (!drawing.has_page && !picture.area && !picture.fit) {
    picture.area = a4_for(ink_bounds(drawing.document));
  }
  for (const std::string& sentence : report.sentences()) {
    console.notice(output + ": " + sentence);
  }
  return {};
}

}  // namespace felt::cli
