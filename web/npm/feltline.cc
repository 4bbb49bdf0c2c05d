// The functions that the npm package calls in its wasm module. Numbers are exchanged through two
// buffers of doubles: JavaScript writes the input, and reads the output after a call. Absent values
// are NaN. The functions that can fail return 1 on success and 0 on failure; then felt_error() has
// the reason.
//
// A stroke in a buffer: the number of segments n, 1 if closed else 0, the number of breakpoints k,
// the 3n + 1 control points (x, y), the joints (0 smooth, 1 corner), and k pairs (u, width).

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "felt/geometry/nearest.h"
#include "felt/stroke/edit/mend_joints.h"
#include "felt/stroke/edit/split.h"
#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/outline/outline_path.h"
#include "pen_look.h"

#define FELT_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace felt::npm {
namespace {

/// The columns of one sample in the input.
constexpr std::size_t kSampleColumns = 5;
/// A buffer that is larger than this is freed when a smaller one is requested.
constexpr std::size_t kKeptNumbers = std::size_t{1} << 16;

std::vector<double> input, output;
std::string error;

void put(double number) {
  output.push_back(number);
}

void put(Point p) {
  put(p.x);
  put(p.y);
}

void put(const Cubic& c) {
  for (const Point& p : c.p) put(p);
}

/// Empties the output for the next result.
void clear_output() {
  if (output.capacity() > kKeptNumbers) output = std::vector<double>();
  output.clear();
}

void put(const StrokeData& data) {
  put(static_cast<double>(data.points.size() / 3));
  put(data.closed ? 1.0 : 0.0);
  put(static_cast<double>(data.widths.size()));
  for (const Point& p : data.points) put(p);
  for (const JointKind kind : data.joints) put(kind == JointKind::kCorner ? 1.0 : 0.0);
  for (const WidthKnot& knot : data.widths) put(Point{knot.u, knot.width_mm});
}

bool failed(const Error& why) {
  error = why.message;
  return false;
}

/// Replaces the output by a stroke.
bool put_result(const Result<Stroke>& stroke) {
  if (!stroke) return failed(stroke.error());
  clear_output();
  put(stroke->data());
  return true;
}

/// Reads a stroke that JavaScript has written into the input. Mends joints that were rounded.
Result<Stroke> read_stroke() {
  const double* next = input.data();
  const auto count = static_cast<std::size_t>(*next++);
  StrokeData data;
  data.closed = *next++ != 0.0;
  const auto knots = static_cast<std::size_t>(*next++);
  data.points.resize(3 * count + 1);
  for (Point& p : data.points) {
    p = {next[0], next[1]};
    next += 2;
  }
  data.joints.resize(data.closed ? count : count - 1);
  for (JointKind& kind : data.joints)
    kind = *next++ != 0.0 ? JointKind::kCorner : JointKind::kSmooth;
  for (std::size_t i = 0; i < knots; ++i, next += 2) data.widths.push_back({next[0], next[1]});
  mend_rounding(data);
  return Stroke::create(std::move(data));
}

std::optional<double> present(double number) {
  return std::isnan(number) ? std::nullopt : std::optional(number);
}

std::optional<std::int64_t> nanoseconds(double ms) {
  constexpr double kMaxTimeMs = 9e12;
  if (!(std::fabs(ms) <= kMaxTimeMs)) return std::nullopt;
  return std::llround(ms * 1e6);
}

void put_outline(const Outline& outline) {
  clear_output();
  put(static_cast<double>(outline.ends.size()));
  for (const std::size_t end : outline.ends) put(static_cast<double>(end));
  for (const Point& p : outline.points) put(p);
}

}  // namespace

/// Returns the input with room for `count` numbers.
FELT_EXPORT(input) double* felt_input(std::size_t count) {
  if (input.capacity() > kKeptNumbers && count <= kKeptNumbers) input = std::vector<double>();
  input.resize(count);
  return input.data();
}

FELT_EXPORT(output) const double* felt_output() {
  return output.data();
}

FELT_EXPORT(output_size) std::size_t felt_output_size() {
  return output.size();
}

FELT_EXPORT(error) const char* felt_error() {
  return error.c_str();
}

/// Makes a fitter. The input has the options in the order of `optionNames` in fitter.js.
FELT_EXPORT(fitter_new) InkFitter* felt_fitter_new() {
  InkFitOptions options;
  options.curve.tolerance_mm = input[0];
  options.width_map.min_mm = input[1];
  options.width_map.max_mm = input[2];
  options.width_map.gamma = input[3];
  options.width_map.absent_pressure = input[4];
  options.width_map.time_constant_ms = input[5];
  options.width_map.interval_ms = input[6];
  options.filter.interval_ms = input[6];
  options.width_map.tilt_width = input[7];
  options.width.tolerance_mm = input[8];
  options.filter_artefacts = input[9] != 0.0;
  options.width.max_mm =
      std::max(options.width.max_mm, input[2] * std::max(1.0, options.width_map.tilt_width));
  return new InkFitter(options);
}

FELT_EXPORT(fitter_free) void felt_fitter_free(InkFitter* fitter) {
  delete fitter;
}

