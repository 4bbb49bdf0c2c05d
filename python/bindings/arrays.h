#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/point.h"
#include "felt/stroke/fit/ink_fit.h"

/// Conversions between numpy arrays and the values of the library. Every function that reads an
/// array copies it, so that the library can use the values while other threads change the array.
namespace felt::python {

namespace py = pybind11;

/// An unknown number in an array.
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kNsPerMs = 1e6;

/// An error of the library as a C++ exception. module.cc converts it to a feltline.Error.
struct FeltError {
  Error error;
};

/// Returns the value of a result, or throws its error as FeltError.
template <class T>
T value_of(Result<T> result) {
  if (!result) throw FeltError{result.error()};
  return *std::move(result);
}
inline void check(const Result<void>& result) {
  if (!result) throw FeltError{result.error()};
}

/// Throws ValueError if a file could not hold this text as a name: it is longer than
/// limits::kMaxNameBytes or not UTF-8. The message begins with `what`.
void check_name(const std::string& what, const std::string& text);

/// Converts a Python object to an array of numbers of any shape and type. Throws TypeError if it
/// has a mask or does not contain real numbers, and ValueError if numpy cannot convert it. The
/// messages begin with `name`.
py::array any_array(const py::handle& object, const char* name);

/// A table of numbers, row by row.
struct Rows {
  py::array array;  ///< keeps the numbers alive
  const double* numbers = nullptr;
  std::size_t count = 0;
  std::size_t columns = 0;

  [[nodiscard]] double at(std::size_t row, std::size_t column) const {
    return numbers[row * columns + column];
  }
};

/// Converts a Python object to numbers. Throws TypeError if the object is not an array of real
/// numbers, and ValueError if it does not have two dimensions, no rows, or a number of columns
/// outside min_columns..max_columns. The messages begin with `name`.
Rows rows_of(const py::handle& object, const char* name, std::size_t min_columns,
             std::size_t max_columns);

/// Converts rows x, y, pressure, t_ms, tilt_deg to samples; the last three may be missing or NaN if
/// unknown. The units and limits are those of raw strokes in docs/formats/ndjson.md. Throws
/// ValueError with the index of the first bad number.
std::vector<InkSample> samples_of(const Rows& rows, const char* name, double mm_per_unit = 1.0);
std::vector<InkSample> samples_of(const py::handle& object, const char* name,
                                  double mm_per_unit = 1.0);
/// Converts one sample, given as a row or as a table with one row or more.
std::vector<InkSample> one_or_more_samples(const py::handle& object, const char* name);

/// Converts rows x, y to points. Throws ValueError if a coordinate is not finite or exceeds
/// kMaxCoordinateMm.
std::vector<Point> points_of(const py::handle& object, const char* name);
/// Converts one pair of numbers. Throws like points_of().
Point point_of(const py::handle& object, const char* name);
/// Returns true if the object has two dimensions, so that it is a list of points, not one point.
bool is_table(const py::handle& object);

/// Returns a read-only array that shows `data` without a copy, and keeps `owner` alive.
py::array view(const double* data, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
               const py::handle& owner);
/// Returns a new array with the points as rows.
py::array_t<double> array_of(const std::vector<Point>& points);
/// Returns a new array of n x 4 x 2 control points.
py::array_t<double> array_of(const std::vector<Cubic>& segments);
/// Returns samples as n x 5 numbers, as samples_of() reads them.
py::array_t<double> array_of(const std::vector<InkSample>& samples);

}  // namespace felt::python
