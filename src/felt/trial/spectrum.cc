#include "felt/trial/spectrum.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "felt/base/check.h"

namespace felt {

std::vector<std::complex<double>> spectrum(std::span<const double> values, std::size_t size) {
  FELT_CHECK(size > 0 && (size & (size - 1)) == 0 && values.size() <= size);
  std::vector<std::complex<double>> out(size);
  for (std::size_t i = 0; i < values.size(); ++i) out[i] = values[i];
  for (std::size_t i = 1, j = 0; i < size; ++i) {  // j has the bits of i in reverse order
    std::size_t bit = size >> 1U;
    for (; (j & bit) != 0; bit >>= 1U) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(out[i], out[j]);
  }
  std::vector<std::complex<double>> roots(size / 2);
  for (std::size_t k = 0; k < roots.size(); ++k)
    roots[k] = std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(k) / double(size));
  for (std::size_t half = 1; half < size; half *= 2) {
    const std::size_t stride = size / (2 * half);
    for (std::size_t start = 0; start < size; start += 2 * half) {
      for (std::size_t k = 0; k < half; ++k) {
        std::complex<double>&a = out[start + k], &b = out[start + k + half];
        const std::complex<double> r = roots[k * stride];
        const std::complex<double> odd{b.real() * r.real() - b.imag() * r.imag(),
                                       b.real() * r.imag() + b.imag() * r.real()};
        b = a - odd;
        a += odd;
      }
    }
  }
  return out;
}

}  // namespace felt
