#include "felt/io/inkml/inkml_import.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "felt/document/visible_strokes.h"
#include "felt/geometry/tilt.h"
#include "felt/io/drawing_builder.h"
#include "felt/io/ink_of_points.h"
#include "felt/io/inkml/inkml_model.h"
#include "felt/io/inkml/inkml_settings.h"
#include "felt/io/inkml/inkml_trace.h"
#include "felt/io/xml/xml_input.h"

namespace felt {
namespace {

using inkml::ChannelName;
using inkml::Context;

/// With a brush of width W and pressure p, Windows draws a line of width W (0.25 + 1.5 p).
constexpr double kLightest = 0.25, kHardest = 1.75;
/// The value for full pressure in an integer channel without a stated maximum.
constexpr double kUsualFullPressure = 32767.0;

/// Which of the values of a point become ink (by index), and the scale of each.
struct Columns {
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::size_t x = kNone, y = kNone, force = kNone, time = kNone, width = kNone, tip = kNone,
              eraser = kNone, tilt_x = kNone, tilt_y = kNone, elevation = kNone;
  Affine to_mm;
  double mm_per_width = 1.0, ms_per_time = 1.0;
  double min_force = 0.0, full_force = 1.0;
  double deg_per_tilt_x = 1.0, deg_per_tilt_y = 1.0, deg_per_elevation = 1.0;
};

/// Returns the tilt of the pen from its elevation above the surface, or from both of its tilt
/// angles.
std::optional<double> tilt_of(std::span<const double> v, const Columns& c) {
  if (c.elevation != Columns::kNone) {
    const double above_deg = std::fabs(v[c.elevation] * c.deg_per_elevation);
    if (above_deg <= kMaxTiltDeg) return kMaxTiltDeg - above_deg;
  }
  if (c.tilt_x == Columns::kNone || c.tilt_y == Columns::kNone) return std::nullopt;
  return tilt_of_xy(v[c.tilt_x] * c.deg_per_tilt_x, v[c.tilt_y] * c.deg_per_tilt_y);
}

/// The points of a stroke while they are collected.
struct Points {
  std::vector<InkSample> samples;
  std::vector<WidePoint> line;  // the same points with widths, if the trace has them
  bool has_force = false, is_erased = false;
  bool has_far_time = false;  // a time was beyond limits::kMaxTimeMs and was ignored

  void clear() {
    samples.clear();
    line.clear();
    has_force = is_erased = has_far_time = false;
  }
};

class InkmlReader {
 public:
  InkmlReader(const XmlInput& input, const ImportOptions& options)
      : input_(input), ink_(solid_fit(options.fit)), settings_(input, report_) {}

  Result<Imported> read() {
    const pugi::xml_node root = input_.root();
    if (xml_local_name(root.name()) != "ink") {
      return fail(ErrorCode::kInvalidData, "line " + std::to_string(input_.line_of(root)) +
                                               ": not InkML: the first element is '" + root.name() +
                                               "'");
    }
    const std::string_view name = root.name();
    prefix_ = name.substr(0, name.size() - 3);
    felt_ = xml_prefix_of(root, inkml::kFeltNamespace);
    if (!felt_.empty() && !inkml::read_page(root, felt_, builder_.drawing())) {
      notice(root, "has an invalid or too long material, which was skipped");
    }
    find_traces(root);
    groups_.push_back({});
    walk(root);
    if (builder_.layer_count() == 0 && felt_.empty()) builder_.add_layer({});
    if (const int others = input_.other_roots(); others > 0) {
      notice(root, "ends before the file does; the documents after it (" + std::to_string(others) +
                       ") were skipped");
    }
    return Imported{std::move(builder_).build(), std::move(report_)};
  }

 private:
  /// The settings inside the element that is being read.
  struct Group {
    Context context;
    bool only_defines = false;              // inside definitions
    std::optional<std::size_t> layer = {};  // layer of its ink, if the element is in a layer
  };

  void notice(const pugi::xml_node& node, std::string what) {
    report_.add(input_.line_of(node), XmlInput::describe(node), std::move(what));
  }

