#include "felt/tools/pull/brush_gesture.h"

#include <array>
#include <cstdio>
#include <utility>

#include "felt/document/edit_builder.h"
#include "felt/tools/brush_pull.h"

namespace felt {
namespace {

constexpr const char* kPullLabel = "Pull";

class BrushGesture final : public PullGesture {
 public:
  BrushGesture(const PenSample& touch, const Scene& scene, const StrokeHit& hit,
               const BrushOptions& options, TouchOffset offset)
      : stroke_(scene.document, hit.stroke),
        pull_(stroke_.before(), hit.u, options),
        radius_mm_(options.radius_mm),
        start_(on_page(touch.position)),
        offset_(start_ - pull_.origin()),
        mode_(offset),
        shown_(stroke_.before()) {}

  std::optional<Edit> move(const PenSample& pen, const Scene& /*scene*/) override {
    const Vec displacement = curve_displacement(on_page(pen.position) - start_, offset_, mode_);
    if (displacement == displacement_) return std::nullopt;
    Result<Stroke> pulled = pull_.at(displacement);
    if (!pulled) return std::nullopt;  // keep the last valid shape
    displacement_ = displacement;
    shown_ = is_home() ? stroke_.before() : std::make_shared<const Stroke>(*std::move(pulled));
    return stroke_.with(shown_, kPullLabel);
  }

  Edit end(const Scene& /*scene*/) override {
    if (is_home()) return {};
    Result<Stroke> done = pull_.finished(displacement_);
    return stroke_.with(done ? std::make_shared<const Stroke>(*std::move(done)) : shown_,
                        kPullLabel);
  }

  [[nodiscard]] PullFeel feel() const override {
    return {.kind = PullFeel::Kind::kSpring, .origin = start_};
  }

  void draw(Overlay& overlay) const override {
    const Point from = pull_.origin(), to = from + displacement_;
    if (is_home()) {
      add_span(overlay, *shown_, pull_.first_u(), pull_.last_u(), Overlay::Role::kSpan);
    } else {
      add_span(overlay, *shown_, pull_.first_joint(), pull_.last_joint(), Overlay::Role::kSpan);
    }
    overlay.rings.push_back({to, radius_mm_, Overlay::Role::kReach});
    overlay.dots.push_back({to, Overlay::Role::kHandle});
    if (is_home()) return;
    overlay.lines.push_back({from, to, Overlay::Role::kVector});
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f mm", norm(displacement_));
    overlay.labels.push_back({to, text.data()});
  }

 private:
  /// Returns true if the stroke is as it was at the touch.
  [[nodiscard]] bool is_home() const noexcept { return displacement_ == Vec{}; }

  StrokeReplacement stroke_;
  BrushPull pull_;
  double radius_mm_;
  Point start_;
  Vec offset_;  // from the curve to the pen, at the touch
  TouchOffset mode_;
  Vec displacement_{};
  StrokePtr shown_;
};

}  // namespace

std::unique_ptr<PullGesture> make_brush(const PenSample& touch, const Scene& scene,
                                        const StrokeHit& hit, const BrushOptions& options,
                                        TouchOffset offset) {
  return std::make_unique<BrushGesture>(touch, scene, hit, options, offset);
}

}  // namespace felt
