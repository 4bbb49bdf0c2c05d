#include "felt/stroke/steady/shake_filter.h"

#include <cmath>

#include "felt/base/constants.h"

namespace felt {
namespace {

/// Sample rate to which the jerk of ShakeModel belongs.
constexpr double kUsualHz = 133.0;

}  // namespace

ShakeStep shake_step(double hz, double dt_s) noexcept {
  const double decay = std::exp(-dt_s / ShakeFilter::kDecayS), angle = kTau * hz * dt_s;
  return {dt_s, decay * std::cos(angle), decay * std::sin(angle), decay};
}

ShakeFilter::Record ShakeFilter::begin(double y_mm) noexcept {
  const double swing = model_.swing_mm * model_.swing_mm;
  x_ = {y_mm, 0.0, 0.0, 0.0, 0.0};
  p_ = {};
  // The position is known, but not which part of it is the oscillation.
  p_[0][0] = swing + kNoiseMm2;
  p_[0][3] = p_[3][0] = -swing;
  p_[1][1] = kStartSpeed * kStartSpeed;
  p_[2][2] = kStartAcceleration * kStartAcceleration;
  p_[3][3] = p_[4][4] = swing;
  Record record;
  record.row = p_[0];
  record.position = y_mm;
  return record;
}

void ShakeFilter::predict(const ShakeStep& step) noexcept {
  const double t = step.dt_s, half = 0.5 * t * t, c = step.cos, s = step.sin;
  const auto move = [&](double& p, double& v, double& a, double& o, double& q) {
    p += t * v + half * a;
    v += t * a;
    const double turned = c * o - s * q;
    q = s * o + c * q;
    o = turned;
  };
  move(x_[0], x_[1], x_[2], x_[3], x_[4]);
  // F P F': first the columns, then the rows.
  for (std::size_t j = 0; j < 5; ++j) move(p_[0][j], p_[1][j], p_[2][j], p_[3][j], p_[4][j]);
  for (State& row : p_) move(row[0], row[1], row[2], row[3], row[4]);
  const double q = model_.jerk_mm_per_s3 * model_.jerk_mm_per_s3 / kUsualHz;
  const double t2 = t * t, t3 = t2 * t;
  p_[0][0] += q * t3 * t2 / 20.0;
  p_[0][1] += q * t2 * t2 / 8.0;
  p_[0][2] += q * t3 / 6.0;
  p_[1][1] += q * t3 / 3.0;
  p_[1][2] += q * t2 / 2.0;
  p_[2][2] += q * t;
  const double fresh = model_.swing_mm * model_.swing_mm * (1.0 - step.decay * step.decay);
  p_[3][3] += fresh;
  p_[4][4] += fresh;
  // Keeps the matrix exactly symmetric, so that rounding errors do not grow.
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = 0; j < i; ++j) p_[i][j] = p_[j][i];
  }
}

ShakeFilter::Record ShakeFilter::push(double y_mm, const ShakeStep& step) noexcept {
  predict(step);
  State h;  // P H', where H measures p + c
  for (std::size_t i = 0; i < 5; ++i) h[i] = p_[i][0] + p_[i][3];
  Record record;
  record.step = step;
  record.variance = h[0] + h[3] + kNoiseMm2;
  record.innovation = y_mm - x_[0] - x_[3];
  for (std::size_t i = 0; i < 5; ++i) {
    record.gain[i] = h[i] / record.variance;
    x_[i] += record.gain[i] * record.innovation;
  }
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = i; j < 5; ++j) p_[j][i] = p_[i][j] -= record.gain[i] * h[j];
  }
  record.row = p_[0];
  record.position = x_[0];
  return record;
}

double ShakeFilter::log_likelihood(const Record& record) noexcept {
  return -0.5 *
         (std::log(record.variance) + record.innovation * record.innovation / record.variance);
}

double ShakeFilter::smooth(const Record& record, Adjoint& adjoint) noexcept {
  double position = record.position, along_gain = 0.0;
  for (std::size_t i = 0; i < 5; ++i) {
    position -= record.row[i] * adjoint[i];
    along_gain += record.gain[i] * adjoint[i];
  }
  // (I - K H)' adjoint - H' innovation / variance, then the transposed step.
  const double change = along_gain + record.innovation / record.variance;
  const double p = adjoint[0] - change, c = adjoint[3] - change, s = adjoint[4];
  const double v = adjoint[1], a = adjoint[2], t = record.step.dt_s;
  adjoint = {p, t * p + v, 0.5 * t * t * p + t * v + a, record.step.cos * c + record.step.sin * s,
             record.step.cos * s - record.step.sin * c};
  return position;
}

}  // namespace felt
