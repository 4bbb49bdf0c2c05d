#include "felt/tools/pull/grab_gesture.h"

#include <cmath>
#include <cstdio>
#include <utility>

#include "felt/document/edit_builder.h"

namespace felt {
namespace {

class GrabGesture final : public PullGesture {
 public:
  GrabGesture(const PenSample& touch, const Scene& scene, const StrokeHit& hit,
              const GrabOptions& options, TouchOffset offset)
      : stroke_(scene.document, hit.stroke),
        pull_(stroke_.before(), hit.u, options),
        start_(on_page(touch.position)),
        offset_(start_ - pull_.origin()),
        mode_(offset),
        shown_(stroke_.before()) {}

  std::optional<Edit> move(const PenSample& pen, const Scene& /*scene*/) override {
    const Vec displacement = curve_displacement(on_page(pen.position) - start_, offset_, mode_);
    if (displacement == displacement_) return std::nullopt;
    Result<Stroke> bent = pull_.at(displacement);
    if (!bent) return std::nullopt;  // keep the last valid shape
    displacement_ = displacement;
    shown_ = std::make_shared<const Stroke>(*std::move(bent));
    return stroke_.with(shown_, kLabel);
  }

  Edit end(const Scene& /*scene*/) override {
    Result<Stroke> done = pull_.finished(displacement_);
    if (!done || *done == *stroke_.before()) return {};
    return stroke_.with(std::make_shared<const Stroke>(*std::move(done)), kLabel);
  }

  [[nodiscard]] PullFeel feel() const override {
    return {.kind = PullFeel::Kind::kSpring, .origin = start_};
  }

  void draw(Overlay& overlay) const override {
    const bool moved = displacement_ != Vec{};
    // Only a moved stroke is drawn, because the snapshot may have fewer joints than the strokes
    // made by at().
    if (moved) {
      add_span(overlay, *shown_, pull_.first_joint(), pull_.last_joint(), Overlay::Role::kSpan);
    }
    const Point from = pull_.origin(), to = from + displacement_;
    overlay.dots.push_back({to, Overlay::Role::kHandle});
    if (!moved) return;
    overlay.lines.push_back({from, to, Overlay::Role::kVector});
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f mm", norm(displacement_));
    overlay.labels.push_back({to, text.data()});
  }

 private:
  static constexpr const char* kLabel = "Pull";

  StrokeReplacement stroke_;
  GrabPull pull_;
  Point start_;
  Vec offset_;  // from the curve to the pen, at the touch
  TouchOffset mode_;
  Vec displacement_{};
  StrokePtr shown_;
};

}  // namespace

std::unique_ptr<PullGesture> make_grab(const PenSample& touch, const Scene& scene,
                                       const StrokeHit& hit, const GrabOptions& options,
                                       TouchOffset offset) {
  return std::make_unique<GrabGesture>(touch, scene, hit, options, offset);
}

}  // namespace felt
