#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "bindings.h"
#include "felt/base/read_file.h"
#include "felt/material/materials.h"
#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/steady/steady_line.h"
#include "felt/tools/medium_line.h"

namespace felt::python {
namespace {

/// Throws ValueError unless low <= number <= high.
void check_range(const char* name, double number, double low, double high, const char* range) {
  if (number >= low && number <= high) return;
  throw py::value_error(std::string(name) + ": " +
                        py::repr(py::float_(number)).cast<std::string>() + " is not a number in " +
                        range);
}

std::string media_names() {
  std::string names;
  for (const Medium& medium : Materials::built_in().media()) {
    if (medium.draws) names += (names.empty() ? "" : ", ") + medium.id;
  }
  return names;
}

const Medium* medium_of(const std::optional<std::string>& id) {
  if (!id) return nullptr;
  const Medium* medium = find_medium(*id);
  if (medium && medium->draws) return medium;
  throw py::value_error("medium: unknown medium '" + *id + "'; the media are " + media_names());
}

void set_widths(const FitArguments& arguments, const Medium* medium, InkFitOptions& ink) {
  WidthMapOptions& widths = ink.width_map;
  if (medium) {
    widths.min_mm = medium->line.min_mm;
    widths.max_mm = medium->line.max_mm;
    widths.gamma = medium->line.gamma;
  }
  constexpr double kMaxWidthMm = 1000.0;
  widths.min_mm = arguments.min_width.value_or(widths.min_mm);
  widths.max_mm = arguments.max_width.value_or(widths.max_mm);
  check_range("min_width", widths.min_mm, kMinWidthMm, kMaxWidthMm, "0.05..1000");
  check_range("max_width", widths.max_mm, kMinWidthMm, kMaxWidthMm, "0.05..1000");
  if (widths.max_mm < widths.min_mm) throw py::value_error("max_width: is less than min_width");
  ink.width.max_mm = std::max(ink.width.max_mm, widths.max_mm);
}

FitScheme scheme_of(const std::string& name) {
  if (name == "feltline") return FitScheme::kFeltline;
  if (name == "paper2002") return FitScheme::kPaper2002;
  throw py::value_error("scheme: '" + name + "' is neither 'feltline' nor 'paper2002'");
}

/// Returns how a hand shakes: None, the text "HZ,MM,DEG", three numbers, or the name of a file.
std::optional<Shake> shake_of(const py::object& steady) {
  if (steady.is_none()) return std::nullopt;
  const bool is_text = py::isinstance<py::str>(steady) || py::isinstance<py::bytes>(steady);
  if (!is_text && py::isinstance<py::sequence>(steady)) {
    if (py::len(steady) != 3) throw py::value_error("steady: must be (hz, mm, degrees)");
    const py::str text = py::str(",").attr("join")(
        py::module_::import("builtins").attr("map")(py::type::of(py::str()), steady));
    return value_of(shake_from_text(text.cast<std::string>()));
  }
  const auto argument = py::module_::import("os").attr("fsencode")(steady).cast<std::string>();
  if (argument.find('\0') != std::string::npos) {
    throw py::value_error("steady: contains a null character");
  }
  if (argument.find(',') != std::string::npos) return value_of(shake_from_text(argument));
  constexpr std::size_t kMaxBytes = std::size_t{1} << 16;
  const std::string text = value_of(read_regular_file(argument, kMaxBytes));
  Result<Shake> shake = read_shake(text);
  if (!shake) throw FeltError{with_context(shake.error(), argument)};
  return *shake;
}

/// Returns this thread's fitter for these arguments. A fitter keeps its buffers, so that the next
/// stroke needs no memory; its result does not depend on the strokes before (R7).
InkFitter& fitter_of(const FitArguments& arguments) {
  struct Kept {
    FitArguments arguments;
    InkFitter fitter;
  };
  static thread_local std::optional<Kept> kept;
  if (!kept || !(kept->arguments == arguments)) {
    kept.emplace(Kept{arguments, InkFitter(options_of(arguments))});
  }
  return kept->fitter;
}

/// Calls a function without the GIL. Every function of LiveFit is called in this way, so a thread
/// never waits for its mutex while it holds the GIL.
template <class Call>
auto without_gil(Call call) {
  const py::gil_scoped_release release;
  return call();
}

Result<Stroke> fitted(InkFitter& fitter, std::vector<InkSample> samples,
                      const std::optional<Shake>& shake, bool refine, SampleFaults& faults) {
  SampleFaults before;
  if (shake) {
    SteadyLine steady(*shake);
    before = steady_samples(steady, samples);
  }
  fitter.begin();
  for (const InkSample& sample : samples) fitter.push(sample);
  fitter.end();
  if (refine) fitter.refine();
  faults = combined_faults(fitter.faults(), before);
  return fitter.stroke();
}

/// Warns of what is wrong with the samples of a stroke, at the caller `level` frames above.
void warn_of(const SampleFaults& faults, int level) {
  for (const std::string& clause : fault_clauses(faults)) {
    py::module_::import("warnings")
        .attr("warn")(name_with_faults("the stroke", faults) + " " + clause,
                      py::module_::import("feltline._types").attr("FormatWarning"), level);
  }
}

SharedStroke fit(const py::object& points, const FitArguments& arguments, double mm_per_unit,
                 bool refine, const py::object& steady) {
  check_range("mm_per_unit", mm_per_unit, 1e-9, 1e9, "1e-9..1e9");
  const std::optional<Shake> shake = shake_of(steady);
  std::vector<InkSample> samples = samples_of(points, "points", mm_per_unit);
  // Last, because converting an object may run Python code, which may call this function.
  InkFitter& fitter = fitter_of(arguments);
  SampleFaults faults;
  const SharedStroke stroke = without_gil(
      [&] { return share(value_of(fitted(fitter, std::move(samples), shake, refine, faults))); });
  warn_of(faults, 2);  // the function of Python that called this one is in between
  return stroke;
}

/// A stroke in progress. Its functions may be called by several threads, one after the other.
class LiveFit {
 public:
  LiveFit(const FitArguments& arguments, bool refine)
      : fitter_(options_of(arguments)), refine_(refine) {}

