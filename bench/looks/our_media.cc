#include <algorithm>
#include <utility>

#include "artist.h"
#include "felt/material/relief.h"
#include "felt/render/page_painter.h"
#include "felt/stroke/fit/ink_fitter.h"
#include "felt/tools/medium_line.h"

namespace felt::bench {
namespace {

class OurMedium : public Artist {
 public:
  explicit OurMedium(const Medium& medium) : medium_(&medium) {}

  [[nodiscard]] std::string name() const override { return medium_->id; }
  [[nodiscard]] Rgba ink() const override { return {0, 0, 0, 255}; }

  [[nodiscard]] Result<Image> draw(const TestPage& page, double dpi) const override {
    InkFitOptions options;
    options.width_map.min_mm = medium_->line.min_mm;
    options.width_map.max_mm = std::max(medium_->line.min_mm, medium_->line.max_mm);
    options.width_map.gamma = medium_->line.gamma;
    options.width.max_mm = options.width_map.max_mm;
    InkFitter fitter(drawn_with(*medium_, options));
    std::vector<StrokePtr> strokes;
    for (const PenStroke& samples : page.strokes) {
      fitter.begin();
      for (const InkSample& sample : samples) fitter.push(sample);
      fitter.end();
      fitter.refine();
      Result<Stroke> stroke = fitter.stroke();
      if (!stroke) return tl::unexpected(stroke.error());
      strokes.push_back(std::make_shared<const Stroke>(std::move(*stroke)));
    }
    PageOptions look{.dpi = dpi, .area = Rect{0, 0, page.width_mm, page.height_mm}};
    look.grain = Grain(surface_grain(*find_surface("paper")));
    return render_page(strokes, look);
  }

 private:
  const Medium* medium_;
};

}  // namespace

std::unique_ptr<Artist> our_medium(const std::string& id) {
  return std::make_unique<OurMedium>(*find_medium(id));
}

}  // namespace felt::bench
