#include "felt/tools/pull/sweep_gesture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/document/edit_builder.h"
#include "felt/tools/pull/sweep_pull.h"

namespace felt {
namespace {

constexpr const char* kRedrawLabel = "Redraw";

/// Time step in which the path of the pen is processed, so that the sample rate has no effect.
constexpr double kStepNs = 1e6;
/// Maximum number of steps per sample. After a longer pause the steps are longer.
constexpr double kMaxSweepSteps = 50.0;

class SweepGesture final : public PullGesture {
 public:
  SweepGesture(const PenSample& touch, const Scene& scene, const StrokeHit& hit,
               const SweepOptions& options)
      : stroke_(scene.document, hit.stroke),
        sweep_(stroke_.before(), hit.u, options.weights),
        shown_(stroke_.before()),
        time_constant_ns_(1e9 * options.time_constant_s),
        last_(on_page(touch.position)),
        last_ns_(touch.time_ns),
        stepped_(last_),
        stepped_ns_(touch.time_ns) {}

  std::optional<Edit> move(const PenSample& pen, const Scene& /*scene*/) override {
    const Point now = on_page(pen.position);
    // Computed in double, because the difference of two invalid times may overflow 64 bits.
    const double passed = static_cast<double>(pen.time_ns) - static_cast<double>(last_ns_);
    const SweepPull before = sweep_;
    const bool moved = passed > 0.0 && walk(now, passed);
    last_ = now;
    last_ns_ = pen.time_ns;
    if (!moved) return std::nullopt;
    Result<Stroke> stroke = sweep_.stroke();
    if (!stroke) {  // keep the last valid shape
      sweep_ = before;
      return std::nullopt;
    }
    shown_ = std::make_shared<const Stroke>(*std::move(stroke));
    return stroke_.with(shown_, kRedrawLabel);
  }

  Edit end(const Scene& /*scene*/) override {
    if (shown_ == stroke_.before()) return {};
    Result<Stroke> done = sweep_.finished();
    if (done) shown_ = std::make_shared<const Stroke>(*std::move(done));
    return stroke_.with(shown_, kRedrawLabel);
  }

  [[nodiscard]] PullFeel feel() const override {
    PullFeel feel{.kind = PullFeel::Kind::kSweep, .curve = sweep_.near(), .leaps = sweep_.leaps()};
    feel.curve.pen = stepped_;
    feel.curve.time_ns = stepped_ns_;
    return feel;
  }

  void draw(Overlay& overlay) const override {
    const Point at = sweep_.point();
    const int segment = sweep_.place().segment;
    if (segment < shown_->segment_count()) {
      add_span(overlay, *shown_, segment, segment + 1, Overlay::Role::kSpan);
    }
    overlay.dots.push_back({at, Overlay::Role::kHandle});
    overlay.lines.push_back({at, last_, Overlay::Role::kTether});
  }

 private:
  /// Processes the path from the last sample to this one, in time steps counted from the touch.
  bool walk(Point now, double passed_ns) {
    const double step = std::max(kStepNs, passed_ns / kMaxSweepSteps);
    const double part = 1.0 - std::exp(-step / time_constant_ns_);
    bool moved = false;
    double at = next_ns_;  // time since the last sample, ns
    for (; at <= passed_ns; at += step) {
      stepped_ = lerp(last_, now, at / passed_ns);
      // Clamped in double, because the sum of invalid times may overflow 64 bits.
      constexpr double kMaxNs = 9.2e18;
      stepped_ns_ = static_cast<std::int64_t>(
          std::clamp(static_cast<double>(last_ns_) + at, -kMaxNs, kMaxNs));
      moved = sweep_.step(stepped_, part) || moved;
    }
    next_ns_ = at - passed_ns;
    return moved;
  }

  StrokeReplacement stroke_;
  SweepPull sweep_;
  StrokePtr shown_;
  double time_constant_ns_;
  Point last_;
  std::int64_t last_ns_;
  double next_ns_ = kStepNs;  // time from the last sample to the next step
  Point stepped_;             // position and time of the pen at the last step
  std::int64_t stepped_ns_;
};

}  // namespace

std::unique_ptr<PullGesture> make_sweep(const PenSample& touch, const Scene& scene,
                                        const StrokeHit& hit, const SweepOptions& options) {
  return std::make_unique<SweepGesture>(touch, scene, hit, options);
}

}  // namespace felt