  // Files mix elements with and without the prefix of the root.
  [[nodiscard]] bool is_ink(const pugi::xml_node& node) const {
    const std::string_view name = node.name();
    const std::string_view prefix = name.substr(0, name.size() - xml_local_name(name).size());
    return prefix.empty() || prefix == "inkml:" || prefix == prefix_;
  }

  /// Returns the next node below `root` in document order: the first child if `inside`, else the
  /// next one after this node. Calls `leave` for each element that ends in between.
  template <class Leave>
  static pugi::xml_node next_node(pugi::xml_node node, const pugi::xml_node& root, bool inside,
                                  Leave&& leave) {
    if (inside && node.first_child()) return node.first_child();
    if (inside) leave();
    while (node != root && !node.next_sibling()) {
      node = node.parent();
      if (node != root) leave();
    }
    return node == root ? pugi::xml_node() : node.next_sibling();
  }

  // Collects traces that continue an earlier one, and traces with ids, which a view may show.
  void find_traces(const pugi::xml_node& root) {
    for (pugi::xml_node node = root.first_child(); node;
         node = next_node(node, root, true, [] {})) {
      if (xml_local_name(node.name()) != "trace") continue;
      if (const char* id = node.attribute("xml:id").value(); *id != '\0') by_id_.emplace(id, node);
      const std::string_view prior = node.attribute("priorRef").value();
      if (prior.size() > 1 && prior.front() == '#') followers_.emplace(prior.substr(1), node);
    }
  }

  void walk(const pugi::xml_node& root) {
    pugi::xml_node node = root.first_child();
    while (node) {
      const bool inside = enter(node);
      node = next_node(node, root, inside, [&] { groups_.pop_back(); });
    }
  }

  /// Processes an element. Returns true if its children are to be read, after pushing a group for
  /// them.
  bool enter(const pugi::xml_node& node) {
    if (node.type() != pugi::node_element) return false;
    const std::string_view name = xml_local_name(node.name());
    if (!is_ink(node)) {
      notice(node, "belongs to another program and was skipped");
    } else if (name == "trace") {
      if (!groups_.back().only_defines && !drawn_.count(node.hash_value())) read_trace(node);
    } else if (name == "traceGroup") {
      groups_.push_back(group_of(node));
      return true;
    } else if (name == "definitions") {
      groups_.push_back(groups_.back());
      groups_.back().only_defines = true;
      return true;
    } else if (name == "traceView") {
      view(node);
      groups_.push_back(groups_.back());
      return true;
    } else if (Context defined; settings_.define(node, defined)) {
      if (!groups_.back().only_defines)
        groups_.back().context = groups_.back().context.overlaid(defined);
    } else if (name != "annotation" && name != "annotationXML") {
      notice(node, "is unknown and was skipped");
    }
    return false;
  }

  Group group_of(const pugi::xml_node& node) {
    Group group = groups_.back();
    group.context = group.context.overlaid(settings_.referred(node));
    if (felt_.empty() || group.only_defines) return group;
    const pugi::xml_attribute layer = node.attribute((felt_ + "layer").c_str());
    if (!layer) return group;
    const std::string_view label = layer.value();
    if (label.size() > limits::kMaxNameBytes) {
      notice(node, "has a name of more than 4096 bytes, which was skipped");
    }
    LayerState state{.name = std::string(label)};
    read_look(node, "", state);
    if (const std::uint64_t number = node.attribute((felt_ + "group").c_str()).as_ullong()) {
      LayerGroup layers{.id = {number},
                        .name = node.attribute((felt_ + "group-name").c_str()).value()};
      read_look(node, "group-", layers);
      state.group = std::make_shared<const LayerGroup>(std::move(layers));
    }
    group.layer = builder_.add_layer(std::move(state));
    return group;
  }

