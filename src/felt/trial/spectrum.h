#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace felt {

/// Returns the discrete Fourier transform of `values` with zeros appended until there are `size`
/// numbers. Requires `size` to be a power of two and not less than the number of values. Source:
/// Cooley, Tukey 1965, doi:10.1090/S0025-5718-1965-0178586-1.
std::vector<std::complex<double>> spectrum(std::span<const double> values, std::size_t size);

}  // namespace felt
