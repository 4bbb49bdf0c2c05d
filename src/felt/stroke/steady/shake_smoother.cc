#include "felt/stroke/steady/shake_smoother.h"

#include <algorithm>
#include <cmath>

#include "felt/base/constants.h"

namespace felt {
namespace {

/// Chosen on one half of the strokes of bench/steady, as in ShakeFilter.
constexpr double kNoiseMm2 = 1e-4;      // of a measured position
constexpr double kShakeDecayS = 2.5;    // in which a shaking forgets its phase
constexpr double kJerkWindowS = 0.014;  // over which the jerk is averaged
constexpr double kTurnWindowS = 0.25;   // over which the frequency is averaged
/// What is assumed counts as much as this number of seen values (jerk, nodes of shaking) or this
/// share of the window (frequency).
constexpr double kUsualJerk = 8000.0, kJerkCount = 0.5, kSwingCount = 100.0, kTurnCount = 0.15;
constexpr double kMaxDriftHz = 2.0;
/// Bounds that keep the equations well-conditioned.
constexpr double kMinJerk = 50.0, kMaxJerk = 1e7, kMaxSwing = 4.0;
constexpr double kTabletHz = 133.0;  // sample rate to which the jerk of ShakeModel belongs

double third_difference_variance(double jerk_mm_per_s3, double step_s) {
  return jerk_mm_per_s3 * jerk_mm_per_s3 / kTabletHz * std::pow(step_s, 5.0);
}

/// Replaces each value by the sum of all, weighted by exp(-distance/width) in both directions.
template <class T>
void blur(std::vector<T>& values, double width) {
  const double left = std::exp(-1.0 / width);
  std::vector<T> before(values.size());
  T sum{};
  for (std::size_t i = 0; i < values.size(); ++i) before[i] = sum = sum * left + values[i];
  sum = T{};
  for (std::size_t i = values.size(); i-- > 0;) {
    const T after = sum;
    sum = (sum + values[i]) * left;
    values[i] = before[i] + after;
  }
}

/// Adds the square of the third difference of x, times a weight, to the lower triangle of a matrix.
void add_third_difference(double (&m)[8][8], double weight) {
  constexpr std::array<std::size_t, 4> kX = {0, 3, 6, 7};
  constexpr std::array<double, 4> kThird = {-1.0, 3.0, -3.0, 1.0};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j <= i; ++j) m[kX[i]][kX[j]] += weight * kThird[i] * kThird[j];
  }
}

/// Returns the inverse of the first three rows and columns of a symmetric matrix, of which the
/// lower triangle is given, by its cofactors.
std::array<std::array<double, 3>, 3> inverse(const double (&m)[8][8]) {
  const double a = m[0][0], b = m[1][0], d = m[1][1], f = m[2][0], g = m[2][1], h = m[2][2];
  const double c00 = d * h - g * g, c01 = f * g - b * h, c02 = b * g - d * f;
  const double one = 1.0 / (a * c00 + b * c01 + f * c02);
  const double i01 = one * c01, i02 = one * c02, i12 = one * (b * f - a * g);
  return {{{one * c00, i01, i02},
           {i01, one * (a * h - f * f), i12},
           {i02, i12, one * (a * d - b * b)}}};
}

}  // namespace

ShakeSmoother::ShakeSmoother(std::span<const Vec> nodes, double step_s, double hz, Vec swing_mm)
    : nodes_(nodes),
      step_s_(step_s),
      angle_(kTau * hz * step_s),
      prior_{swing_mm.x * swing_mm.x, swing_mm.y * swing_mm.y},
      size_(prior_),
      decay_(std::exp(-step_s / kShakeDecayS)),
      jerk_(nodes.size()),
      turn_(nodes.size()),
      rotation_(nodes.size()),
      jerk_seen_(nodes.size()),
      turn_seen_(nodes.size()),
      equations_(nodes.size()),
      shaking_(nodes.size()) {}

std::span<const Vec> ShakeSmoother::shaking(const Start& start, int passes) {
  std::fill(jerk_.begin(), jerk_.end(), third_difference_variance(start.jerk_mm_per_s3, step_s_));
  std::fill(turn_.begin(), turn_.end(), kTau * start.hz * step_s_);
  size_ = prior_;
  for (int pass = 0; pass < passes; ++pass) {
    std::fill(jerk_seen_.begin(), jerk_seen_.end(), 0.0);
    std::fill(turn_seen_.begin(), turn_seen_.end(), 0.0);
    for (std::size_t k = 0; k < turn_.size(); ++k) rotation_[k] = std::polar(decay_, turn_[k]);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      eliminate(axis);
      substitute(axis);
    }
    if (pass + 1 == passes) break;
    learn_jerk();
    learn_frequency();
    learn_swing();
  }
  return shaking_;
}

