#include "felt/devices/simulated/person.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/devices/simulated/hand_path.h"

namespace felt {
namespace {

constexpr double kGripNPerMPerN = 190.0;  // stiffness of the fingers per newton of grip
constexpr double kGripDampingPerN = 4.0;  // N s/m per newton of grip

constexpr double kPlanStepS = 0.001;
constexpr double kDotDurationS = 0.06;       // of a dot
constexpr int kMuscleReach = 35;             // steps
constexpr double kUsualSpeed = 40.0;         // mm/s in a circle of 1 mm
constexpr double kMinCurvature = 0.01;       // 1/mm
constexpr double kCornerCurvature = 4.0;     // 1/mm: a corner is passed like an arc of 0.25 mm
constexpr double kCornerTurn = 0.6;          // radians within one step of the path
constexpr double kCurvatureReachMm = 0.5;    // curvature is measured over this to each side
constexpr double kLandingSpeed = 6.0;        // mm/s when the pen touches and leaves the surface
constexpr double kMaxAcceleration = 2500.0;  // mm/s^2
constexpr std::size_t kVariationTones = 6;
constexpr double kMaxVariation = 1.5;  // of ln(speed): a factor of 4.5

constexpr double kSlopeShare = 0.3;  // 3 % instead of 10 % of the force
// A stiffer hand lets more of the variation of the planned speed through. Fitted, as the rhythm
// itself.
constexpr double kRestingRhythm = 0.85;
constexpr double kDepthShare = 2.65;  // depth in the air, compared with the error across the path
constexpr double kSmoothFrictionN = 0.05;  // of the tablets on which the pace was fitted

// Returns how many times longer a person takes on a plane with this friction than in the air.
constexpr double care_at(double friction_n) noexcept {
  return 1.14 + 0.4 * friction_n;
}

// Draws from a log-normal distribution, limited to two standard deviations.
double log_normal(Random& random, double median, double deviation) {
  return median * std::exp(deviation * std::clamp(random.normal(), -2.0, 2.0));
}

// A slow random variation of the logarithm of the speed: sines around the rhythm of the person.
class Variation {
 public:
  Variation(const Person& person, Random& random) {
    for (Tone& tone : tones_) {
      tone = {kTau * person.rhythm_hz * random.between(0.4, 1.4), random.between(0.0, kTau)};
    }
    amplitude_ = person.scatter * std::sqrt(2.0 / double(kVariationTones));
  }
  [[nodiscard]] double at(double t_s) const {
    double sum = 0.0;
    for (const Tone& tone : tones_) sum += std::sin(tone.radians_per_s * t_s + tone.phase);
    return std::clamp(amplitude_ * sum, -kMaxVariation, kMaxVariation);
  }

 private:
  struct Tone {
    double radians_per_s, phase;
  };
  std::array<Tone, kVariationTones> tones_{};
  double amplitude_ = 0.0;
};

// Returns the curvature at every point of a path, 1/mm.
std::vector<double> curvatures(std::span<const Point> path) {
  std::vector<double> along(path.size());
  for (std::size_t i = 1; i < path.size(); ++i) {
    along[i] = along[i - 1] + distance(path[i - 1], path[i]);
  }
  std::vector<double> curvature(path.size());
  std::size_t from = 0, to = 0;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const double reach = std::min({kCurvatureReachMm, along[i], along.back() - along[i]});
    while (from + 1 < i && along[from + 1] <= along[i] - reach) ++from;
    to = std::max(to, i + 1);
    while (to + 1 < path.size() && along[to] < along[i] + reach) ++to;
    const double turn = angle_between(path[i] - path[from], path[to] - path[i]);
    curvature[i] = 2.0 * turn / (along[to] - along[from]);
    const double corner = angle_between(path[i] - path[i - 1], path[i + 1] - path[i]);
    if (corner > kCornerTurn) curvature[i] = std::max(curvature[i], kCornerCurvature);
  }
  return curvature;
}

// Returns the speed that the person intends at every point, mm/s, without the random variation.
std::vector<double> speeds(const Person& person, std::span<const Point> path, double tunnel_mm) {
  const std::vector<double> curvature = curvatures(path);
  std::vector<double> speed(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    speed[i] = person.pace * kUsualSpeed * std::pow(curvature[i] + kMinCurvature, -person.power);
    if (tunnel_mm > 0.0) speed[i] = std::min(speed[i], tunnel_mm / person.steering_s);
  }
  speed.front() = std::min(speed.front(), kLandingSpeed);
  speed.back() = std::min(speed.back(), kLandingSpeed);
  const auto reachable = [&](std::size_t from, std::size_t to) {
    const double gain = 2.0 * kMaxAcceleration * person.pace * distance(path[from], path[to]);
    return std::sqrt(speed[from] * speed[from] + gain);
  };
  for (std::size_t i = 1; i < path.size(); ++i) {
    speed[i] = std::min(speed[i], reachable(i - 1, i));
  }
  for (std::size_t i = path.size(); i-- > 1;) {
    speed[i - 1] = std::min(speed[i - 1], reachable(i, i - 1));
  }
  return speed;
}

}  // namespace

SimulatedHand Person::grip() const noexcept {
  return {.name = "person",
          .mass_kg = 0.0,
          .stiffness_n_per_m = kGripNPerMPerN * grip_n,
          .damping_n_s_per_m = kGripDampingPerN * grip_n};
}

