#pragma once

#include <array>
#include <memory>
#include <optional>
#include <random>
#include <span>
#include <string>

#include "felt/validate/trial.h"
#include "felt/validate/validator.h"

namespace felt {

/// The response of the pen to a small force along an axis; the mean over several pushes.
struct PushResponse {
  Vec3 moved{};              ///< mm, displacement from a push in -axis to a push in +axis
  double uncertainty = 0.0;  ///< mm, standard error of `moved`
};

/// Forces below this count as zero.
inline constexpr double kEpsilonN = 1e-6;

/// State shared by the checks: the device, and results of earlier checks.
struct CheckContext {
  TestSubject& subject;
  TestLoop& loop;
  TestPerson& person;
  const ValidationOptions& options;
  std::mt19937_64 random;
  std::optional<bool> agreed = {};  ///< whether the user agreed to forces; unset if not asked yet
  std::optional<std::array<PushResponse, 3>> pushes = {};
  bool pushed_in_circles = false;
  bool is_noisy = false;  ///< if true, energies computed from positions are meaningless

  /// Opens the device, homes it if necessary, and starts a trial in the loop.
  Result<std::unique_ptr<Trial>> begin();
  /// Returns the reason why forces are not possible: the device has no forces, or the user did not
  /// agree (asks once). Empty if forces are possible.
  std::string refusal();
  /// Returns the axis along which forces move the pen most, or nullopt if that was not measured.
  [[nodiscard]] std::optional<int> best_axis() const;
};

struct CheckOutcome {
  Verdict verdict = Verdict::kPassed;
  std::string measured = {};
  std::string words = {};
};

struct Check {
  const char* id;
  int level;
  const char* title;
  CheckOutcome (*run)(CheckContext&);
};

/// Returns all checks in the order in which they run.
std::span<const Check> all_checks() noexcept;

// Levels 1 to 4: checks_sensing.cc
CheckOutcome check_openings(CheckContext& context);
CheckOutcome check_identity(CheckContext& context);
CheckOutcome check_capabilities(CheckContext& context);
CheckOutcome check_rate(CheckContext& context);
CheckOutcome check_sample_times(CheckContext& context);
CheckOutcome check_places(CheckContext& context);
CheckOutcome check_noise(CheckContext& context);
// Levels 5 and 6: checks_pushing.cc
CheckOutcome check_force_felt(CheckContext& context);
CheckOutcome check_force_sign(CheckContext& context);
CheckOutcome check_step(CheckContext& context);
// Levels 7 and 8: checks_safety.cc
CheckOutcome check_limits(CheckContext& context);
CheckOutcome check_engaging(CheckContext& context);
CheckOutcome check_watchdog(CheckContext& context);
// Levels 9 and 10: checks_lasting.cc
CheckOutcome check_unplugging(CheckContext& context);
CheckOutcome check_soak(CheckContext& context);

/// A sum of values and of their squares, for mean and deviation.
struct Series {
  double count = 0.0, sum = 0.0, squares = 0.0;
  void add(double value) noexcept { count += 1.0, sum += value, squares += value * value; }
  [[nodiscard]] double mean() const noexcept { return count > 0.0 ? sum / count : 0.0; }
  [[nodiscard]] double deviation() const noexcept;  ///< standard deviation of one value
  [[nodiscard]] double error() const noexcept;      ///< standard error of the mean
};

/// Formats a value with a fixed number of digits after the point: "0.12".
std::string figure(double value, int digits);
/// Returns a force of `newtons` N along axis 0, 1 or 2.
Force along(int axis, double newtons) noexcept;
double component(const Vec3& v, int axis) noexcept;
const char* axis_name(int axis) noexcept;

inline CheckOutcome passed(std::string measured) {
  return {Verdict::kPassed, std::move(measured)};
}
inline CheckOutcome failed(std::string measured, std::string words) {
  return {Verdict::kFailed, std::move(measured), std::move(words)};
}
inline CheckOutcome not_possible(std::string words, std::string measured = {}) {
  return {Verdict::kNotPossible, std::move(measured), std::move(words)};
}
/// Returns the outcome of a check whose trial could not continue.
CheckOutcome broken(const Trial& trial);

}  // namespace felt
