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

/// What the forces of a check did, mean over its pushes.
struct PushResponse {
  Vec3 moved{};              ///< mm, from a push in - to one in +, per direction of the push
  double uncertainty = 0.0;  ///< mm, standard error of it
};

/// Forces below this are none.
inline constexpr double kEpsilonN = 1e-6;

/// What checks share: the device, and what earlier ones found.
struct CheckContext {
  TestSubject& subject;
  TestLoop& loop;
  TestPerson& person;
  const ValidationOptions& options;
  std::mt19937_64 random;
  std::optional<bool> agreed = {};  ///< to forces
  std::optional<std::array<PushResponse, 3>> pushes = {};
  bool pushed_in_circles = false;
  bool is_noisy = false;  ///< so that energies, which places tell, mean nothing

  /// An open device that knows where it is, in the loop.
  Result<std::unique_ptr<Trial>> begin();
  /// The same with forces allowed: words why not, else empty.
  std::string refusal();
  /// The axis along which forces move it most; none where they do not, or it was not measured.
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

/// In the order in which they are done.
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

/// Sum of squares and the like.
struct Series {
  double count = 0.0, sum = 0.0, squares = 0.0;
  void add(double value) noexcept { count += 1.0, sum += value, squares += value * value; }
  [[nodiscard]] double mean() const noexcept { return count > 0.0 ? sum / count : 0.0; }
  [[nodiscard]] double deviation() const noexcept;  ///< of one
  [[nodiscard]] double error() const noexcept;      ///< of the mean
};

/// "0.12": fixed, so many digits after the point.
std::string figure(double value, int digits);
/// The unit vector of axis 0, 1, 2, as a force.
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
/// What a trial that could not go on comes to.
CheckOutcome broken(const Trial& trial);

}  // namespace felt
