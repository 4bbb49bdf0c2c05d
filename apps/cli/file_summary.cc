#include "file_summary.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "felt/base/printable.h"
#include "felt/formats/format_traits.h"
#include "felt/io/ndjson/json_text.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/store/felt_recording.h"
#include "felt/stroke/color_text.h"

namespace felt::cli {
namespace {

/// The figures of a summary in output order, each with its key and its text.
using Figures = std::vector<std::pair<const char*, std::string>>;

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string bounds_json(const Rect& bounds) {
  if (bounds.empty()) return "null";
  return "[" + number(bounds.x0) + "," + number(bounds.y0) + "," + number(bounds.x1) + "," +
         number(bounds.y1) + "]";
}

Figures figures_of(const FileSummary& s) {
  Figures figures = {{"strokes", std::to_string(s.strokes)}};
  if (s.is_sketch) {
    figures.insert(figures.end(), {{"segments", std::to_string(s.segments)},
                                   {"corners", std::to_string(s.corners)},
                                   {"closed", std::to_string(s.closed)},
                                   {"width_knots", std::to_string(s.width_knots)},
                                   {"min_width_mm", number(s.min_width_mm)},
                                   {"max_width_mm", number(s.max_width_mm)},
                                   {"bounds_mm", bounds_json(s.bounds)}});
  } else {
    figures.insert(figures.end(), {{"samples", std::to_string(s.samples)},
                                   {"longest_stroke", std::to_string(s.longest)},
                                   {"with_pressure", std::to_string(s.with_pressure)},
                                   {"with_time", std::to_string(s.with_time)},
                                   {"bounds", bounds_json(s.bounds)}});
  }
  return figures;
}

const char* kind_of(const FileSummary& s) {
  return s.is_sketch ? "sketch" : "raw";
}

std::string page_text(const Imported& opened) {
  const Page& page = opened.drawing.page;
  return opened.drawing.has_page ? fmt::format("{} x {} mm, {}", number(page.width_mm),
                                               number(page.height_mm), color_to_text(page.paper))
                                 : "none";
}

std::string picture_text(const LayerPicture& picture) {
  return fmt::format("a picture of {} x {} pixels{}", picture.data->width_px,
                     picture.data->height_px, picture.exported ? " (shown in exported files)" : "");
}

std::string picture_json(const LayerPicture& picture) {
  return fmt::format(R"({{"width_px":{},"height_px":{},"exported":{}}})", picture.data->width_px,
                     picture.data->height_px, picture.exported);
}

/// Returns the name and the look of a layer or a group of layers.
template <class State>
std::string look_text(const State& state) {
  std::string text = fmt::format("'{}'{}{}", printable(state.name), state.visible ? "" : ", hidden",
                                 state.locked ? ", locked" : "");
  if (state.opacity != 1.0) text += ", opacity " + number(state.opacity);
  if (state.blend != BlendMode::kNormal) text += fmt::format(", {}", blend_mode_name(state.blend));
  return text;
}

/// Returns a line for each layer, starting with the lowest. A line contains the number for
/// --layers, the numbers of strokes and fills, the name, and its state: hidden, locked, opacity,
/// blend mode, picture, group, and timing as a key drawing. A line with a group comes before its
/// lowest layer.
std::string layers_text(const Imported& opened) {
  std::string text;
  int place = 0;
  LayerGroupPtr group;
  for (const Layer& layer : opened.drawing.document.layers()) {
    if (layer.group && !same_group(layer.group, group)) {
      text += fmt::format("{:16}{}\n", fmt::format("group {}", layer.group->id.value),
                          look_text(*layer.group));
    }
    group = layer.group;
    text +=
        fmt::format("{:16}{} strokes, {}{}", fmt::format("layer {}", ++place), layer.strokes.size(),
                    layer.fills.empty() ? "" : fmt::format("{} fills, ", layer.fills.size()),
                    look_text(layer.state()));
    if (layer.picture) text += ", " + picture_text(*layer.picture);
    if (group) text += fmt::format(", in group {}", group->id.value);
    if (layer.timing) {
      text += fmt::format(", {} in-betweens, hold {}", layer.timing->between, layer.timing->hold);
    }
    text += '\n';
  }
  const Document& document = opened.drawing.document;
  if (!document.guides().empty()) {
    text += fmt::format("{:16}{}{}\n", "guides", document.guides().size(),
                        document.shows_guides() ? "" : ", hidden");
  }
  if (!document.body_edits().empty()) {
    text += fmt::format("{:16}{}\n", "body edits", document.body_edits().size());
  }
  return text;
}

std::string group_json(const LayerGroup& group) {
  return fmt::format(R"({{"id":{},"name":{},"visible":{},"locked":{},"opacity":{},"blend":"{}"}})",
                     group.id.value, json_string(group.name), group.visible, group.locked,
                     number(group.opacity), blend_mode_name(group.blend));
}

std::string layers_json(const Imported& opened) {
  std::vector<std::string> layers;
  for (const Layer& layer : opened.drawing.document.layers()) {
    layers.push_back(fmt::format(
        R"({{"name":{},"visible":{},"locked":{},"strokes":{},"fills":{},"opacity":{},"picture":{},"blend":"{}","group":{}}})",
        json_string(layer.name), layer.own_visible, layer.own_locked, layer.strokes.size(),
        layer.fills.size(), number(layer.opacity),
        layer.picture ? picture_json(*layer.picture) : "null", blend_mode_name(layer.blend),
        layer.group ? group_json(*layer.group) : "null"));
  }
  return json_array(layers);
}

/// Returns the recordings in the drawing. Returns an empty list if they are damaged; `replay`
/// reports that as an error.
std::vector<RecordingInfo> recordings(const Imported& opened) {
  return recordings_of(opened.drawing).value_or(std::vector<RecordingInfo>());
}

std::string recordings_text(const Imported& opened) {
  std::string text;
  int place = 0;
  for (const RecordingInfo& r : recordings(opened)) {
    text += fmt::format("{:16}{} samples, {} events, {:.3f} s, of '{}'\n",
                        fmt::format("recording {}", ++place), r.samples, r.events, r.duration_s,
                        printable(r.device));
  }
  return text;
}

std::string recordings_json(const Imported& opened) {
  std::vector<std::string> all;
  for (const RecordingInfo& r : recordings(opened)) {
    all.push_back(fmt::format(R"({{"device":{},"samples":{},"events":{},"duration_s":{}}})",
                              json_string(r.device), r.samples, r.events, number(r.duration_s)));
  }
  return json_array(all);
}

std::string page_json(const Imported& opened) {
  const Page& page = opened.drawing.page;
  if (!opened.drawing.has_page) return "null";
  return fmt::format(R"({{"width_mm":{},"height_mm":{},"paper":"{}"}})", number(page.width_mm),
                     number(page.height_mm), color_to_text(page.paper));
}

std::string notices_json(const Imported& opened) {
  std::vector<std::string> notices;
  for (const ImportNotice& notice : opened.report.notices()) {
    notices.push_back(fmt::format(R"({{"line":{},"element":{},"what":{},"count":{}}})", notice.line,
                                  json_string(notice.element), json_string(notice.what),
                                  notice.count));
  }
  return json_array(notices);
}

}  // namespace

void FileSummary::add(const Stroke& stroke) {
  is_sketch = true;
  const StrokeData& data = stroke.data();
  for (const WidthKnot& knot : data.widths) {
    const bool first = width_knots++ == 0;
    min_width_mm = first ? knot.width_mm : std::min(min_width_mm, knot.width_mm);
    max_width_mm = first ? knot.width_mm : std::max(max_width_mm, knot.width_mm);
  }
  ++strokes;
  segments += stroke.segment_count();
  corners += std::count(data.joints.begin(), data.joints.end(), JointKind::kCorner);
  closed += stroke.closed() ? 1 : 0;
  bounds.extend(stroke.bounds());
}

void FileSummary::add(const RawStroke& stroke) {
  bool pressure = false, time = false;
  for (const InkSample& sample : stroke.samples) {
    bounds.extend(sample.position);
    pressure = pressure || sample.pressure.has_value();
    time = time || sample.time_ns.has_value();
  }
  const auto count = static_cast<std::int64_t>(stroke.samples.size());
  ++strokes;
  samples += count;
  longest = std::max(longest, count);
  with_pressure += pressure ? 1 : 0;
  with_time += time ? 1 : 0;
}

std::string summary_text(const FileSummary& summary) {
  std::string text = fmt::format("{:16}{}\n", "kind", kind_of(summary));
  for (const auto& [key, value] : figures_of(summary)) {
    text += fmt::format("{:16}{}\n", key, value);
  }
  text += fmt::format("{:16}{}\n", "format", traits_of(summary.format).title);
  if (!summary.opened) return text;
  text += fmt::format("{:16}{}\n", "page", page_text(*summary.opened));
  return text + layers_text(*summary.opened) + recordings_text(*summary.opened);
}

std::string summary_json(const FileSummary& summary) {
  std::string text = fmt::format(R"({{"kind":"{}")", kind_of(summary));
  for (const auto& [key, value] : figures_of(summary)) {
    text += fmt::format(R"(,"{}":{})", key, value);
  }
  text += fmt::format(R"(,"format":"{}")", traits_of(summary.format).name);
  if (summary.opened) {
    text += R"(,"page":)" + page_json(*summary.opened);
    text += R"(,"layers":)" + layers_json(*summary.opened);
    text += R"(,"recordings":)" + recordings_json(*summary.opened);
    text += R"(,"notices":)" + notices_json(*summary.opened);
  }
  return text + "}\n";
}

}  // namespace felt::cli