FELT_EXPORT(fitter_begin) void felt_fitter_begin(InkFitter* fitter) {
  fitter->begin();
}

FELT_EXPORT(fitter_copy) void felt_fitter_copy(InkFitter* fitter, const InkFitter* other) {
  fitter->copy_stroke(*other);
}

/// Adds `count` samples of the input: x, y, pressure, time in ms, tilt in degrees.
FELT_EXPORT(fitter_push) void felt_fitter_push(InkFitter* fitter, std::size_t count) {
  const double* row = input.data();
  for (std::size_t i = 0; i < count; ++i, row += kSampleColumns) {
    fitter->push({{row[0], row[1]}, present(row[2]), nanoseconds(row[3]), present(row[4])});
  }
}

FELT_EXPORT(fitter_end) void felt_fitter_end(InkFitter* fitter) {
  fitter->end();
}

FELT_EXPORT(fitter_refine) void felt_fitter_refine(InkFitter* fitter) {
  fitter->refine();
}

FELT_EXPORT(fitter_ignored) std::size_t felt_fitter_ignored(InkFitter* fitter) {
  return fitter->ignored_count();
}

/// Returns what is wrong with the pressures and times, as a sum of the bits of `FAULTS` in
/// fitter.js.
FELT_EXPORT(fitter_faults) int felt_fitter_faults(InkFitter* fitter) {
  const SampleFaults faults = fitter->faults();
  const int pressures = faults.bad_pressures > 0 ? 1 : 0;
  if (!times_matter(faults)) return pressures;
  if (faults.has_no_clock) return pressures + 2;
  return pressures + (faults.backward_times > 0 ? 4 : 0);
}

FELT_EXPORT(fitter_stroke) int felt_fitter_stroke(InkFitter* fitter) {
  return put_result(fitter->stroke());
}

/// Writes the stable segments from `first` on, each with the kind of the joint before it (0 for the
/// first segment of the stroke).
FELT_EXPORT(fitter_frozen) void felt_fitter_frozen(InkFitter* fitter, int first) {
  clear_output();
  for (int i = std::max(0, first); i < fitter->segment_count(); ++i) {
    put(fitter->segment(i));
    put(i > 0 && fitter->joint(i) == JointKind::kCorner ? 1.0 : 0.0);
  }
}

FELT_EXPORT(fitter_tail) void felt_fitter_tail(InkFitter* fitter) {
  clear_output();
  for (const Cubic& segment : fitter->live_tail()) put(segment);
}

/// Writes the outline that getStroke() returns. The input has the taper of both ends, see PenLook.
FELT_EXPORT(fitter_look) int felt_fitter_look(InkFitter* fitter, double tolerance_mm) {
  const Result<Stroke> stroke = fitter->stroke();
  if (!stroke) return failed(stroke.error());
  put_outline(pen_outline(*stroke, PenLook::from_numbers(input.data()), tolerance_mm));
  return 1;
}

/// Finds the point of the stroke in the input that is nearest to (x, y).
FELT_EXPORT(stroke_nearest) int felt_stroke_nearest(double x, double y) {
  const Result<Stroke> stroke = read_stroke();
  if (!stroke) return failed(stroke.error());
  double best_u = 0.0;
  Nearest best = nearest(stroke->segment(0), {x, y});
  for (int i = 1; i < stroke->segment_count(); ++i) {
    const auto closer = nearest_within(stroke->segment(i), {x, y}, best.distance_squared);
    if (!closer || !(closer->distance_squared < best.distance_squared)) continue;
    best = *closer;
    best_u = i;
  }
  best_u += best.t;
  clear_output();
  put(best_u);
  put(best.point);
  put(std::sqrt(best.distance_squared));
  put(stroke->width_mm(best_u));
  return 1;
}

/// Traces the stroke in the input: polygons.
FELT_EXPORT(stroke_outline) int felt_stroke_outline(double tolerance_mm) {
  const Result<Stroke> stroke = read_stroke();
  if (!stroke) return failed(stroke.error());
  put_outline(outline_of(*stroke, tolerance_mm));
  return 1;
}

/// Traces the stroke in the input: lines and cubic curves, as the number of verbs, the verbs and
/// the points.
FELT_EXPORT(stroke_outline_path) int felt_stroke_outline_path(double tolerance_mm) {
  const Result<Stroke> stroke = read_stroke();
  if (!stroke) return failed(stroke.error());
  const OutlinePath path = outline_path(*stroke, tolerance_mm);
  clear_output();
  put(static_cast<double>(path.verbs.size()));
  for (const OutlinePath::Verb verb : path.verbs) put(static_cast<double>(verb));
  for (const Point& p : path.points) put(p);
  return 1;
}

/// Writes the part of the stroke in the input between u0 and u1.
FELT_EXPORT(stroke_part) int felt_stroke_part(double u0, double u1) {
  const Result<Stroke> stroke = read_stroke();
  if (!stroke) return failed(stroke.error());
  return put_result(sub_stroke(*stroke, u0, u1));
}

}  // namespace felt::npm