  void begin() {
    const std::lock_guard<std::mutex> lock(mutex_);
    fitter_.begin();
    ended_ = false;
  }
  /// Returns false if the stroke has ended.
  bool push(const std::vector<InkSample>& samples) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (ended_) return false;
    for (const InkSample& sample : samples) fitter_.push(sample);
    return true;
  }
  Result<Stroke> end() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!ended_) {
      fitter_.end();
      if (refine_) fitter_.refine();
    }
    ended_ = true;
    return fitter_.stroke();
  }
  SampleFaults faults() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return fitter_.faults();
  }
  std::vector<Cubic> frozen(int first) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<Cubic> segments;
    for (int i = first; i < fitter_.segment_count(); ++i) segments.push_back(fitter_.segment(i));
    return segments;
  }
  std::vector<Cubic> tail() {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto tail = fitter_.live_tail();
    return {tail.begin(), tail.end()};
  }
  std::vector<InkSample> samples() {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<InkSample> samples;
    for (const InkSample& sample : fitter_.samples()) samples.push_back(sample);
    return samples;
  }

 private:
  std::mutex mutex_;
  InkFitter fitter_;
  bool refine_;
  bool ended_ = false;
};

void push(LiveFit& fit, const py::object& points) {
  const std::vector<InkSample> samples = one_or_more_samples(points, "points");
  if (without_gil([&] { return fit.push(samples); })) return;
  throw py::value_error("the stroke has ended; begin() starts a new one");
}

