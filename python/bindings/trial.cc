#include <pybind11/stl.h>

#include <cmath>
#include <limits>

#include "bindings.h"
#include "felt/stroke/outline/outline.h"
#include "felt/studies/measured_trial.h"
#include "felt/trial/trial_columns.h"
#include "felt/trial/trial_metrics.h"
#include "recording.h"

namespace felt::python {
namespace {

/// Largest distance between a stroke and the polyline that stands for it as a target.
constexpr double kTargetToleranceMm = 0.001;

std::vector<TrialSample> trial_samples_of(const py::object& object,
                                          std::optional<double> interval_ms) {
  if (py::isinstance<HeldRecording>(object)) {
    return trial_samples(object.cast<const HeldRecording&>().recording);
  }
  std::vector<TrialSample> samples;
  for (const InkSample& ink : samples_of(object, "samples")) {
    TrialSample sample;
    sample.position = ink.position;
    sample.pressure = ink.pressure;
    sample.contact = ink.pressure.value_or(1.0) > 0.0;
    if (interval_ms) {
      sample.time_ns = std::llround(static_cast<double>(samples.size()) * *interval_ms * 1e6);
    } else if (ink.time_ns) {
      sample.time_ns = *ink.time_ns;
    } else {
      throw py::value_error("samples[" + std::to_string(samples.size()) +
                            "]: has no time; the fourth column is t_ms, or give interval_ms");
    }
    samples.push_back(sample);
  }
  return samples;
}

std::vector<Point> line_of(const Stroke& stroke) {
  std::vector<Point> line{stroke.position(0.0)};
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Cubic segment = stroke.segment(i);
    const int steps = flatten_steps(segment, 1.0, kTargetToleranceMm);
    for (int k = 1; k <= steps; ++k) {
      line.push_back(evaluate(segment, static_cast<double>(k) / steps));
    }
  }
  return line;
}

py::dict trial_metrics(const py::object& samples, const py::object& target, TrialGeometry geometry,
                       std::optional<double> interval_ms) {
  for (const std::optional<double>& number :
       {geometry.tunnel_width_mm, geometry.target_width_mm, interval_ms}) {
    if (!number || (*number >= 1e-6 && *number <= 1e6)) continue;
    throw py::value_error(
        "tunnel_width, target_width and interval_ms must be above 0: 1e-6 to 1e6");
  }
  const std::vector<TrialSample> drawn = trial_samples_of(samples, interval_ms);
  std::vector<Point> line;
  if (py::isinstance<Stroke>(target)) {
    const auto& stroke = target.cast<const Stroke&>();
    if (stroke.closed()) geometry.ends = TrialPathEnds::kClosed;
    line = line_of(stroke);
  } else {
    line = points_of(target, "target");
  }
  TrialMetrics metrics;
  {
    const py::gil_scoped_release release;
    metrics = measure_trial(drawn, line, geometry);
  }
  py::dict values;
  for (const TrialColumn& column : trial_metric_columns()) {
    values[py::str(std::string(column.name))] = metrics.*column.value;
  }
  return values;
}

py::list trial_columns() {
  const py::object type = py::module_::import("feltline._types").attr("Column");
  py::list columns;
  for (const TrialColumn& column : trial_metric_columns()) {
    columns.append(type(std::string(column.name), std::string(column.unit),
                        std::string(column.formula), std::string(column.source)));
  }
  return columns;
}

}  // namespace

void bind_trial(py::module_& module) {
  module.def("trial_metrics",
             [](const py::object& samples, const py::object& target, bool closed,
                std::optional<double> tunnel_width, std::optional<double> target_width,
                std::optional<double> interval_ms) {
               const TrialGeometry geometry{closed ? TrialPathEnds::kClosed : TrialPathEnds::kOpen,
                                            tunnel_width, target_width};
               return trial_metrics(samples, target, geometry, interval_ms);
             });
  module.def("trial_columns", &trial_columns);
}

}  // namespace felt::python
