#include "felt/tools/pull/push_gesture.h"

#include <map>
#include <utility>

#include "felt/document/edit_builder.h"
#include "felt/tools/pull/nib_push.h"

namespace felt {
namespace {

constexpr const char* kLabel = "Push";

Point place_of(const PenSample& pen) noexcept {
  return {pen.position.x, pen.position.y};
}

/// A stroke that the nib has met.
struct Pushed {
  StrokeReplacement place;
  NibPush push;
};

class PushGesture final : public PullGesture {
 public:
  PushGesture(const PenSample& touch, const PushOptions& options)
      : radius_mm_(options.radius_mm), last_(place_of(touch)) {}

  std::optional<Edit> move(const PenSample& pen, const Scene& scene) override {
    const Point now = place_of(pen);
    // A pen that lands exactly on a line came from where it was before.
    const Vec came_from = -normalized({pen.velocity.x, pen.velocity.y});
    meet(scene, last_, now);
    bool moved = false, touching = false;
    for (auto& [id, pushed] : pushed_) {
      moved = pushed.push.move(last_, now, came_from) || moved;
      touching = touching || pushed.push.contact().has_value();
    }
    if (touching && !touching_) ++contacts_;
    touching_ = touching;
    last_ = now;
    if (!moved) return std::nullopt;
    Edit edit{.label = kLabel, .changes = {}};
    for (const auto& [id, pushed] : pushed_) add(pushed, pushed.push.stroke(), edit);
    return edit;
  }

  Edit end(const Scene& /*scene*/) override {
    Edit edit{.label = kLabel, .changes = {}};
    for (const auto& [id, pushed] : pushed_) {
      if (pushed.push.stroke() == pushed.place.before()) continue;
      Result<Stroke> done = pushed.push.finished();
      add(pushed, done ? std::make_shared<const Stroke>(*std::move(done)) : pushed.push.stroke(),
          edit);
    }
    return edit;
  }

  [[nodiscard]] PullFeel feel() const override {
    if (!touching_) return {};
    return {.kind = PullFeel::Kind::kSweep, .gesture = contacts_};
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
  /// Strokes that the nib meets for the first time join.
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

  static void add(const Pushed& pushed, StrokePtr after, Edit& edit) {
    if (after == pushed.place.before()) return;
    Edit one = pushed.place.with(std::move(after), kLabel);
    edit.changes.push_back(std::move(one.changes.front()));
  }

  double radius_mm_;
  Point last_;
  std::map<StrokeId, Pushed> pushed_;
  bool touching_ = false;
  std::uint32_t contacts_ = 0;
};

}  // namespace

std::unique_ptr<PullGesture> make_push(const PenSample& touch, const Scene& /*scene*/,
                                       const PushOptions& options) {
  return std::make_unique<PushGesture>(touch, options);
}

}  // namespace felt
