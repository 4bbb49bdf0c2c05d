#include "felt/tools/pull/bulge_gesture.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#include "felt/document/edit_builder.h"
#include "felt/tools/junctions.h"
#include "felt/tools/pull/bulge_pull.h"

namespace felt {
namespace {

/// How far the pen may move without an effect, so that a touch changes nothing, and the way back to
/// the start is easy.
constexpr double kBulgeRestMm = 0.5;

class BulgeGesture final : public PullGesture {
 public:
  BulgeGesture(const PenSample& touch, const Scene& scene, const BulgeOptions& options)
      : options_(options),
        map_{.centre = on_page(touch.position), .radius_mm = options.radius_mm},
        pen_(map_.centre) {
    map_.gain = options.pinches ? RadialMap::kMinGain : RadialMap::kMaxGain;
    Rect around;
    around.extend(map_.centre);
    EditBuilder edit(scene.document);
    for (const StrokeId id : scene.index.strokes_in(around.inflated(map_.radius_mm))) {
      const StrokePtr stroke = scene.document.find(id);
      std::vector<double> shared;
      for (const Junction& j : junctions_of(scene.document, scene.index, id, *stroke)) {
        shared.push_back(j.u);
      }
      BulgePull pull(stroke, map_, options.tolerance_mm, shared);
      if (!pull.moves()) continue;
      pulls_.emplace(id, std::move(pull));
      edit.replace(id, stroke);
    }
    shown_ = std::move(edit).build(options.pinches ? "Pinch" : "Bulge");
    map_.gain = 0.0;
  }

  std::optional<Edit> move(const PenSample& pen, const Scene& /*scene*/) override {
    if (!is_finite(on_page(pen.position))) return std::nullopt;
    pen_ = on_page(pen.position);
    const double gain = bulge_gain(distance(pen_, map_.centre), options_);
    if (gain == map_.gain || pulls_.empty()) return std::nullopt;
    if (gain == 0.0) {
      map_.gain = 0.0;
      return Edit{.label = shown_.label, .changes = {}};
    }
    std::optional<Edit> now = edit([&](const BulgePull& pull) { return pull.at(gain); });
    if (!now) return std::nullopt;  // keep the last valid shapes
    map_.gain = gain;
    return shown_ = *std::move(now);
  }

  Edit end(const Scene& /*scene*/) override {
    if (map_.gain == 0.0) return {};
    return edit([&](const BulgePull& pull) { return pull.finished(map_.gain); }).value_or(shown_);
  }

  [[nodiscard]] PullFeel feel() const override {
    if (pulls_.empty()) return {};
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
  /// Returns the edit with the strokes that `make` makes of the pulls, or nullopt if one fails.
  template <class Make>
  [[nodiscard]] std::optional<Edit> edit(Make make) const {
    Edit edit = shown_;
    for (StrokeChange& change : edit.changes) {
      Result<Stroke> after = make(pulls_.at(change.id));
      if (!after) return std::nullopt;
      change.after = std::make_shared<const Stroke>(*std::move(after));
    }
    return edit;
  }

  BulgeOptions options_;
  RadialMap map_;  // as it is now
  Point pen_;
  std::map<StrokeId, BulgePull> pulls_;
  Edit shown_;  // has a change for each of pulls_
};

}  // namespace

double bulge_gain(double distance_mm, const BulgeOptions& options) noexcept {
  const double limit = options.pinches ? RadialMap::kMinGain : RadialMap::kMaxGain;
  const double moved_mm = std::max(0.0, distance_mm - kBulgeRestMm);
  return limit * moved_mm / (moved_mm + 0.5 * options.radius_mm);
}

std::unique_ptr<PullGesture> make_bulge(const PenSample& touch, const Scene& scene,
                                        const BulgeOptions& options) {
  return std::make_unique<BulgeGesture>(touch, scene, options);
}

}  // namespace felt
