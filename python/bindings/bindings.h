#pragma once

#include <memory>
#include <optional>
#include <string>
#include <typeinfo>

#include "arrays.h"
#include "felt/document/drawing.h"
#include "felt/document/edit.h"
#include "felt/io/import.h"
#include "felt/stroke/fit/ink_fit.h"
#include "felt/stroke/steady/shake.h"

/// The parts of the extension module `feltline._feltline`. Each function adds one part.
namespace felt::python {

void bind_stroke(py::module_& module);
void bind_fit(py::module_& module);
void bind_drawing(py::module_& module);
void bind_files(py::module_& module);
void bind_recording(py::module_& module);
void bind_trial(py::module_& module);

/// Makes every use of an object of class T that was made without its constructor, as by
/// T.__new__(T), raise TypeError. pybind11 2.10 would give it uninitialised memory: load_value() in
/// pybind11/detail/type_caster_base.h calls this function where the object has no value.
template <class T>
void require_constructor() {
  py::detail::get_type_info(typeid(T), true)->operator_new = [](std::size_t) -> void* {
    throw py::type_error("the object was made without its constructor");
  };
}

/// A stroke as Python holds it. It is never changed.
using SharedStroke = std::shared_ptr<Stroke>;
SharedStroke share(Stroke stroke);
SharedStroke share(const StrokePtr& stroke);

/// A drawing as Python holds it: a value, with the reader's report if it was read from a file.
struct ReadDrawing {
  Drawing drawing;
  std::vector<ImportNotice> notices{};
  std::string format{};  ///< name of the format, or "" if the drawing was not read
  bool is_exact = true;
};

/// The options of `feltline fit`, with its names and defaults.
struct FitArguments {
  double tolerance = CurveFitOptions{}.tolerance_mm;
  bool filter = false;
  std::string scheme = "feltline";
  int shared_samples = InkFitOptions{}.shared_samples;
  std::optional<std::string> medium{};
  std::optional<double> min_width{}, max_width{};

  friend bool operator==(const FitArguments&, const FitArguments&) = default;
};

/// Returns the options of the fitter. Throws ValueError if an argument is out of range.
InkFitOptions options_of(const FitArguments& arguments);

}  // namespace felt::python
