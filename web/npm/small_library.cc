// Replaces parts of the C library and of Feltline that would make the wasm module larger.

#include <cstdarg>
#include <cstddef>

#include "felt/base/check.h"
#include "felt/stroke/fit/paper_fitter.h"

/// Writes `number` with at most nine significant digits into `buffer` of `size` bytes. Implemented
/// in JavaScript (module.js), which can already print numbers.
extern "C" __attribute__((import_module("env"), import_name("print_number"))) int print_number(
    char* buffer, std::size_t size, double number);

/// Replaces the function of the C library, which would be a tenth of the module. Supports only
/// the format "%.9g", which is the only one in these layers (stroke_invariants.cc).
extern "C" int snprintf(char* buffer, std::size_t size, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int written = print_number(buffer, size, va_arg(arguments, double));
  va_end(arguments);
  return written;
}

namespace felt {

/// A failed check ends the call: JavaScript throws an error and makes a new module.
void detail::check_failed(const char* /*condition*/, const char* /*file*/, int /*line*/) noexcept {
  __builtin_trap();
}

// The scheme of the 2002 paper is not part of the package, but InkFitter refers to it.
PaperFitter::PaperFitter(const CurveFitOptions& /*options*/, int /*shared_samples*/,
                         double /*data_point_mm*/)
    : tolerance_mm_(0.0), shared_(0), data_point_mm_(0.0) {}
void PaperFitter::begin() {}
void PaperFitter::push(Point /*p*/) {}
void PaperFitter::end() {}

}  // namespace felt
