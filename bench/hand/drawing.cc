#include "drawing.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "felt/base/constants.h"
#include "felt/devices/simulated/feedback_hand.h"
#include "felt/devices/simulated/hand_path.h"
#include "felt/devices/simulated/held_body.h"
#include "felt/devices/simulated/towed_plan.h"
#include "felt/haptics/bricks/friction.h"
#include "felt/haptics/bricks/plane.h"
#include "felt/haptics/bricks/stabiliser.h"

namespace felt::bench {
namespace {

constexpr double kTickS = 0.001;
constexpr std::size_t kWindow = 200;  // points of the path around the pen that are searched

StylusPreset device(const Condition& condition = {}) {
  StylusPreset device = *find_stylus_preset("premium");
  if (condition.device_friction_n) device.mechanics.friction_n = *condition.device_friction_n;
  return device;
}

// Follows a pen along a path. Searches only near the last position, so that a path that crosses
// itself does not mislead it.
class PathFollower {
 public:
  explicit PathFollower(std::span<const Point> path) : path_(path) {}

  // Returns the vector from the nearest point of the path to `p`.
  Vec error(Point p) {
    const std::size_t from = at_ > kWindow ? at_ - kWindow : 0;
    const std::size_t count = std::min(path_.size() - from, 2 * kWindow);
    std::size_t best = from;
    for (std::size_t i = from; i < from + count; ++i) {
      if (norm_squared(path_[i] - p) < norm_squared(path_[best] - p)) best = i;
    }
    at_ = best;
    return p - path_[best];
  }
  [[nodiscard]] Point end() const { return path_.back(); }
  [[nodiscard]] Vec direction() const {
    const std::size_t before = at_ > 0 ? at_ - 1 : 0, after = std::min(at_ + 1, path_.size() - 1);
    return normalized(path_[after] - path_[before]);
  }

 private:
  std::span<const Point> path_;
  std::size_t at_ = 0;
};

// Returns the share of the variance above a frequency, in cycles per value.
double share_above(std::span<const double> values, double cycles) {
  const std::size_t n = values.size();
  double mean = 0.0, variance = 0.0, slow = 0.0;
  for (const double v : values) mean += v / static_cast<double>(n);
  for (const double v : values) variance += (v - mean) * (v - mean) / static_cast<double>(n);
  if (!(variance > 0.0)) return 0.0;
  for (std::size_t k = 1; static_cast<double>(k) <= cycles * static_cast<double>(n); ++k) {
    std::complex<double> sum;
    for (std::size_t i = 0; i < n; ++i) {
      const double turn = -kTau * static_cast<double>(k * i % n) / static_cast<double>(n);
      sum += (values[i] - mean) * std::polar(1.0, turn);
    }
    slow += 2.0 * std::norm(sum / static_cast<double>(n));
  }
  return std::max(0.0, 1.0 - slow / variance);
}

// The stylus in the hand of a person, and the forces of a condition.
class Scene {
 public:
  Scene(const Person& person, const Condition& condition, std::span<const Point> path,
        const Tablet& tablet)
      : condition_(condition),
        tablet_(tablet),
        hand_(device(condition), person),
        path_(path),
        friction_({.coefficient = condition.friction}) {
    memory_.dt_s = memory_.period_s = kTickS;
    options_ = script_options_for(device(), person.grip());
    options_.device_mass_kg = options_.device_friction_n = options_.friction = 0.0;  // FeedbackHand
    options_.plane_n_per_m = PlaneOptions{}.stiffness_n_per_m;
    // In the air the hand has nothing to press against, and draws at the height of the path.
    if (condition.in_air) options_.contact = ContactBy::kPressure;
  }

  Drawing draw(const RecordedPath& plan) {
    const std::vector<TimedAim> aims = script_hand(std::span(&plan, 1), options_);
    Drawing drawing;
    const auto extra = static_cast<std::size_t>((hand_.person().preview_s + 0.1) / kTickS);
    const auto late = static_cast<std::size_t>(hand_.person().preview_s / kTickS);
    for (std::size_t i = 0; i < aims.size() + extra; ++i) {
      const TimedAim& aim = aims[std::min(i, aims.size() - 1)];
      draws_in_air_ = condition_.in_air && i >= late &&
                      aims[std::min(i - late, aims.size() - 1)].pressure.value_or(0.0) > 0.0;
      tick(static_cast<std::int64_t>(i) * kMs, aim, drawing);
    }
    finish(drawing);
    drawing.simulated_s = kTickS * static_cast<double>(aims.size() + extra);
    return drawing;
  }

 private:
  void tick(std::int64_t now_ns, const TimedAim& aim, Drawing& drawing) {
    hand_.aim(aim.target_mm, aim.pressure, 0);
    const PenSample sample = hand_.read(now_ns).value();
    memory_.begin_tick(kTickS);
    Force force = condition_.in_air ? Force{} : Plane()(sample, memory_);
    if (condition_.friction > 0.0) force += friction_(sample, memory_);
    Point ink = on_page(sample.position);
    if (condition_.towed) {
      force += tow_(sample, memory_);
      if (memory_.nib.is_set) ink = memory_.nib.position;
    }
    if (condition_.in_air ? draws_in_air_ : in_contact(sample)) {
      const Vec error = path_.error(ink);
      const Vec across = perp(path_.direction());
      const Vec off = dot(error, across) * across;
      if (condition_.towed) hand_.see(off);
      if (condition_.guide_n_per_m > 0.0) force += guide(off);
      measure(error, dot(error, across), condition_.in_air ? sample.position.z : 0.0, ink, drawing);
      record(now_ns, ink, drawing);
    }
    static_cast<void>(hand_.write(force));
  }

