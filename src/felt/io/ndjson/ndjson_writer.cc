#include "felt/io/ndjson/ndjson_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "felt/document/visible_strokes.h"
#include "felt/geometry/tilt.h"
#include "felt/io/limits.h"
#include "felt/stroke/color_text.h"
#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

/// Appends `items` as a JSON array. `append(item)` appends one element.
template <class Range, class Append>
void append_array(std::string& out, const Range& items, Append&& append) {
  out += '[';
  bool first = true;
  for (const auto& item : items) {
    if (!first) out += ',';
    first = false;
    append(item);
  }
  out += ']';
}

void append_numbers(std::string& out, std::span<const double> numbers) {
  append_array(out, numbers, [&out](double number) { append_number(out, number); });
}

void append_segments(std::string& out, const std::vector<Point>& points) {
  out += '[';
  for (std::size_t k = 0; k + 3 < points.size(); k += 3) {
    if (k > 0) out += ',';
    const Point *a = &points[k], *b = a + 1, *c = a + 2, *d = a + 3;
    append_numbers(out, std::array{a->x, a->y, b->x, b->y, c->x, c->y, d->x, d->y});
  }
  out += ']';
}

/// Converts nanoseconds to a number of milliseconds from which a reader gets the same nanoseconds.
double milliseconds(std::int64_t time_ns) {
  return static_cast<double>(time_ns) / 1e6;
}

}  // namespace

Result<void> check_sketch_numbers(const StrokeData& data) {
  const auto fits = [](double number) { return std::fabs(number) <= limits::kMaxSketchNumber; };
  const bool is_fine = std::all_of(data.points.begin(), data.points.end(),
                                   [&](Point p) { return fits(p.x) && fits(p.y); }) &&
                       std::all_of(data.widths.begin(), data.widths.end(),
                                   [&](const WidthKnot& knot) { return fits(knot.width_mm); });
  if (is_fine) return {};
  return fail(ErrorCode::kLimitExceeded, "extends beyond 1e10 mm, the limit of .ndjson");
}

void append_sketch_line(std::string& out, std::string_view id, const StrokeData& data) {
  out += R"({"id":)";
  append_json_string(out, id);
  out += data.closed ? R"(,"closed":true,"segments":)" : R"(,"closed":false,"segments":)";
  append_segments(out, data.points);
  out += R"(,"joints":)";
  append_array(out, data.joints, [&out](JointKind kind) {
    out += kind == JointKind::kSmooth ? R"("smooth")" : R"("corner")";
  });
  out += R"(,"widths":)";
  append_array(out, data.widths, [&out](const WidthKnot& knot) {
    append_numbers(out, std::array{knot.u, knot.width_mm});
  });
  if (has_own_tone(data.widths)) {
    out += R"(,"tones":)";
    append_array(out, data.widths,
                 [&out](const WidthKnot& knot) { append_number(out, knot.tone); });
  }
  static const StrokeData kDefault;
  if (data.medium != kDefault.medium) {
    out += R"(,"material":)";
    append_json_string(out, data.medium);
  }
  if (!(data.color == kDefault.color)) {
    out += R"(,"color":)";
    append_json_string(out, color_to_text(data.color));
  }
  out += "}\n";
}

void append_sketch_lines(std::string& out, const Document& document) {
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    for (const StrokeId id : layer.strokes) {
      append_sketch_line(out, stroke_name(id), document.find(id)->data());
    }
  }
}

void append_raw_line(std::string& out, std::string_view id, std::span<const InkSample> samples) {
  const auto has_time = [](const InkSample& s) { return s.time_ns.has_value(); };
  const auto has_pressure = [](const InkSample& s) { return s.pressure.has_value(); };
  const auto tilt_of = [](const InkSample& s) { return checked_tilt(s.tilt_deg); };
  const bool tilts = std::any_of(samples.begin(), samples.end(), tilt_of);
  const bool times = tilts || std::any_of(samples.begin(), samples.end(), has_time);
  const bool pressures = times || std::any_of(samples.begin(), samples.end(), has_pressure);
  const auto append_optional = [&out](bool present, double number) {
    out += ',';
    present ? append_number(out, number) : void(out += "null");
  };
  out += R"({"id":)";
  append_json_string(out, id);
  out += R"(,"points":)";
  append_array(out, samples, [&](const InkSample& sample) {
    out += '[';
    append_number(out, sample.position.x);
    out += ',';
    append_number(out, sample.position.y);
    if (pressures) append_optional(has_pressure(sample), sample.pressure.value_or(0.0));
    if (times) append_optional(has_time(sample), milliseconds(sample.time_ns.value_or(0)));
    if (const std::optional<double> tilt_deg = tilt_of(sample)) {
      out += R"(,{"tilt":)";
      append_number(out, *tilt_deg);
      out += '}';
    }
    out += ']';
  });
  out += "}\n";
}

}  // namespace felt