/// Eliminates the unknowns of the nodes one after the other, from the equations of the least
/// squares m * unknowns = right. `left` and `left_right` are the equations that are left for the
/// front.
void ShakeSmoother::eliminate(std::size_t axis) {
  constexpr std::size_t kAll = kOwn + kFront;
  // Positions of the old front among the own unknowns and the new front.
  constexpr std::array<std::size_t, kFront> kMoved = {0, 1, 2, 3, 6};
  const std::size_t n = nodes_.size();
  const double sure = 1.0 / kNoiseMm2, steady = 1.0 / size_[axis];
  const double fresh = steady / (1.0 - decay_ * decay_);
  double left[kFront][kFront] = {}, left_right[kFront] = {};
  for (std::size_t k = 0; k < n; ++k) {
    double m[kAll][kAll] = {}, right[kAll] = {};  // the lower triangle
    if (k > 0) {
      for (std::size_t i = 0; i < kFront; ++i) {
        right[kMoved[i]] = left_right[i];
        for (std::size_t j = 0; j <= i; ++j) m[kMoved[i]][kMoved[j]] = left[i][j];
      }
    } else {
      m[1][1] = m[2][2] = steady;
    }
    const double y = axis == 0 ? nodes_[k].x : nodes_[k].y;
    m[0][0] += sure;
    m[1][0] += sure;
    m[1][1] += sure;
    right[0] += sure * y;
    right[1] += sure * y;
    if (k + 3 < n) add_third_difference(m, 1.0 / jerk_[k]);
    if (k + 1 < n) {
      const double c = fresh * rotation_[k].real(), s = fresh * rotation_[k].imag();
      m[1][1] += fresh * decay_ * decay_;
      m[2][2] += fresh * decay_ * decay_;
      m[4][4] += fresh;
      m[5][5] += fresh;
      m[4][1] -= c;
      m[4][2] += s;
      m[5][1] -= s;
      m[5][2] -= c;
    }
    Eliminated& e = equations_[k];
    e.covariance = inverse(m);
    for (std::size_t i = 0; i < kOwn; ++i) {
      const auto& row = e.covariance[i];
      e.mean[i] = row[0] * right[0] + row[1] * right[1] + row[2] * right[2];
      for (std::size_t j = 0; j < kFront; ++j) {
        const double* next = m[kOwn + j];
        e.link[i][j] = row[0] * next[0] + row[1] * next[1] + row[2] * next[2];
      }
    }
    for (std::size_t i = 0; i < kFront; ++i) {
      const double* next = m[kOwn + i];
      left_right[i] =
          right[kOwn + i] - next[0] * e.mean[0] - next[1] * e.mean[1] - next[2] * e.mean[2];
      for (std::size_t j = 0; j <= i; ++j) {
        left[i][j] = next[kOwn + j] - next[0] * e.link[0][j] - next[1] * e.link[1][j] -
                     next[2] * e.link[2][j];
      }
    }
  }
}

/// Substitutes back, from the last node to the first.
void ShakeSmoother::substitute(std::size_t axis) {
  const std::size_t n = nodes_.size();
  double cov[kFront][kFront] = {}, front[kFront] = {};
  fresh_[axis] = 0.0;
  for (std::size_t k = n; k-- > 0;) {
    const Eliminated& e = equations_[k];
    double own[kOwn], across[kOwn][kFront], inner[kOwn][kOwn];
    for (std::size_t i = 0; i < kOwn; ++i) {
      own[i] = e.mean[i];
      for (std::size_t j = 0; j < kFront; ++j) {
        own[i] -= e.link[i][j] * front[j];
        double sum = 0.0;
        for (std::size_t t = 0; t < kFront; ++t) sum -= e.link[i][t] * cov[t][j];
        across[i][j] = sum;
      }
    }
    for (std::size_t i = 0; i < kOwn; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        double sum = e.covariance[i][j];
        for (std::size_t t = 0; t < kFront; ++t) sum -= across[i][t] * e.link[j][t];
        inner[i][j] = inner[j][i] = sum;
      }
    }
    (axis == 0 ? shaking_[k].x : shaking_[k].y) = own[1];
    see(axis, k, {own, front, inner, across, cov});
    // The front of the node before: own, and x of the next two.
    constexpr std::array<std::size_t, 2> kKept = {0, 3};
    double moved[kFront][kFront];
    for (std::size_t i = 0; i < kOwn; ++i) {
      for (std::size_t j = 0; j < kOwn; ++j) moved[i][j] = inner[i][j];
      for (std::size_t j = 0; j < 2; ++j) {
        moved[i][kOwn + j] = moved[kOwn + j][i] = across[i][kKept[j]];
      }
    }
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) moved[kOwn + i][kOwn + j] = cov[kKept[i]][kKept[j]];
    }
    const double x1 = front[0], x2 = front[3];
    for (std::size_t i = 0; i < kFront; ++i) {
      for (std::size_t j = 0; j < kFront; ++j) cov[i][j] = moved[i][j];
    }
    front[0] = own[0];
    front[1] = own[1];
    front[2] = own[2];
    front[3] = x1;
    front[4] = x2;
  }
}

