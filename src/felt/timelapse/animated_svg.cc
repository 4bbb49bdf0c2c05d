#include "felt/timelapse/animated_svg.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "felt/io/fill_path.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/io/svg/svg_elements.h"
#include "felt/render/styled_outline.h"
#include "felt/stroke/color_text.h"
#include "felt/stroke/outline/outline_path.h"
#include "felt/timelapse/drawing_time.h"
#include "felt/timelapse/stroke_lives.h"
#include "felt/tools/tool.h"

namespace felt {
namespace {

constexpr double kFilmToleranceMm = 0.02;
constexpr double kFilmStepsPerMm = 100.0;

/// The line that uncovers a stroke is wider than the stroke by this factor, because the ink of a
/// bend may be beside its centre line.
constexpr double kCoverFactor = 1.5;

Point on_grid(Point p) noexcept {
  return {std::round(p.x * kFilmStepsPerMm) / kFilmStepsPerMm,
          std::round(p.y * kFilmStepsPerMm) / kFilmStepsPerMm};
}

OutlinePath on_grid(OutlinePath path) {
  for (Point& p : path.points) p = on_grid(p);
  return path;
}

/// Returns the centre line of a stroke.
OutlinePath center_line(const Stroke& stroke) {
  OutlinePath path;
  path.points = stroke.data().points;
  path.verbs.assign(1, OutlinePath::Verb::kMove);
  path.verbs.resize(1 + static_cast<std::size_t>(stroke.segment_count()),
                    OutlinePath::Verb::kCubic);
  return on_grid(std::move(path));
}

void append_attribute(std::string& out, std::string_view name, double value) {
  out += ' ';
  out += name;
  out += "=\"";
  append_number(out, std::round(value * 1e3) / 1e3);
  out += '"';
}

void append_fill_color(std::string& out, Rgba color) {
  out += " fill=\"" + color_to_text({color.r, color.g, color.b, 255}) + '"';
  if (color.a != 255) append_attribute(out, "fill-opacity", color.a / 255.0);
}

/// Writes shapes with their animations.
class FilmShapes {
 public:
  FilmShapes(const FilmTiming& timing, const StrokeStyles& styles, std::string& out)
      : timing_(timing), styles_(styles), out_(out) {}

  Result<void> add(const ShapeLife& life) {
    const auto* stroke = std::get_if<StrokePtr>(&life.shape);
    const Rect box = stroke ? (*stroke)->bounds() : fill_bounds(*std::get<FillPtr>(life.shape));
    if (std::max({-box.x0, -box.y0, box.x1, box.y1}) > kMaxCoordinateMm) {
      return fail(ErrorCode::kLimitExceeded, "the ink extends beyond 1e9 mm");
    }
    const double drawn_s = seconds(life.drawn_from_ns),
                 done_s = seconds(life.times.front().from_ns);
    const bool is_drawn = stroke && done_s > drawn_s;
    if (is_drawn) append_mask(**stroke, box, drawn_s, done_s);
    out_ += "<path";
    if (stroke) {
      append_fill_color(out_, (*stroke)->color());
    } else {
      append_fill_color(out_, std::get<FillPtr>(life.shape)->color);
      out_ += " fill-rule=\"evenodd\"";
    }
    if (life.times.back().to_ns) out_ += " display=\"none\"";
    out_ += " d=\"";
    append_path_data(out_, on_grid(stroke ? styled_path(**stroke, styles_.find((*stroke)->medium()),
                                                        kFilmToleranceMm)
                                          : fill_path(*std::get<FillPtr>(life.shape))));
    out_ += "\">";
    append_life(life, drawn_s);
    if (is_drawn) {
      append_set("mask", "url(#m" + std::to_string(masks_) + ')', drawn_s, done_s);
    }
    out_ += "</path>\n";
    return {};
  }

 private:
  [[nodiscard]] double seconds(std::int64_t drawing_ns) const noexcept {
    return std::round(1e3 * timing_.film_s(drawing_ns)) / 1e3;
  }