  /// Reads the attributes of a layer or of a group of layers. Invalid values have no effect.
  template <class State>
  void read_look(const pugi::xml_node& node, const std::string& prefix, State& state) {
    const auto value = [&](const char* key) -> std::string_view {
      return node.attribute((felt_ + prefix + key).c_str()).value();
    };
    state.visible = value("visible") != "false";
    state.locked = value("locked") == "true";
    const double opacity = inkml::number_of(value("opacity")).value_or(1.0);
    if (opacity >= 0.0 && opacity <= 1.0) state.opacity = opacity;
    const std::string_view mode = value("blend");
    state.blend = blend_mode_of(mode).value_or(BlendMode::kNormal);
    if (!mode.empty() && !blend_mode_of(mode)) {
      notice(node, "has a blend mode that is not supported, which was ignored");
    }
  }

  // A view of a trace that is drawn in its own place adds no ink. A view of a trace in definitions
  // draws that trace.
  void view(const pugi::xml_node& node) {
    const std::string_view ref = node.attribute("traceDataRef").value();
    if (ref.empty() || groups_.back().only_defines) return;
    const auto found = by_id_.find(ref.front() == '#' ? ref.substr(1) : ref);
    if (found == by_id_.end()) return;
    bool only_defined = false;
    for (pugi::xml_node up = found->second.parent(); up; up = up.parent()) {
      only_defined = only_defined || xml_local_name(up.name()) == "definitions";
    }
    if (!only_defined || drawn_.count(found->second.hash_value())) return;
    if (node.attribute("from") || node.attribute("to")) {
      notice(node, "shows part of a trace; the whole trace was read");
    }
    drawn_.insert(found->second.hash_value());
    read_trace(found->second);
  }

  void read_trace(const pugi::xml_node& node) {
    points_.clear();
    Context context = groups_.back().context.overlaid(settings_.referred(node));
    gather(node, context);
    // Traces that continue this one belong to the same stroke. Each is used once.
    std::string_view id = node.attribute("xml:id").value();
    while (!id.empty() && !followers_.empty()) {
      const auto found = followers_.find(id);
      if (found == followers_.end()) break;
      const pugi::xml_node follower = found->second;
      followers_.erase(found);
      if (follower == node || !drawn_.insert(follower.hash_value()).second) break;
      gather(follower, groups_.back().context.overlaid(settings_.referred(follower)));
      id = follower.attribute("xml:id").value();
    }
    add_stroke(node, context);
  }

  void gather(const pugi::xml_node& node, const Context& context) {
    const std::string_view type = node.attribute("type").value();
    if (type == "penUp") {
      notice(node, "was made with the pen off the paper and was skipped");
      return;
    }
    const inkml::Format& format = settings_.format(context);
    const Columns& columns = columns_of(node, context);
    if (columns.x == Columns::kNone || columns.y == Columns::kNone) {
      notice(node, "has no X or no Y and was skipped");
      return;
    }
    const std::string text = xml_text_of(node);
    InkmlTraceReader reader(text, format.channels.size());
    const bool has_model = !felt_.empty() && node.attribute((felt_ + "points").c_str());
    while (reader.next()) {
      add_point(reader.values(), columns);
      if (points_.samples.size() >= limits::kMaxStrokePoints && !has_model) cut(node, context);
    }
    if (!reader.problem().empty()) {
      notice(node, reader.problem() + "; only the points before it were read");
    }
  }

  void add_point(std::span<const double> v, const Columns& c) {
    const auto has = [&](std::size_t column) {
      return column != Columns::kNone && !std::isnan(v[column]);
    };
    if (has(c.eraser) && v[c.eraser] > 0.5) points_.is_erased = true;
    if (std::isnan(v[c.x]) || std::isnan(v[c.y]) || (has(c.tip) && v[c.tip] < 0.5)) return;
    InkSample sample{apply(c.to_mm, Point{v[c.x], v[c.y]}), {}, {}};
    if (has(c.force)) {
      sample.pressure = (v[c.force] - c.min_force) / (c.full_force - c.min_force);
      points_.has_force = true;
    }
    if (has(c.time)) {
      const double ms = v[c.time] * c.ms_per_time;
      if (std::fabs(ms) <= limits::kMaxTimeMs) {
        sample.time_ns = std::llround(ms * 1e6);
      } else {
        points_.has_far_time = true;
      }
    }
    sample.tilt_deg = tilt_of(v, c);
    if (has(c.width)) points_.line.push_back({sample.position, v[c.width] * c.mm_per_width});
    points_.samples.push_back(sample);
  }