  [[nodiscard]] Force guide(Vec off) const {
    const double size = norm(off);
    if (size == 0.0) return {};
    const double pull = std::min(kMPerMm * condition_.guide_n_per_m * size, condition_.guide_n);
    return {-pull * off.x / size, -pull * off.y / size, 0.0};
  }

  void measure(Vec error, double across_mm, double depth_mm, Point ink, Drawing& drawing) {
    drawing.plane_error_mm += norm(error);
    drawing.total_error_mm += std::hypot(norm(error), depth_mm);
    drawing.depth_mm += std::abs(depth_mm);
    drawing.end_error_mm = distance(ink, path_.end());
    across_.push_back(across_mm);
  }

  void finish(Drawing& drawing) const {
    const auto count = static_cast<double>(std::max<std::size_t>(1, across_.size()));
    drawing.plane_error_mm /= count;
    drawing.total_error_mm /= count;
    drawing.depth_mm /= count;
    drawing.fast_share = share_above(across_, 4.0 * kTickS);
  }

  void record(std::int64_t now_ns, Point ink, Drawing& drawing) {
    if (began_ns_ < 0) began_ns_ = next_ns_ = now_ns;
    drawing.duration_s = 1e-9 * static_cast<double>(now_ns - began_ns_);
    if (now_ns < next_ns_) return;
    next_ns_ += std::llround(1e9 * tablet_.interval_s);
    if (next_ns_ <= now_ns) next_ns_ = now_ns + 1;
    const auto rounded = [this](double x) {
      return tablet_.step_mm * std::round(x / tablet_.step_mm);
    };
    drawing.ink.push_back({.time_ns = now_ns - began_ns_,
                           .position = {rounded(ink.x), rounded(ink.y)},
                           .contact = true});
  }

  Condition condition_;
  Tablet tablet_;
  FeedbackHand hand_;
  HandScriptOptions options_;
  PathFollower path_;
  Friction friction_;
  Towed tow_;
  ForceMemory memory_;
  bool draws_in_air_ = false;
  std::vector<double> across_;  // signed distance of the ink from the path, mm, tick by tick
  std::int64_t began_ns_ = -1, next_ns_ = 0;
};

double distance_to(std::span<const Point> line, Point p) {
  double nearest = norm_squared(line.front() - p);
  for (const Point q : line) nearest = std::min(nearest, norm_squared(q - p));
  return std::sqrt(nearest);
}

// Returns the mean distance from ink to path and from path to ink.
double error_of(const std::vector<TrialSample>& ink, std::span<const Point> path) {
  std::vector<Point> line, ideal;
  for (const TrialSample& sample : ink) line.push_back(sample.position);
  for (std::size_t i = 0; i < path.size(); i += 4) ideal.push_back(path[i]);
  double sum = 0.0;
  for (const Point p : line) sum += distance_to(ideal, p);
  for (const Point p : ideal) sum += distance_to(line, p);
  return sum / static_cast<double>(line.size() + ideal.size());
}

// With a nib that follows late, a person corrects more calmly, so that the crossover frequency
// times the delay stays the same (McRuer, Jex, IEEE Trans HFE 8, 1967).
double calmer(const Person& person, const RecordedPath& nib, const TowOptions& rope) {
  double length = 0.0;
  for (std::size_t i = 1; i < nib.size(); ++i) {
    length += distance(nib[i - 1].position, nib[i].position);
  }
  const double speed = length / (kTickS * static_cast<double>(nib.size()));
  const double delay_s = person.eye_delay_s + 2.0 * person.muscle_lag_s;
  return delay_s / (delay_s + rope.rope_mm / std::max(speed, 1.0));
}

}  // namespace

Drawing draw(const Person& person, std::span<const Point> via, const Condition& condition,
             std::uint64_t trial, const Tablet& tablet) {
  const std::vector<Point> path = smooth_path(via);
  const double friction_n = condition.device_friction_n.value_or(0.05);
  Person drawer = condition.in_air ? in_the_air(person) : on_a_plane(person, friction_n);
  RecordedPath plan = plan_movement(drawer, via, trial, condition.tunnel_mm);
  if (condition.towed) {
    drawer.eye_gain_per_s *= calmer(drawer, plan, TowOptions());
    plan = ahead_by_rope(plan, TowOptions());
  }
  drawer.seed += 7919 * (trial + 1);
  Drawing drawing = Scene(drawer, condition, path, tablet).draw(plan);
  drawing.error_mm = error_of(drawing.ink, path);
  return drawing;
}

std::vector<double> pulse_response(const Person& person, double force_n, double pulse_s) {
  FeedbackHand hand(device(), person);
  std::vector<double> moved;
  const double settle_s = 1.0;
  double start = 0.0;
  for (int i = 0; i < 1500; ++i) {
    hand.aim({100.0, 100.0, 4.0}, {}, 0);
    static_cast<void>(hand.read(i * kMs));
    const double t = kTickS * i - settle_s;
    const double x = hand.stylus().body().position().x;
    if (t < 0.0) {
      start = x;
    } else {
      moved.push_back(x - start);
    }
    static_cast<void>(hand.write(t >= 0.0 && t < pulse_s ? Force{force_n, 0.0, 0.0} : Force{}));
  }
  return moved;
}

}  // namespace felt::bench