  /// Appends a mask in which the path of the stroke grows from its start to its end.
  void append_mask(const Stroke& stroke, const Rect& box, double from_s, double to_s) {
    double width_mm = 0.0;
    for (const WidthKnot& k : stroke.widths()) width_mm = std::max(width_mm, k.width_mm);
    const Rect area = box.inflated(width_mm);
    out_ += "<mask id=\"m" + std::to_string(++masks_) + "\" maskUnits=\"userSpaceOnUse\"";
    append_attribute(out_, "x", area.x0);
    append_attribute(out_, "y", area.y0);
    append_attribute(out_, "width", area.width());
    append_attribute(out_, "height", area.height());
    out_ +=
        "><path fill=\"none\" stroke=\"#fff\" stroke-linecap=\"round\" stroke-linejoin=\"round\"";
    append_attribute(out_, "stroke-width", kCoverFactor * width_mm);
    out_ += " pathLength=\"1\" stroke-dasharray=\"1 2\" stroke-dashoffset=\"1\" d=\"";
    append_path_data(out_, center_line(stroke));
    out_ += "\"><animate attributeName=\"stroke-dashoffset\" from=\"1\" to=\"0\"";
    append_times(from_s, to_s);
    out_ += " fill=\"freeze\"/></path></mask>\n";
  }

  void append_times(double from_s, double to_s) {
    out_ += " begin=\"";
    append_number(out_, from_s);
    out_ += "s\" dur=\"";
    append_number(out_, std::round(1e3 * (to_s - from_s)) / 1e3);
    out_ += "s\"";
  }

  void append_set(std::string_view name, const std::string& value, double from_s, double to_s) {
    if (to_s <= from_s) return;
    out_ += "<set attributeName=\"";
    out_ += name;
    out_ += "\" to=\"" + value + '"';
    append_times(from_s, to_s);
    out_ += "/>";
  }

  /// Shows the shape in the times of its life, the first of which begins at `shown_s`. Without
  /// animations, only shapes that are there at the end are seen.
  void append_life(const ShapeLife& life, double shown_s) {
    const bool is_seen_at_end = !life.times.back().to_ns;
    double gone_s = 0.0;
    for (const SeenTime& time : life.times) {
      const double from_s = &time == &life.times.front() ? shown_s : seconds(time.from_ns);
      if (is_seen_at_end) append_set("display", "none", gone_s, from_s);
      if (!time.to_ns) break;
      gone_s = seconds(*time.to_ns);
      if (!is_seen_at_end) append_set("display", "inline", from_s, gone_s);
    }
  }

