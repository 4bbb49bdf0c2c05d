#include "felt/tools/pull/push_gesture.h"

#include <algorithm>
#include <map>
#include <utility>

#include "felt/document/edit_builder.h"
#include "felt/tools/pull/nib_push.h"

namespace felt {
namespace {

constexpr const char* kPushLabel = "Push";
/// Lines farther from the nib than this exert no force, because the force falls to zero within 1
/// N/Kcap (Kcap is the maximum stiffness).
constexpr double kFeltMm = 4.0;

/// A stroke that the nib has met.
struct Pushed {
  StrokeReplacement place;
  NibPush push;
};

class PushGesture final : public PullGesture {
 public:
  PushGesture(const PenSample& touch, const PushOptions& options)
      : radius_mm_(options.radius_mm), last_(on_page(touch.position)) {}

  std::optional<Edit> move(const PenSample& pen, const Scene& scene) override {
    const Point now = on_page(pen.position);
    // If the pen lands exactly on a line, the direction from which it came is opposite to its
    // velocity.
    const Vec came_from = -normalized({pen.velocity.x, pen.velocity.y});
    meet(scene, last_, now);
    bool moved = false;
    for (auto& [id, pushed] : pushed_) {
      moved = pushed.push.move(last_, now, came_from) || moved;
    }
    last_ = now;
    if (!moved) return std::nullopt;
    Edit edit{.label = kPushLabel, .changes = {}};
    for (const auto& [id, pushed] : pushed_) add(pushed, pushed.push.stroke(), edit);
    return edit;
  }

  Edit end(const Scene& /*scene*/) override {
    Edit edit{.label = kPushLabel, .changes = {}};
    for (const auto& [id, pushed] : pushed_) {
      if (pushed.push.stroke() == pushed.place.before()) continue;
      Result<Stroke> done = pushed.push.finished(last_);
      add(pushed, done ? std::make_shared<const Stroke>(*std::move(done)) : pushed.push.stroke(),
          edit);
    }
    return edit;
  }

  [[nodiscard]] PullFeel feel() const override {
    PullFeel feel{.kind = PullFeel::Kind::kPush};
    feel.line = line_under_nib();
    return feel;
  }

  void draw(Overlay& overlay) const override {
    overlay.rings.push_back({last_, radius_mm_, Overlay::Role::kReach});
    for (const auto& [id, pushed] : pushed_) {
      if (const auto& contact = pushed.push.contact()) {
        overlay.dots.push_back({*contact, Overlay::Role::kHandle});
      }
    }
  }

 private:
  /// Adds the strokes that the nib meets for the first time.
  void meet(const Scene& scene, Point from, Point to) {
    Rect way;
    way.extend(from);
    way.extend(to);
    scene.index.for_each_segment_in(way.inflated(radius_mm_), [&](StrokeId id, int segment) {
      if (pushed_.contains(id)) return;
      const StrokePtr stroke = scene.document.find(id);
      if (!nib_meets(stroke->segment(segment), from, to, radius_mm_)) return;
      pushed_.emplace(id,
                      Pushed{StrokeReplacement(scene.document, id), NibPush(stroke, radius_mm_)});
    });
  }

  /// Returns one line that combines all lines near the nib. They are weighted by their forces at
  /// this point, so that the force does not jump when a line is added or removed.
  [[nodiscard]] LineUnderNib line_under_nib() const {
    LineUnderNib sum{.pen = last_}, nearest{.pen = last_, .gap_mm = kFeltMm};
    Vec normals{};
    double all_n = 0.0;
    for (const auto& [id, pushed] : pushed_) {
      const auto under = pushed.push.under(last_, radius_mm_ + kFeltMm);
      if (!under) continue;
      const double gap = std::max(0.0, distance(last_, under->point) - radius_mm_);
      const Vec normal = normalized(last_ - under->point);
      const double spring_n = kEditLaw.force_n(under->displacement_mm);
      const double force_n = std::max(0.0, spring_n - 1e-3 * kEditLaw.max_slope_n_per_m() * gap);
      if (force_n > 0.0) {
        normals += force_n * normal;
        all_n += force_n;
        sum.gap_mm += force_n * gap;
        sum.displacement_mm += force_n * under->displacement_mm;
      } else if (gap < nearest.gap_mm) {
        nearest.normal = normal;
        nearest.gap_mm = gap;
        nearest.displacement_mm = under->displacement_mm;
      }
    }
    // No line exerts a force yet, but the pen may reach the nearest one before the next sample.
    if (all_n == 0.0) return nearest;
    sum.normal = normalized(normals);
    sum.share = norm(normals) / all_n;
    sum.gap_mm /= all_n;
    sum.displacement_mm /= all_n;
    return sum;
  }

  static void add(const Pushed& pushed, StrokePtr after, Edit& edit) {
    if (after == pushed.place.before()) return;
    Edit one = pushed.place.with(std::move(after), kPushLabel);
    edit.changes.push_back(std::move(one.changes.front()));
  }

  double radius_mm_;
  Point last_;
  std::map<StrokeId, Pushed> pushed_;
};

}  // namespace

std::unique_ptr<PullGesture> make_push(const PenSample& touch, const Scene& /*scene*/,
                                       const PushOptions& options) {
  return std::make_unique<PushGesture>(touch, options);
}

}  // namespace felt
