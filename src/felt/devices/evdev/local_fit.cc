#include "felt/devices/evdev/local_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace felt {
namespace {

// The unknowns are force, stiffness and friction.
constexpr std::size_t kUnknowns = 3;
using Row = std::array<double, kUnknowns>;

constexpr double kSlowMmPerS = 5.0;  // below this speed the sign of the motion is unreliable
constexpr double kNoiseN = 0.02;     // expected residual of the force law
// The typical size of each unknown: N, N/mm, N.
constexpr Row kUsual{0.3, 1.0, 1.0};

double sign_of(double speed_mm_per_s) noexcept {
  return speed_mm_per_s / (std::abs(speed_mm_per_s) + kSlowMmPerS);
}

struct Sums {
  std::array<Row, kUnknowns> squares{};
  Row force{};
};

/// Solves the normal equations for the wanted unknowns by Cholesky decomposition. The
/// regularisation, which sums_of() adds to the diagonal, makes the matrix positive definite.
Row solve(const Sums& sums, const std::array<bool, kUnknowns>& wanted) noexcept {
  std::array<Row, kUnknowns> lower{};
  Row result{};
  Row half{};
  for (std::size_t i = 0; i < kUnknowns; ++i) {
    if (!wanted[i]) continue;
    for (std::size_t j = 0; j <= i; ++j) {
      if (!wanted[j]) continue;
      double rest = sums.squares[i][j];
      for (std::size_t k = 0; k < j; ++k) rest -= lower[i][k] * lower[j][k];
      lower[i][j] = i == j ? std::sqrt(std::max(rest, 1e-12)) : rest / lower[j][j];
    }
    double rest = sums.force[i];
    for (std::size_t k = 0; k < i; ++k) rest -= lower[i][k] * half[k];
    half[i] = rest / lower[i][i];
  }
  for (std::size_t i = kUnknowns; i-- > 0;) {
    if (!wanted[i]) continue;
    double rest = half[i];
    for (std::size_t k = i + 1; k < kUnknowns; ++k) rest -= lower[k][i] * result[k];
    result[i] = rest / lower[i][i];
  }
  return result;
}

bool is_usable(const FitSample& s) noexcept {
  constexpr double kMax = 1e6;
  return std::abs(s.position_mm) < kMax && std::abs(s.speed_mm_per_s) < kMax &&
         std::abs(s.force_n) < kMax;  // false for NaN, too
}

/// Returns the normal equations of the regularised least-squares fit. Positions are relative to
/// `origin_mm`.
Sums sums_of(std::span<const FitSample> samples, double origin_mm) noexcept {
  Sums sums;
  for (std::size_t i = 0; i < kUnknowns; ++i) {
    sums.squares[i][i] = (kNoiseN / kUsual[i]) * (kNoiseN / kUsual[i]);
  }
  const double forget = std::exp(-std::log(3.0) / kFitForgets);
  double weight = 1.0;
  for (std::size_t at = samples.size(); at-- > 0; weight *= forget) {
    const FitSample& s = samples[at];
    if (!is_usable(s)) continue;
    const Row row{1.0, origin_mm - s.position_mm, -sign_of(s.speed_mm_per_s)};
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      for (std::size_t j = 0; j < kUnknowns; ++j) sums.squares[i][j] += weight * row[i] * row[j];
      sums.force[i] += weight * row[i] * s.force_n;
    }
  }
  return sums;
}

}  // namespace

// Fits force, stiffness and friction. If stiffness or friction is negative, removes it and fits the
// others again. If the stiffness exceeds the device's limit, sets it to that limit and fits the
// others again. Last, adjusts force and friction so that the force law passes through the newest
// sample.
AxisFit fit_axis(std::span<const FitSample> samples, const FitAbility& can) noexcept {
  const auto newest = std::find_if(samples.rbegin(), samples.rend(), is_usable);
  if (newest == samples.rend()) return {};
  AxisFit fit;
  fit.position_mm = newest->position_mm;
  Sums sums = sums_of(samples, fit.position_mm);
  std::array<bool, kUnknowns> wanted{true, can.spring, can.friction};
  Row law = solve(sums, wanted);
  for (int round = 0; round < 2 && (law[1] < 0.0 || law[2] < 0.0); ++round) {
    wanted[law[1] < law[2] ? 1 : 2] = false;  // the more negative unknown, which would add energy
    law = solve(sums, wanted);
  }
  if (law[1] > can.max_stiffness_n_per_mm) {
    // Uses the device's largest stiffness, and fits the other unknowns again.
    law[1] = std::max(can.max_stiffness_n_per_mm, 0.0);
    for (std::size_t i = 0; i < kUnknowns; ++i) sums.force[i] -= sums.squares[i][1] * law[1];
    const double stiffness = law[1];
    wanted[1] = false;
    law = solve(sums, wanted);
    law[1] = stiffness;
  }
  fit.stiffness_n_per_mm = std::max(law[1], 0.0);
  // Limits the friction to the part of the newest force that opposes the motion. Then the force of
  // the law exceeds the newest force by at most a quarter, whatever the direction of the motion.
  const double against_n = -newest->force_n * sign_of(newest->speed_mm_per_s);
  fit.friction_n = std::clamp(law[2], 0.0, std::max(against_n, 0.0));
  fit.force_n = newest->force_n + fit.friction_n * sign_of(newest->speed_mm_per_s);
  return fit;
}

}  // namespace felt
