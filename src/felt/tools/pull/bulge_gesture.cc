#include "felt/tools/pull/bulge_gesture.h"

#include <array>
#include <cstdio>
#include <utility>
#include <vector>

#include "felt/document/edit_builder.h"
#include "felt/tools/pull/bulge_pull.h"

namespace felt {
namespace {

/// A stroke within the circle.
struct Bulged {
  StrokeId id;
  StrokePtr before, shown;
  BulgePull pull;
};

class BulgeGesture final : public PullGesture {
 public:
  BulgeGesture(const PenSample& touch, const Scene& scene, const BulgeOptions& options)
      : options_(options),
        map_{.centre = on_page(touch.position), .radius_mm = options.radius_mm},
        pen_(map_.centre) {
    map_.gain = options.pinches ? RadialMap::kMinGain : RadialMap::kMaxGain;
    Rect around;
    around.extend(map_.centre);
    for (const StrokeId id : scene.index.strokes_in(around.inflated(map_.radius_mm))) {
      const StrokePtr stroke = scene.document.find(id);
      BulgePull pull(stroke, map_, options.tolerance_mm);
      if (pull.moves()) strokes_.push_back({id, stroke, stroke, std::move(pull)});
    }
    map_.gain = 0.0;
  }

  std::optional<Edit> move(const PenSample& pen, const Scene& scene) override {
    if (!is_finite(on_page(pen.position))) return std::nullopt;
    pen_ = on_page(pen.position);
    const double gain = bulge_gain(distance(pen_, map_.centre), options_);
    if (gain == map_.gain || strokes_.empty()) return std::nullopt;
    map_.gain = gain;
    for (Bulged& stroke : strokes_) {
      if (gain == 0.0) {
        stroke.shown = stroke.before;
      } else if (Result<Stroke> now = stroke.pull.at(gain)) {
        stroke.shown = std::make_shared<const Stroke>(*std::move(now));
      }
    }
    return edit(scene);
  }

  Edit end(const Scene& scene) override {
    if (map_.gain == 0.0) return {};
    for (Bulged& stroke : strokes_) {
      if (Result<Stroke> done = stroke.pull.finished(map_.gain)) {
        stroke.shown = std::make_shared<const Stroke>(*std::move(done));
      }
    }
    return edit(scene);
  }

  [[nodiscard]] PullFeel feel() const override {
    if (strokes_.empty()) return {};
    return {.kind = PullFeel::Kind::kSpring, .origin = map_.centre};
  }

  void draw(Overlay& overlay) const override {
    overlay.rings.push_back({map_.centre, map_.radius_mm, Overlay::Role::kReach});
    overlay.dots.push_back({map_.centre, Overlay::Role::kHandle});
    if (map_.gain == 0.0) return;
    overlay.lines.push_back({map_.centre, pen_, Overlay::Role::kVector});
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.0f %%", 100.0 * (1.0 + map_.gain));
    overlay.labels.push_back({pen_, text.data()});
  }

 private:
  [[nodiscard]] Edit edit(const Scene& scene) const {
    EditBuilder edit(scene.document);
    for (const Bulged& stroke : strokes_) {
      if (stroke.shown != stroke.before) edit.replace(stroke.id, stroke.shown);
    }
    return std::move(edit).build(options_.pinches ? "Pinch" : "Bulge");
  }

  BulgeOptions options_;
  RadialMap map_;  // as it is now
  Point pen_;
  std::vector<Bulged> strokes_;
};

}  // namespace

double bulge_gain(double distance_mm, const BulgeOptions& options) noexcept {
  const double limit = options.pinches ? RadialMap::kMinGain : RadialMap::kMaxGain;
  if (!(distance_mm > 0.0)) return 0.0;
  return limit * distance_mm / (distance_mm + 0.5 * options.radius_mm);
}

std::unique_ptr<PullGesture> make_bulge(const PenSample& touch, const Scene& scene,
                                        const BulgeOptions& options) {
  return std::make_unique<BulgeGesture>(touch, scene, options);
}

}  // namespace felt
