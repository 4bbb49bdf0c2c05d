#pragma once

/// Functions for filter coefficients that use only + - * /. The results of libm differ between
/// machines in the last bit, and the same script must give the same bytes. These functions take
/// about 50 ns each, which is too slow for every sample.
namespace felt::plain {

inline constexpr double kPi = 3.14159265358979324;

/// Returns e^x for x in -700..700, with a relative error of 1e-12.
constexpr double exp(double x) noexcept {
  constexpr int kHalvings = 12, kTerms = 8;
  const double part = x / (1 << kHalvings);
  double sum = 1.0;
  for (int i = kTerms; i > 0; --i) sum = 1.0 + part / i * sum;
  for (int i = 0; i < kHalvings; ++i) sum *= sum;
  return sum;
}

/// Returns 2^x.
constexpr double exp2(double x) noexcept {
  return exp(0.693147180559945309 * x);
}

/// Return the cosine and sine of x in -pi..pi, within 1e-12.
constexpr double cos(double x) noexcept {
  double sum = 1.0;
  for (int i = 24; i > 0; i -= 2) sum = 1.0 - x * x / (i * (i - 1)) * sum;
  return sum;
}
constexpr double sin(double x) noexcept {
  double sum = 1.0;
  for (int i = 25; i > 1; i -= 2) sum = 1.0 - x * x / (i * (i - 1)) * sum;
  return x * sum;
}

}  // namespace felt::plain