  // Returns the columns for a trace. They are computed only once for all traces of the same kind,
  // and problems are reported only once.
  const Columns& columns_of(const pugi::xml_node& node, const Context& context) {
    const std::array key = {context.format, context.source, context.transform, context.canvas};
    const auto [place, is_new] = columns_.try_emplace(key);
    if (is_new) place->second = find_columns(node, context);
    return place->second;
  }

  Columns find_columns(const pugi::xml_node& node, const Context& context) {
    Columns c;
    const inkml::Format& format = settings_.format(context);
    const std::vector<inkml::Resolution>& resolutions = settings_.resolutions(context);
    double scale_x = 0.0, scale_y = 0.0;
    for (std::size_t i = 0; i < format.channels.size(); ++i) {
      const inkml::Channel& channel = format.channels[i];
      const std::optional<double> scale = inkml::scale_of(channel, resolutions);
      if (channel.name == ChannelName::kX || channel.name == ChannelName::kY) {
        const double mm = scale.value_or(kInkmlMmPerUnknownUnit) * (channel.is_reversed ? -1 : 1);
        const bool is_x = channel.name == ChannelName::kX;
        if (!scale && is_x) {
          notice(node, "does not define its unit; 1/96 inch was assumed");
        }
        (is_x ? c.x : c.y) = i;
        (is_x ? scale_x : scale_y) = mm;
      } else if (channel.name == ChannelName::kForce) {
        c.force = i;
        c.min_force = channel.smallest.value_or(0.0);
        if (channel.is_integer && !channel.largest) {
          notice(node, "does not define its largest pressure; 32767 was assumed");
        }
        c.full_force = channel.largest.value_or(channel.is_integer ? kUsualFullPressure : 1.0);
        if (!(c.full_force > c.min_force)) c.force = Columns::kNone;
      } else if (channel.name == ChannelName::kTime) {
        c.time = i;
        c.ms_per_time = scale.value_or(1.0);
      } else if (channel.name == ChannelName::kWidth) {
        c.width = i;
        if (!scale) notice(node, "has widths without a unit; mm was assumed");
        c.mm_per_width = scale.value_or(1.0);
      } else if (channel.name == ChannelName::kTiltX) {
        c.tilt_x = i;
        c.deg_per_tilt_x = scale.value_or(1.0);
      } else if (channel.name == ChannelName::kTiltY) {
        c.tilt_y = i;
        c.deg_per_tilt_y = scale.value_or(1.0);
      } else if (channel.name == ChannelName::kElevation) {
        c.elevation = i;
        c.deg_per_elevation = scale.value_or(1.0);
      } else if (channel.name == ChannelName::kTip) {
        c.tip = i;
      } else if (channel.name == ChannelName::kEraser) {
        c.eraser = i;
      }
    }
    set_transform(context, scale_x, scale_y, c);
    return c;
  }

  // Sets the map from values to mm. If there is a transform, it maps values to the canvas first.
  // Then the units of the canvas give mm, or those of the device if the canvas has no units.
  void set_transform(const Context& context, double scale_x, double scale_y, Columns& c) const {
    const Affine* transform = settings_.transform(context);
    if (transform == nullptr) {
      c.to_mm = scaling(scale_x, scale_y);
      return;
    }
    if (const inkml::Format* canvas = settings_.canvas_format(context)) {
      for (const inkml::Channel& channel : canvas->channels) {
        const std::optional<double> mm = inkml::scale_of(channel, {});
        if (!mm) continue;
        const double signed_mm = *mm * (channel.is_reversed ? -1 : 1);
        if (channel.name == ChannelName::kX) scale_x = signed_mm;
        if (channel.name == ChannelName::kY) scale_y = signed_mm;
      }
    }
    c.to_mm = then(*transform, scaling(scale_x, scale_y));
    c.mm_per_width *= std::sqrt(std::fabs(determinant(*transform)));
  }