Person person_of(std::uint64_t seed) {
  Random random(seed);
  const Person median;
  Person person{.seed = random.bits()};
  person.pace = log_normal(random, median.pace, 0.4);
  person.power = std::clamp(median.power + 0.09 * random.normal(), 0.0, 0.45);
  person.scatter = log_normal(random, median.scatter, 0.45);
  person.rhythm_hz = log_normal(random, median.rhythm_hz, 0.15);
  person.steering_s = log_normal(random, median.steering_s, 0.25);
  person.preview_s = random.between(0.2, 0.3);
  person.wander_mm = log_normal(random, median.wander_mm, 0.3);
  person.eye_delay_s = random.between(0.12, 0.15);
  person.eye_noise_mm = log_normal(random, median.eye_noise_mm, 0.3);
  person.eye_gain_per_s = log_normal(random, median.eye_gain_per_s, 0.2);
  person.arm_delay_s = random.between(0.03, 0.05);
  person.motor_noise = log_normal(random, median.motor_noise, 0.3);
  person.tremor_mm = log_normal(random, median.tremor_mm, 0.4);
  person.arm_kg = log_normal(random, median.arm_kg, 0.2);
  person.arm_n_per_m = log_normal(random, median.arm_n_per_m, 0.3);
  person.arm_n_s_per_m = log_normal(random, median.arm_n_s_per_m, 0.2);
  person.reflex_n_per_m = log_normal(random, median.reflex_n_per_m, 0.3);
  person.load_share = random.between(0.6, 0.95);
  person.grip_n = random.between(1.0, 3.0);
  return person;
}

std::string_view person_model_name(PersonModel model) noexcept {
  constexpr std::string_view kModelNames[] = {"proportional", "practised", "resting", "unsteady"};
  return kModelNames[static_cast<std::size_t>(model)];
}

std::optional<PersonModel> find_person_model(std::string_view name) noexcept {
  for (const PersonModel model : kPersonModels) {
    if (person_model_name(model) == name) return model;
  }
  return std::nullopt;
}

Person in_model(Person person, PersonModel model) noexcept {
  if (model == PersonModel::kProportional) return person;
  const bool is_unsteady = model == PersonModel::kUnsteady;
  person.motor_noise *= kSlopeShare;
  person.force_noise_n = is_unsteady ? 0.04 : 0.02;
  person.load_share = 1.0 - (is_unsteady ? 0.5 : 0.15) * (1.0 - person.load_share);
  person.knows_friction = true;
  person.caution = 1.0;
  person.depth_mm = kDepthShare * person.wander_mm;
  person.press_noise_n = 0.02;
  person.press_noise = 0.03;
  if (model != PersonModel::kPractised) {
    person.rest = 3.0;
    person.rhythm_hz *= kRestingRhythm;
    person.grip_n = 3.0;
  }
  return person;
}

Person in_the_air(Person person) noexcept {
  person.pace *= 1.0 + person.caution * (care_at(kSmoothFrictionN) - 1.0);
  return person;
}

Person on_a_plane(Person person, double friction_n) noexcept {
  const double slower = care_at(kSmoothFrictionN) / care_at(friction_n);
  person.pace *= 1.0 + person.caution * (slower - 1.0);
  return person;
}

Person led_by_a_guide(Person person, double gives_way) noexcept {
  const double share = 1.0 - std::clamp(gives_way, 0.0, 1.0);
  person.arm_n_per_m *= share;
  person.reflex_n_per_m *= share;
  person.load_share = 0.0;
  return person;
}

std::vector<Person> population(std::size_t count, std::uint64_t seed, PersonModel model) {
  std::vector<Person> people;
  Random random(seed);
  for (std::size_t i = 0; i < count; ++i)
    people.push_back(in_model(person_of(random.bits()), model));
  return people;
}

RecordedPath plan_movement(const Person& person, std::span<const Point> via, std::uint64_t trial,
                           double tunnel_mm) {
  std::vector<Point> finite;
  std::copy_if(via.begin(), via.end(), std::back_inserter(finite),
               [](Point p) { return is_finite(p); });
  if (finite.empty()) return {};
  Random random(person.seed ^ (0x9e3779b97f4a7c15ULL * (trial + 1)));
  const Variation variation(person, random);
  const std::vector<Point> path = smooth_path(finite);
  const std::vector<double> speed = speeds(person, path, tunnel_mm);
  std::vector<TimedPoint> timed;
  double t_s = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0) {
      const double mean = 0.5 * (speed[i - 1] + speed[i]) * std::exp(variation.at(t_s));
      t_s += distance(path[i - 1], path[i]) / mean;
    }
    timed.push_back({path[i], t_s});
  }
  // The movement begins and ends at rest, so that the muscles reach both ends.
  std::vector<Point> plan = at_equal_times(timed, kPlanStepS, kDotDurationS);
  plan.insert(plan.begin(), kMuscleReach, plan.front());
  plan.insert(plan.end(), kMuscleReach, plan.back());
  RecordedPath movement;
  for (const Point p : through_muscles(plan, kMuscleReach)) {
    const auto i = static_cast<std::int64_t>(movement.size());
    movement.push_back({.position = p, .time_ns = i * kMs});
  }
  return movement;
}

}  // namespace felt