  const FilmTiming& timing_;
  const StrokeStyles& styles_;
  std::string& out_;
  std::size_t masks_ = 0;
};

/// What a recording has made in the end.
struct EndOfRecording {
  Document document;
  Materials materials;
};

/// Plays the recording and collects the shapes. Sets `end`.
Result<void> collect(const TimelapseSource& source, StrokeLives& lives, EndOfRecording& end) {
  std::vector<Edit> edits;
  Session session = session_of(source, [&edits](const Edit& edit) { edits.push_back(edit); });
  lives.see_start(source.start.document);
  DrawingTime time;
  bool is_down = false;
  std::optional<std::int64_t> touched_ns;
  std::vector<LayerId> hidden;
  const auto see_edits = [&] {
    const bool draws = session.tool().info().kind == ToolKind::kDraws;
    for (const Edit& edit : std::exchange(edits, {})) {
      lives.see(edit, session.seen(), time.now_ns(), draws ? touched_ns : std::nullopt);
    }
    if (std::exchange(hidden, session.out_of_view()) != hidden) {
      lives.see_view(session.seen(), time.now_ns());
    }
  };
  const Result<void> done = play_source(source, session, [&](const Event& event) -> Result<void> {
    see_edits();  // of the event before
    const std::int64_t now_ns = time.at(event);
    if (const auto* pen = std::get_if<PenEvent>(&event.what)) {
      const bool was_down = std::exchange(is_down, in_contact(sample_of(event.time_ns, *pen)));
      if (is_down && !was_down) touched_ns = now_ns;
    } else {
      touched_ns.reset();  // what this event adds is not drawn
    }
    return {};
  });
  see_edits();
  end = {session.document(), session.materials()};
  return done;
}

/// Returns the shapes of a layer in drawing order: those that are seen at the end in their order,
/// and the others above what was the last shape before them.
std::vector<const ShapeLife*> in_order(const StrokeLives& lives, LayerId id, const Layer* layer) {
  std::map<std::uint64_t, std::size_t> ranks;
  if (layer != nullptr) {
    for (const FillId fill : layer->fills) ranks.emplace(fill.value, ranks.size());
    for (const StrokeId stroke : layer->strokes) ranks.emplace(stroke.value, ranks.size());
  }
  std::vector<std::pair<std::size_t, const ShapeLife*>> ranked;
  std::size_t rank = 0;
  for (const ShapeLife& life : lives.all()) {
    if (life.layer != id) continue;
    if (const auto found = ranks.find(life.id); found != ranks.end()) rank = found->second;
    ranked.emplace_back(rank, &life);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const ShapeLife*> shapes;
  shapes.reserve(ranked.size());
  for (const auto& [at, life] : ranked) shapes.push_back(life);
  return shapes;
}

void append_group_begin(std::string& out, double opacity, BlendMode blend) {
  out += "<g";
  if (opacity < 1.0) append_attribute(out, "opacity", opacity);
  if (blend != BlendMode::kNormal) {
    out += " style=\"mix-blend-mode:";
    out += blend_mode_name(blend);
    out += '"';
  }
  out += ">\n";
}

/// Appends the layers that are gone at the end, and then the others, the lowest first.
Result<void> append_layers(std::string& out, const StrokeLives& lives, const Document& end,
                           const FilmTiming& timing, const StrokeStyles& styles) {
  FilmShapes shapes(timing, styles, out);
  std::vector<LayerId> order;
  for (const ShapeLife& life : lives.all()) {
    const bool is_gone = end.layer(life.layer) == nullptr;
    if (is_gone && std::find(order.begin(), order.end(), life.layer) == order.end()) {
      order.push_back(life.layer);
    }
  }
  for (const Layer& layer : end.layers()) order.push_back(layer.id);
  LayerGroupPtr open;
  for (const LayerId id : order) {
    const Layer* layer = end.layer(id);
    const LayerGroupPtr group =
        layer && layer->group && layer->group->is_whole() ? layer->group : nullptr;
    if (!equal_groups(group, open)) {
      if (open) out += "</g>\n";
      if (group) append_group_begin(out, group->opacity, group->blend);
      open = group;
    }
    append_group_begin(out, layer ? layer->opacity : 1.0,
                       layer ? layer->blend : BlendMode::kNormal);
    for (const ShapeLife* life : in_order(lives, id, layer)) {
      if (Result<void> added = shapes.add(*life); !added) return added;
    }
    out += "</g>\n";
  }
  if (open) out += "</g>\n";
  return {};
}

void append_box(std::string& out, const Rect& area) {
  append_attribute(out, "x", area.x0);
  append_attribute(out, "y", area.y0);
  append_attribute(out, "width", area.width());
  append_attribute(out, "height", area.height());
}

}  // namespace

Result<std::string> animated_svg(const TimelapseSource& source, const FilmTiming& timing,
                                 const TimelapseSvgOptions& options) {
  StrokeLives lives;
  EndOfRecording end;
  if (Result<void> done = collect(source, lives, end); !done) return tl::unexpected(done.error());
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"";
  append_attribute(out, "width", options.width_px);
  append_attribute(out, "height", options.height_px);
  out += " viewBox=\"";
  for (const double mm :
       {options.area.x0, options.area.y0, options.area.width(), options.area.height()}) {
    append_number(out, std::round(mm * 1e3) / 1e3);
    out += ' ';
  }
  out.back() = '"';
  out += ">\n";
  if (options.paper.a > 0) {
    out += "<rect";
    append_box(out, options.area);
    append_fill_color(out, options.paper);
    out += "/>\n";
  }
  if (Result<void> done =
          append_layers(out, lives, end.document, timing, StrokeStyles(end.materials));
      !done) {
    return tl::unexpected(done.error());
  }
  return out + "</svg>\n";
}

}  // namespace felt
