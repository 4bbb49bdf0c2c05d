#include <array>
#include <cmath>

#include "felt/io/ndjson/json_text.h"
#include "felt/session/session_medium.h"
#include "felt/stroke/color_text.h"
#include "felt/tools/overlay_look.h"
#include "web/page/core/texts.h"

namespace felt::page {
namespace {

constexpr std::array kRoles = {"reach",    "snap",   "tether", "guide", "span", "vector",
                               "selected", "handle", "cut",    "rule",  "tick", "axis"};
/// The palette of plot_color(), which people with any kind of colour vision can distinguish.
constexpr std::array kColors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                "#e69f00", "#56b4e9", "#464646"};
constexpr int kBandSteps = 12;
constexpr double kBandPx = 5.0;  // added to the width of the ink

/// Writes marks in CSS pixels.
class Marks {
 public:
  Marks(const View& view, double px) : view_(view), px_(px) {}

  [[nodiscard]] Vec to_css(Point mm) const { return view_.to_px(mm) / px_; }
  [[nodiscard]] double to_css(double mm) const { return mm * view_.px_per_mm / px_; }

  static JsonObject begin(const char* kind, Overlay::Role role) {
    const RoleLook look = look_of(role);
    JsonObject out;
    out.add_text("kind", kind);
    out.add_text("role", kRoles[static_cast<std::size_t>(role)]);
    out.add_number("width", look.width);
    out.add_text("color", kColors[look.color % kColors.size()]);
    out.add_bool("dashed", look.dashed);
    return out;
  }
  void add_points(JsonObject& mark, std::span<const Point> points) const {
    std::string list = "[";
    for (const Point& p : points) {
      const Vec at = to_css(p);
      if (list.size() > 1) list += ',';
      append_rounded(list, at.x);
      list += ',';
      append_rounded(list, at.y);
    }
    mark.add_raw("points", list + "]");
  }
  void end(const JsonObject& mark) { rows_.push_back(mark.text()); }
  [[nodiscard]] std::string text() const { return json_array(rows_); }

 private:
  /// Hundredths of a pixel are enough.
  static void append_rounded(std::string& out, double px) {
    const double at = std::isfinite(px) ? std::fmin(std::fmax(px, -1e6), 1e6) : 0.0;
    long hundredths = std::lround(at * 100.0);
    if (hundredths < 0) out += '-';
    hundredths = std::labs(hundredths);
    out += std::to_string(hundredths / 100);
    const long rest = hundredths % 100;
    if (rest == 0) return;
    out += rest < 10 ? ".0" : ".";
    out += std::to_string(rest);
  }

  View view_;
  double px_;
  std::vector<std::string> rows_;
};

void add_bands(Marks& marks, const Overlay& overlay) {
  for (const Overlay::Span& span : overlay.spans) {
    JsonObject mark = Marks::begin("band", span.role);
    std::vector<Point> points;
    for (int i = 0; i <= kBandSteps; ++i) {
      points.push_back(evaluate(span.curve, static_cast<double>(i) / kBandSteps));
    }
    marks.add_points(mark, points);
    mark.add_number("radius", 0.5 * (marks.to_css(span.width_mm) + kBandPx));
    marks.end(mark);
  }
}

std::string force_text(const Force& force, const View& view) {
  const Vec turned = View{{0, 0}, 1.0, view.turn, view.is_mirrored}.to_px({force.x, force.y});
  JsonObject out;
  out.add_number("x", turned.x);
  out.add_number("y", turned.y);
  out.add_number("z", force.z);
  return out.text();
}

}  // namespace

std::string marks_text(const Overlay& overlay, const View& view, double px) {
  Marks marks(view, px);
  add_bands(marks, overlay);
  for (const Overlay::Outline& outline : overlay.outlines) {
    JsonObject mark = Marks::begin("line", outline.role);
    marks.add_points(mark, outline.points);
    mark.add_bool("closed", outline.closed);
    marks.end(mark);
  }
  for (const Overlay::Ring& ring : overlay.rings) {
    JsonObject mark = Marks::begin("ring", ring.role);
    marks.add_points(mark, std::array{ring.center});
    mark.add_number("radius", marks.to_css(ring.radius_mm));
    marks.end(mark);
  }
  for (const Overlay::Line& line : overlay.lines) {
    JsonObject mark =
        Marks::begin(line.role == Overlay::Role::kVector ? "arrow" : "line", line.role);
    marks.add_points(mark, std::array{line.from, line.to});
    marks.end(mark);
  }
  for (const Overlay::Dot& dot : overlay.dots) {
    JsonObject mark = Marks::begin("dot", dot.role);
    marks.add_points(mark, std::array{dot.at});
    marks.end(mark);
  }
  for (const Overlay::Label& label : overlay.labels) {
    JsonObject mark = Marks::begin("label", Overlay::Role::kGuide);
    marks.add_points(mark, std::array{label.at});
    mark.add_text("text", label.text);
    marks.end(mark);
  }
  return marks.text();
}

std::string pen_text(const Studio& studio, const Picture& picture, double px) {
  const PenState& pen = studio.pen();
  const Marks scale(picture.view(), px);
  const Vec at = scale.to_css(Point{pen.sample.position.x, pen.sample.position.y});
  const Vec hand = scale.to_css(pen.hand);
  const Session& session = studio.session();
  const bool draws = session.tool().info().kind == ToolKind::kDraws && picture.wet().is_empty();
  const std::optional<ToolSize> size = session.tool().size();
  JsonObject out;
  out.add_bool("known", pen.is_known);
  out.add_bool("touching", pen.is_known && in_contact(pen.sample));
  out.add_number("x", at.x);
  out.add_number("y", at.y);
  out.add_number("handX", studio.has_force() ? hand.x : at.x);
  out.add_number("handY", studio.has_force() ? hand.y : at.y);
  out.add_number("radius", draws && size ? scale.to_css(0.5 * size->mm) : 0.0);
  const Force force = !studio.forces() ? Force{} : studio.has_force() ? pen.sent : pen.asked;
  out.add_raw("force", force_text(force, picture.view()));
  out.add_number("pressure", pen.sample.pressure.value_or(in_contact(pen.sample) ? 1.0 : 0.0));
  return out.text();
}

std::string terms_text(const TickReport& tick, const View& view) {
  std::vector<std::string> rows;
  for (const ForceTerms::Term& term : tick.terms) {
    std::string row = force_text(term.force, view);
    row.insert(1, "\"name\":" + json_string(term.name) + ",");
    rows.push_back(row);
  }
  return json_array(rows);
}

std::string devices_text() {
  std::vector<std::string> rows;
  const auto add = [&rows](const std::string& id, std::string_view label, bool has_force) {
    JsonObject row;
    row.add_text("id", id);
    row.add_text("label", label);
    row.add_bool("hasForce", has_force);
    rows.push_back(row.text());
  };
  add("tablet", "Mouse or pen, without forces", false);
  for (const StylusPreset& preset : stylus_presets()) {
    if (!preset.capabilities.has_force() || preset.name == "worst") continue;
    add("simulated:" + std::string(preset.name), preset.label, true);
  }
  return json_array(rows);
}

}  // namespace felt::page
