#include "felt/tools/pull/push_gesture.h"

#include <algorithm>
#include <utility>

#include "felt/document/edit_builder.h"
#include "felt/tools/connected_pull.h"
#include "felt/tools/junctions.h"
#include "felt/tools/pull/nib_lines.h"

namespace felt {
namespace {

constexpr const char* kPushLabel = "Push";
/// Lines farther from the nib than this exert no force, because the force falls to zero within 1
/// N/Kcap (Kcap is the maximum stiffness).
constexpr double kFeltMm = 4.0;

class PushGesture final : public PullGesture {
 public:
  PushGesture(const PenSample& touch, const PushOptions& options)
      : lines_(options.radius_mm),
        connected_(BrushOptions{}),
        radius_mm_(options.radius_mm),
        last_(on_page(touch.position)) {}

  std::optional<Edit> move(const PenSample& pen, const Scene& scene) override {
    const Point now = on_page(pen.position);
    // If the pen lands exactly on a line, the direction from which it came is opposite to its
    // velocity.
    const Vec came_from = -normalized({pen.velocity.x, pen.velocity.y});
    const bool moved = lines_.move(last_, now, came_from, scene);
    last_ = now;
    if (!moved) return std::nullopt;
    Edit edit{.label = kPushLabel, .changes = {}};
    for (const auto& [id, line] : lines_.lines()) add(line.replacement, line.push.stroke(), edit);
    if (lines_.gap_mm() > kSharedPointMm) connected_.complete(edit, scene);
    return edit;
  }

  Edit end(const Scene& scene) override {
    Edit edit{.label = kPushLabel, .changes = {}};
    for (auto& [id, stroke] : lines_.finished(last_)) {
      add(lines_.lines().at(id).replacement, std::move(stroke), edit);
    }
    connected_.complete(edit, scene);
    return edit;
  }

  [[nodiscard]] PullFeel feel() const override {
    PullFeel feel{.kind = PullFeel::Kind::kPush};
    feel.line = line_under_nib();
    return feel;
  }

  void draw(Overlay& overlay) const override {
    overlay.rings.push_back({last_, radius_mm_, Overlay::Role::kReach});
    for (const auto& [id, line] : lines_.lines()) {
      if (const auto& contact = line.push.contact()) {
        overlay.dots.push_back({*contact, Overlay::Role::kHandle});
      }
    }
  }

 private:
  /// Returns one line that combines all lines near the nib. They are weighted by their forces at
  /// this point, so that the force does not jump when a line is added or removed.
  [[nodiscard]] LineUnderNib line_under_nib() const {
    LineUnderNib sum{.pen = last_}, nearest{.pen = last_, .gap_mm = kFeltMm};
    Vec normals{};
    double all_n = 0.0;
    for (const auto& [id, line] : lines_.lines()) {
      auto under = line.push.under(last_, radius_mm_ + kFeltMm);
      if (!under || !line.touched) continue;
      under->displacement_mm = std::max(0.0, under->displacement_mm - line.carried_mm);
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

  static void add(const StrokeReplacement& place, StrokePtr after, Edit& edit) {
    if (after == place.before()) return;
    Edit one = place.with(std::move(after), kPushLabel);
    edit.changes.push_back(std::move(one.changes.front()));
  }

  NibLines lines_;
  ConnectedPull connected_;  // closes the gaps that the nib leaves
  double radius_mm_;
  Point last_;
};

}  // namespace

std::unique_ptr<PullGesture> make_push(const PenSample& touch, const Scene& /*scene*/,
                                       const PushOptions& options) {
  return std::make_unique<PushGesture>(touch, options);
}

}  // namespace felt