/// Sums up what the next pass learns from node k.
void ShakeSmoother::see(std::size_t axis, std::size_t k, const Moments& is) {
  const auto& [own, front, inner, across, cov] = is;
  const std::size_t n = nodes_.size();
  if (k + 3 < n) {
    const double mean = front[4] - 3.0 * front[3] + 3.0 * front[0] - own[0];
    const double variance = inner[0][0] + 9.0 * (cov[0][0] + cov[3][3]) + cov[4][4] -
                            6.0 * across[0][0] + 6.0 * across[0][3] - 2.0 * across[0][4] -
                            18.0 * cov[0][3] + 6.0 * cov[0][4] - 6.0 * cov[3][4];
    jerk_seen_[k] += mean * mean + variance;
  }
  if (k + 1 < n) {
    const std::complex<double> z(own[1], own[2]), next(front[1], front[2]);
    const std::complex<double> both =
        std::conj(z) * next +
        std::complex<double>(across[1][1] + across[2][2], across[1][2] - across[2][1]);
    const double before = std::norm(z) + inner[1][1] + inner[2][2];
    const double after = std::norm(next) + cov[1][1] + cov[2][2];
    fresh_[axis] +=
        after + decay_ * decay_ * before - 2.0 * (std::conj(rotation_[k]) * both).real();
    turn_seen_[k] += both / size_[axis];
  }
}

void ShakeSmoother::learn_jerk() {
  if (nodes_.size() < 4) return;
  std::vector<double> count(nodes_.size(), 2.0);  // two axes
  for (std::size_t k = nodes_.size() - 3; k < nodes_.size(); ++k) count[k] = 0.0;
  const double width = kJerkWindowS / step_s_;
  blur(jerk_seen_, width);
  blur(count, width);
  const double usual = third_difference_variance(kUsualJerk, step_s_);
  const double least = third_difference_variance(kMinJerk, step_s_);
  const double most = third_difference_variance(kMaxJerk, step_s_);
  for (std::size_t k = 0; k < jerk_.size(); ++k) {
    jerk_[k] =
        std::clamp((kJerkCount * usual + jerk_seen_[k]) / (kJerkCount + count[k]), least, most);
  }
}

void ShakeSmoother::learn_frequency() {
  const std::complex<double> back = std::polar(1.0, -angle_);
  for (auto& seen : turn_seen_) seen *= back;
  const double width = kTurnWindowS / step_s_, most = kTau * kMaxDriftHz * step_s_;
  blur(turn_seen_, width);
  for (std::size_t k = 0; k < turn_.size(); ++k) {
    turn_[k] = angle_ + std::clamp(std::arg(turn_seen_[k] + kTurnCount * width), -most, most);
  }
}

void ShakeSmoother::learn_swing() {
  const double count = 2.0 * static_cast<double>(nodes_.size() - 1);  // c and s
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double seen = fresh_[axis] / (1.0 - decay_ * decay_);
    size_[axis] = std::min((kSwingCount * prior_[axis] + seen) / (kSwingCount + count),
                           kMaxSwing * kMaxSwing * prior_[axis]);
  }
}

double ShakeSmoother::jerk_mm_per_s3() const noexcept {
  double sum = 0.0;
  for (const double v : jerk_) sum += std::log(v);
  const double mean = sum / static_cast<double>(jerk_.size());
  return std::sqrt(std::exp(mean) / third_difference_variance(1.0, step_s_));
}

double ShakeSmoother::hz(std::size_t k) const noexcept {
  return turn_[k] / (kTau * step_s_);
}

}  // namespace felt
