#include "felt/validate/validator.h"

#include <array>
#include <charconv>
#include <cmath>

#include "felt/validate/checks.h"

namespace felt {
namespace {

constexpr std::array<Check, 15> kChecks{{
    {"openings", 1, "opens and closes", check_openings},
    {"identity", 2, "reports its identity", check_identity},
    {"capabilities", 2, "reports its capabilities", check_capabilities},
    {"rate", 3, "keeps its rate", check_rate},
    {"sample_times", 3, "samples in order of time", check_sample_times},
    {"places", 4, "plausible positions", check_places},
    {"noise", 4, "low noise at rest", check_noise},
    {"force_felt", 5, "force arrives", check_force_felt},
    {"force_sign", 5, "pushes in the right direction", check_force_sign},
    {"step", 6, "follows a step of force", check_step},
    {"limits", 7, "force limits hold", check_limits},
    {"engaging", 7, "forces start gently", check_engaging},
    {"watchdog", 8, "switches off without commands", check_watchdog},
    {"unplugging", 9, "survives unplugging", check_unplugging},
    {"soak", 10, "long run without faults", check_soak},
}};

constexpr const char* kConsent =
    "The next checks push with up to 0.3 N, about the weight of 30 grams. Hold the pen loosely all "
    "the time, and keep your face and objects away from it. Ctrl-C switches the force off at any "
    "time.";

bool is_cancelled(const ValidationOptions& options) {
  return options.is_cancelled && options.is_cancelled();
}

}  // namespace

std::span<const Check> all_checks() noexcept {
  return kChecks;
}

Result<std::unique_ptr<Trial>> CheckContext::begin() {
  if (subject.device() == nullptr) {
    if (Result<void> opened = subject.open(); !opened) return tl::unexpected(opened.error());
  }
  if (OpenDevice& device = *subject.device(); device.homing() != Homing::kNone) {
    if (!person.does(PersonTask::kFindHome, device.homing_words())) {
      return fail(ErrorCode::kUnsupported,
                  "it must find its home position first, which needs your consent");
    }
    if (Result<void> home = device.find_home(); !home) return tl::unexpected(home.error());
  }
  return Trial::begin(subject, loop, options.is_cancelled);
}

std::string CheckContext::refusal() {
  const Device* device = subject.device();
  if (device != nullptr && !device->capabilities().has_force()) return "it cannot produce force";
  if (!agreed) agreed = person.does(PersonTask::kAgreeToForces, kConsent);
  return *agreed ? "" : "forces were not agreed to";
}

std::optional<int> CheckContext::best_axis() const {
  if (!pushes) return std::nullopt;
  int best = 0;
  for (int axis = 1; axis < 3; ++axis) {
    const auto moved = [this](int i) { return norm((*pushes)[static_cast<std::size_t>(i)].moved); };
    if (moved(axis) > moved(best)) best = axis;
  }
  return best;
}

double Series::deviation() const noexcept {
  if (count < 2.0) return 0.0;
  return std::sqrt(std::max(0.0, (squares - sum * sum / count) / (count - 1.0)));
}

double Series::error() const noexcept {
  return count > 0.0 ? deviation() / std::sqrt(count) : 0.0;
}

std::string figure(double value, int digits) {
  std::array<char, 64> text{};
  if (!(std::abs(value) < 1e15)) return std::isnan(value) ? "nan" : "infinite";
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, digits);
  return {text.data(), end.ptr};
}

Force along(int axis, double newtons) noexcept {
  return {axis == 0 ? newtons : 0.0, axis == 1 ? newtons : 0.0, axis == 2 ? newtons : 0.0};
}

double component(const Vec3& v, int axis) noexcept {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

const char* axis_name(int axis) noexcept {
  static constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
  return kNames[static_cast<std::size_t>(axis) % 3];
}

CheckOutcome broken(const Trial& trial) {
  return {trial.was_cancelled() ? Verdict::kNotRun : Verdict::kNotPossible, {}, trial.trouble()};
}

ValidationReport validate(TestSubject& subject, TestLoop& loop, TestPerson& person,
                          const ValidationOptions& options) {
  ValidationReport report;
  report.program = options.program;
  report.device = subject.descriptor();
  report.seed = options.seed;
  report.level = options.level;
  CheckContext context{subject, loop, person, options, std::mt19937_64(options.seed)};
  for (const Check& check : all_checks()) {
    if (check.level > options.level) continue;
    CheckResult result{check.id, check.level, check.title, Verdict::kNotRun, {}, {}};
    if (!is_cancelled(options)) {
      if (options.on_begin) options.on_begin(result);
      CheckOutcome outcome = check.run(context);
      result.verdict = outcome.verdict;
      result.measured = std::move(outcome.measured);
      result.words = std::move(outcome.words);
      if (options.on_end) options.on_end(result);
    }
    report.checks.push_back(std::move(result));
  }
  report.was_interrupted = is_cancelled(options);
  if (subject.device() != nullptr) report.device = subject.descriptor();
  subject.close();
  report.loop = loop.words();
  return report;
}

}  // namespace felt