  // Divides a trace that is too long into several strokes. Each next stroke begins at the end of
  // the previous one.
  void cut(const pugi::xml_node& node, const Context& context) {
    notice(node, "has more points than a stroke can have (" +
                     std::to_string(limits::kMaxStrokePoints) +
                     "); it was split into several strokes");
    const InkSample last = points_.samples.back();
    const std::vector<WidePoint> width(points_.line.end() - (points_.line.empty() ? 0 : 1),
                                       points_.line.end());
    add_stroke(node, context);
    points_.clear();
    points_.samples.push_back(last);
    points_.line = width;
    points_.has_force = last.pressure.has_value();
  }

  void add_stroke(const pugi::xml_node& node, const Context& context) {
    if (points_.samples.empty()) {
      if (std::string_view(node.attribute("type").value()) != "penUp") {
        notice(node, "has no points and was skipped");
      }
      return;
    }
    if (points_.is_erased) {
      notice(node, "was made with the eraser end and was skipped");
      return;
    }
    const inkml::Brush* brush = settings_.brush(context);
    const Rgba color = brush != nullptr ? brush->color : Rgba{};
    std::optional<Result<NamedStroke>> exact = inkml::read_model(node, felt_, points_.line, color);
    if (exact && *exact) {
      NamedStroke& ours = **exact;
      const char* number = node.attribute((felt_ + "number").c_str()).value();
      builder_.add(layer(), std::move(ours.stroke), ours.id, number);
      return;
    }
    if (exact) notice(node, exact->error().message);
    Result<StrokeData> data = ink(brush);
    if (data) data->color = color;
    Result<Stroke> stroke = data ? Stroke::create(*std::move(data)) : tl::unexpected(data.error());
    if (!stroke) {
      notice(node, "was skipped: " + stroke.error().message);
      return;
    }
    const char* id =
        node.attribute("xml:id") ? node.attribute("xml:id").value() : node.attribute("id").value();
    ++stroke_count_;
    const bool is_named = *id != '\0' && std::string_view(id).size() <= limits::kMaxNameBytes;
    const std::string name = is_named ? id : stroke_name({stroke_count_});
    if (points_.has_far_time) notice(node, "has times beyond 9e12 ms, which were ignored");
    if (points_.line.size() != points_.samples.size()) {
      report_.add_faults(input_.line_of(node), name, ink_.sample_faults());
    }
    builder_.add(layer(), *std::move(stroke), name);
  }

  Result<StrokeData> ink(const inkml::Brush* brush) {
    if (points_.line.size() == points_.samples.size()) return ink_.of_line(points_.line);
    if (brush == nullptr || !brush->width_mm) return ink_.of_samples(points_.samples);
    WidthMapOptions widths;
    const double width_mm = *brush->width_mm;
    const bool varies = points_.has_force && !brush->ignores_pressure;
    widths.min_mm = std::max(kMinWidthMm, width_mm * (varies ? kLightest : 1.0));
    widths.max_mm = std::max(widths.min_mm, width_mm * (varies ? kHardest : 1.0));
    return ink_.of_samples(points_.samples, widths);
  }

  /// Returns the layer for ink: that of the group, or the one for all ink outside layers.
  std::size_t layer() {
    if (groups_.back().layer) return *groups_.back().layer;
    if (!loose_layer_) loose_layer_ = builder_.add_layer({});
    return *loose_layer_;
  }

  const XmlInput& input_;
  InkOfPoints ink_;
  DrawingBuilder builder_;
  ImportReport report_;
  inkml::Settings settings_;
  std::string prefix_, felt_;
  std::vector<Group> groups_;
  std::map<std::string, pugi::xml_node, std::less<>> by_id_;
  std::multimap<std::string, pugi::xml_node, std::less<>> followers_;
  std::set<std::size_t> drawn_;
  std::map<std::array<int, 4>, Columns> columns_;
  Points points_;
  std::optional<std::size_t> loose_layer_;
  std::uint64_t stroke_count_ = 0;
};

}  // namespace

Result<Imported> import_inkml(std::string_view bytes, const ImportOptions& options) {
  const Result<XmlInput> input = XmlInput::parse(bytes);
  if (!input) return tl::unexpected(input.error());
  return InkmlReader(*input, options).read();
}

}  // namespace felt