void bind_fitter(py::module_& module) {
  py::class_<LiveFit>(module, "Fitter",
                      R"(Fits a stroke while it is drawn.

`frozen` has the segments that never change again, `tail` provisional ones up to the newest sample.
The result is the same as that of `fit`, however the samples are divided into calls.

>>> fitter = feltline.Fitter()
>>> fitter.push((0, 0))
>>> fitter.push([[5, 0], [10, 0]])
>>> len(fitter.frozen), len(fitter.tail) > 0
(0, True)
>>> fitter.end() == feltline.fit([[0, 0], [5, 0], [10, 0]])
True
)")
      .def(
          py::init([](double tolerance, bool refine, bool filter, const std::string& scheme,
                      int shared_samples, const std::optional<std::string>& medium,
                      std::optional<double> min_width, std::optional<double> max_width) {
            return std::make_unique<LiveFit>(FitArguments{tolerance, filter, scheme, shared_samples,
                                                          medium, min_width, max_width},
                                             refine);
          }),
          py::arg("tolerance") = FitArguments{}.tolerance, py::kw_only(), py::arg("refine") = true,
          py::arg("filter") = false, py::arg("scheme") = FitArguments{}.scheme,
          py::arg("shared_samples") = FitArguments{}.shared_samples, py::arg("medium") = py::none(),
          py::arg("min_width") = py::none(), py::arg("max_width") = py::none())
      .def(
          "begin", [](LiveFit& fit) { without_gil([&] { fit.begin(); }); },
          "Discards the last stroke and starts a new one.")
      .def("push", &push, py::arg("points"),
           "Adds one sample (x, y, pressure, t_ms, tilt_deg) or an array of samples, as for fit().")
      .def(
          "end",
          [](LiveFit& fit) {
            SharedStroke stroke = share(value_of(without_gil([&] { return fit.end(); })));
            warn_of(without_gil([&] { return fit.faults(); }), 1);
            return stroke;
          },
          "Completes the stroke and returns it.")
      .def(
          "frozen_from",
          [](LiveFit& fit, int first) {
            if (first < 0) throw py::value_error("first: must not be negative");
            return array_of(without_gil([&] { return fit.frozen(first); }));
          },
          py::arg("first"), "Returns the segments of `frozen` from the index `first` on.")
      .def_property_readonly(
          "frozen",
          [](LiveFit& fit) { return array_of(without_gil([&] { return fit.frozen(0); })); },
          "Segments that never change again: an array of shape (n, 4, 2).")
      .def_property_readonly(
          "tail", [](LiveFit& fit) { return array_of(without_gil([&] { return fit.tail(); })); },
          "Provisional segments from `frozen` to the newest sample.")
      .def_property_readonly(
          "samples",
          [](LiveFit& fit) { return array_of(without_gil([&] { return fit.samples(); })); },
          "The samples that became ink: rows (x, y, pressure, t_ms, tilt_deg).");
  require_constructor<LiveFit>();
}

}  // namespace

InkFitOptions options_of(const FitArguments& arguments) {
  check_range("tolerance", arguments.tolerance, 0.0, 1e9, "0..1e9");
  check_range("shared_samples", arguments.shared_samples, 0, 1000, "0..1000");
  InkFitOptions ink;
  const Medium* medium = medium_of(arguments.medium);
  set_widths(arguments, medium, ink);
  ink = medium ? drawn_with(*medium, std::move(ink)) : solid_fit(std::move(ink));
  ink.scheme = scheme_of(arguments.scheme);
  ink.curve.tolerance_mm = arguments.tolerance;
  ink.shared_samples = arguments.shared_samples;
  ink.filter_artefacts = arguments.filter;
  return ink;
}

void bind_fit(py::module_& module) {
  module.def(
      "fit",
      [](const py::object& points, double tolerance, double mm_per_unit, bool refine, bool filter,
         const py::object& steady, const std::string& scheme, int shared_samples,
         const std::optional<std::string>& medium, std::optional<double> min_width,
         std::optional<double> max_width) {
        const FitArguments arguments{tolerance, filter,    scheme,   shared_samples,
                                     medium,    min_width, max_width};
        return fit(points, arguments, mm_per_unit, refine, steady);
      },
      py::arg("points"), py::kw_only(), py::arg("tolerance"), py::arg("mm_per_unit"),
      py::arg("refine"), py::arg("filter"), py::arg("steady"), py::arg("scheme"),
      py::arg("shared_samples"), py::arg("medium"), py::arg("min_width"), py::arg("max_width"));
  bind_fitter(module);
}

}  // namespace felt::python
