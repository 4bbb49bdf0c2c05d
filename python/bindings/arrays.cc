#include "arrays.h"

#include <algorithm>
#include <cmath>

#include "felt/base/utf8.h"
#include "felt/geometry/tilt.h"
#include "felt/io/limits.h"

namespace felt::python {
namespace {

std::string shape_text(const py::array& array) {
  return py::str(array.attr("shape")).cast<std::string>();
}

py::module_ tables() {
  return py::module_::import("feltline._tables");
}

/// Returns whether the object is exactly a numpy array. The checks of other objects take longer
/// than everything else.
bool is_plain_array(const py::handle& object) {
  return py::type::handle_of(object).ptr() ==
         reinterpret_cast<PyObject*>(py::detail::npy_api::get().PyArray_Type_);
}

/// Returns the rows of a data frame, whose columns have names, and any other object as it is.
py::object by_position(const py::handle& object, const char* name, std::size_t max_columns) {
  const bool has_names = is_plain_array(object)
                             ? py::reinterpret_borrow<py::array>(object).dtype().kind() == 'V'
                             : tables().attr("is_frame")(object).cast<bool>();
  if (!has_names) return py::reinterpret_borrow<py::object>(object);
  return tables().attr("rows_of_frame")(object, name, max_columns);
}

[[noreturn]] void bad_number(const char* name, std::size_t row, const char* part, double number,
                             const char* reason) {
  throw py::value_error(std::string(name) + "[" + std::to_string(row) + "]: " + part + " is " +
                        py::repr(py::float_(number)).cast<std::string>() + ", " + reason);
}

double coordinate(const Rows& rows, std::size_t row, std::size_t column, const char* name,
                  double mm_per_unit) {
  const double number = rows.at(row, column);
  const char* part = column == 0 ? "x" : "y";
  if (!std::isfinite(number)) bad_number(name, row, part, number, "not a finite number");
  if (!(std::fabs(number * mm_per_unit) <= kMaxCoordinateMm)) {
    bad_number(name, row, part, number, "beyond 1e9 mm");
  }
  return number * mm_per_unit;
}

/// Returns a number that may be unknown, which is NaN.
std::optional<double> known(const Rows& rows, std::size_t row, std::size_t column, const char* part,
                            const char* name) {
  if (column >= rows.columns || std::isnan(rows.at(row, column))) return std::nullopt;
  const double number = rows.at(row, column);
  if (!std::isfinite(number)) {
    bad_number(name, row, part, number, "not a finite number (NaN means unknown)");
  }
  return number;
}

InkSample sample_of_row(const Rows& rows, std::size_t row, const char* name, double mm_per_unit) {
  InkSample sample;
  sample.position = {coordinate(rows, row, 0, name, mm_per_unit),
                     coordinate(rows, row, 1, name, mm_per_unit)};
  sample.pressure = known(rows, row, 2, "pressure", name);
  if (const auto time_ms = known(rows, row, 3, "t_ms", name)) {
    if (std::fabs(*time_ms) > limits::kMaxTimeMs) {
      bad_number(name, row, "t_ms", *time_ms, "beyond 9e12 ms");
    }
    sample.time_ns = std::llround(*time_ms * kNsPerMs);
  }
  if (const auto tilt_deg = known(rows, row, 4, "tilt_deg", name)) {
    if (*tilt_deg < 0.0 || *tilt_deg > kMaxTiltDeg) {
      bad_number(name, row, "tilt_deg", *tilt_deg, "not an angle from 0 to 90 degrees");
    }
    sample.tilt_deg = *tilt_deg;
  }
  return sample;
}

}  // namespace

void check_name(const std::string& what, const std::string& text) {
  if (text.size() <= limits::kMaxNameBytes && is_utf8(text)) return;
  throw py::value_error(what + ": must be UTF-8 of at most " +
                        std::to_string(limits::kMaxNameBytes) + " bytes");
}

py::array any_array(const py::handle& object, const char* name) {
  const bool is_plain = is_plain_array(object);
  if (!is_plain &&
      py::module_::import("numpy").attr("ma").attr("isMaskedArray")(object).cast<bool>()) {
    throw py::type_error(std::string(name) + ": is a masked array; fill it first, for example " +
                         "with .filled(nan)");
  }
  py::array array;
  try {
    array = is_plain ? py::reinterpret_borrow<py::array>(object)
                     : py::array(tables().attr("numbers_of")(object));
  } catch (py::error_already_set& error) {
    if (error.matches(PyExc_MemoryError)) throw;
    throw py::value_error(std::string(name) + ": cannot be converted to an array of numbers (" +
                          py::str(error.value()).cast<std::string>() + ")");
  }
  const char kind = array.dtype().kind();
  if (array.size() > 0 && kind != 'f' && kind != 'i' && kind != 'u') {
    throw py::type_error(std::string(name) + ": must contain real numbers, not " +
                         py::str(array.dtype()).cast<std::string>());
  }
  return array;
}

Rows rows_of(const py::handle& object, const char* name, std::size_t min_columns,
             std::size_t max_columns) {
  const std::string wanted = min_columns == max_columns ? std::to_string(min_columns)
                                                        : std::to_string(min_columns) + " to " +
                                                              std::to_string(max_columns);
  const py::array array = any_array(object, name);
  if (array.ndim() != 2) {
    if (array.size() == 0) throw py::value_error(std::string(name) + ": is empty");
    throw py::value_error(std::string(name) + ": must have the shape (n, " + wanted + "), not " +
                          shape_text(array));
  }
  if (array.shape(0) == 0) throw py::value_error(std::string(name) + ": is empty");
  const auto columns = static_cast<std::size_t>(array.shape(1));
  if (columns < min_columns || columns > max_columns) {
    throw py::value_error(std::string(name) + ": must have " + wanted + " columns, not " +
                          std::to_string(columns));
  }
  Rows rows;
  using Numbers = py::array_t<double, py::array::c_style>;
  const bool is_ready = py::isinstance<Numbers>(array);
  rows.array = is_ready
                   ? array
                   : py::array(py::module_::import("numpy").attr("ascontiguousarray")(array, "f8"));
  rows.numbers = static_cast<const double*>(rows.array.data());
  rows.count = static_cast<std::size_t>(rows.array.shape(0));
  rows.columns = columns;
  return rows;
}

std::vector<InkSample> samples_of(const Rows& rows, const char* name, double mm_per_unit) {
  std::vector<InkSample> samples;
  samples.reserve(rows.count);
  for (std::size_t i = 0; i < rows.count; ++i) {
    samples.push_back(sample_of_row(rows, i, name, mm_per_unit));
  }
  return samples;
}

std::vector<InkSample> samples_of(const py::handle& object, const char* name, double mm_per_unit) {
  return samples_of(rows_of(by_position(object, name, 5), name, 2, 5), name, mm_per_unit);
}

std::vector<InkSample> one_or_more_samples(const py::handle& object, const char* name) {
  const py::array array = any_array(by_position(object, name, 5), name);
  if (array.ndim() != 1 || array.size() == 0) return samples_of(array, name);
  return samples_of(array.attr("reshape")(1, -1), name);
}

std::vector<Point> points_of(const py::handle& object, const char* name) {
  const Rows rows = rows_of(by_position(object, name, 2), name, 2, 2);
  std::vector<Point> points;
  points.reserve(rows.count);
  for (std::size_t i = 0; i < rows.count; ++i) {
    points.push_back({coordinate(rows, i, 0, name, 1.0), coordinate(rows, i, 1, name, 1.0)});
  }
  return points;
}

Point point_of(const py::handle& object, const char* name) {
  const py::array array = any_array(object, name);
  if (array.ndim() != 1 || array.size() != 2) {
    throw py::value_error(std::string(name) + ": must be a point (x, y), or have the shape (n, 2)" +
                          ", not " + shape_text(array));
  }
  return points_of(array.attr("reshape")(1, 2), name).front();
}

bool is_table(const py::handle& object) {
  return any_array(by_position(object, "point", 2), "point").ndim() == 2;
}

py::array view(const double* data, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
               const py::handle& owner) {
  py::array array(py::dtype::of<double>(), std::move(shape), std::move(strides), data, owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::array_t<double> array_of(const std::vector<Point>& points) {
  const auto count = static_cast<py::ssize_t>(points.size());
  py::array_t<double> array(std::vector<py::ssize_t>{count, 2});
  double* out = array.mutable_data();
  for (const Point& p : points) {
    *out++ = p.x;
    *out++ = p.y;
  }
  return array;
}

py::array_t<double> array_of(const std::vector<Cubic>& segments) {
  const auto count = static_cast<py::ssize_t>(segments.size());
  py::array_t<double> array(std::vector<py::ssize_t>{count, 4, 2});
  double* out = array.mutable_data();
  for (const Cubic& segment : segments) {
    for (const Point& p : segment.p) {
      *out++ = p.x;
      *out++ = p.y;
    }
  }
  return array;
}

py::array_t<double> array_of(const std::vector<InkSample>& samples) {
  const auto count = static_cast<py::ssize_t>(samples.size());
  py::array_t<double> array(std::vector<py::ssize_t>{count, 5});
  double* out = array.mutable_data();
  for (const InkSample& sample : samples) {
    *out++ = sample.position.x;
    *out++ = sample.position.y;
    *out++ = sample.pressure.value_or(kUnknown);
    *out++ = sample.time_ns ? static_cast<double>(*sample.time_ns) / kNsPerMs : kUnknown;
    *out++ = sample.tilt_deg.value_or(kUnknown);
  }
  return array;
}

}  // namespace felt::python
