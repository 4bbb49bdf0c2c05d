#include "felt/tactile/swell_paper.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "felt/base/check.h"
#include "felt/document/edit_builder.h"
#include "felt/tactile/area_texture.h"
#include "felt/tactile/inner_circle.h"
#include "felt/tactile/line_widths.h"
#include "felt/tactile/seen_ink.h"
#include "felt/tactile/touch_lines.h"

namespace felt {
namespace {

constexpr Rgba kBlack{0, 0, 0, 255};
/// Its ink is opaque, solid and without grain at every tone.
constexpr const char* kSwellMedium = "ink-pen";
constexpr double kAreaToleranceMm = 0.1;
/// A width that differs by less from that of its style is the same, mm.
constexpr double kSameWidthMm = 0.01;
/// A dot of a texture or of the drawing is a line of this length.
constexpr double kDotLengthMm = 0.06;

/// A visible stroke and its properties as a line.
struct SwellLine {
  StrokeId id;
  StrokePtr stroke;
  double mean_mm = 0.0;
  bool is_dot = false;
};

std::vector<SwellLine> lines_of(const Document& document) {
  std::vector<SwellLine> lines;
  for (const Layer& layer : document.layers()) {
    for (const StrokeId id : layer.strokes) {
      TouchLines one;
      const StrokePtr stroke = document.find(id);
      one.add(id, *stroke);
      const TouchLine& line = one.lines.front();
      lines.push_back({id, stroke, line.mean_width_mm, line.length_mm <= line.mean_width_mm});
    }
  }
  return lines;
}

bool has_even_width(const Stroke& stroke, double width_mm) {
  return std::all_of(stroke.widths().begin(), stroke.widths().end(), [&](const WidthKnot& k) {
    return std::abs(k.width_mm - width_mm) <= kSameWidthMm;
  });
}

StrokePtr black_line(StrokeData data, double width_mm) {
  const auto end = static_cast<double>(data.points.size() / 3);
  data.widths = {{.u = 0.0, .width_mm = width_mm, .tone = 1.0},
                 {.u = end, .width_mm = width_mm, .tone = 1.0}};
  data.color = kBlack;
  data.medium = kSwellMedium;
  Result<Stroke> stroke = Stroke::create(std::move(data));
  return stroke ? std::make_shared<const Stroke>(*std::move(stroke)) : nullptr;
}

/// Returns a black line along points, or null if it would be too short.
StrokePtr black_polyline(const std::vector<Point>& points, double width_mm) {
  StrokeData data;
  for (const Point& p : points) {
    if (data.points.empty()) {
      data.points.push_back(p);
    } else if (distance(data.points.back(), p) >= kMinSegmentMm) {
      const Cubic c = straight(data.points.back(), p);
      data.points.insert(data.points.end(), {c.p[1], c.p[2], p});
    }
  }
  if (data.points.size() < 4) return nullptr;
  data.joints.assign(data.points.size() / 3 - 1, JointKind::kCorner);
  return black_line(std::move(data), width_mm);
}

/// Makes the lines of a document black and gives them their widths.
void change_lines(Document& document, SwellReport& report) {
  const std::vector<SwellLine> lines = lines_of(document);
  std::vector<double> widths;
  for (const SwellLine& line : lines) {
    if (!line.is_dot) widths.push_back(line.mean_mm);
  }
  const std::vector<LineStyle> styles = line_styles_of(widths);
  for (const LineStyle& style : styles) report.widths_mm.push_back(style.width_mm);
  EditBuilder edit(document);
  for (const SwellLine& line : lines) {
    double width_mm = std::max(line.mean_mm, SwellRules::kDotMm);
    for (const LineStyle& style : styles) {
      if (!line.is_dot && line.mean_mm >= style.from_mm) width_mm = style.width_mm;
    }
    const double least_mm = line.is_dot ? SwellRules::kDotMm : SwellRules::kLineMm;
    ++report.lines;
    if (line.mean_mm < least_mm - kSameWidthMm) {
      ++report.widened;
    } else if (!has_even_width(*line.stroke, width_mm)) {
      ++report.made_even;
    }
    if (line.stroke->color() != kBlack) ++report.recolored;
    StrokePtr black = black_line(line.stroke->data(), width_mm);
    if (black) edit.replace(line.id, std::move(black));
  }
  FELT_CHECK(document.apply(std::move(edit).build("Swell paper")).has_value());
}

/// Returns the outlines of all fills, the lowest first, with their layers.
struct SwellArea {
  LayerId layer;
  FillId id;
  FillPtr fill;
  Outline edges;
};

std::vector<SwellArea> areas_of(const Document& document) {
  std::vector<SwellArea> areas;
  for (const Layer& layer : document.layers()) {
    for (const FillId id : layer.fills) {
      areas.push_back({layer.id, id, document.find_fill(id), {}});
      flatten_fill(*areas.back().fill, kAreaToleranceMm, areas.back().edges);
    }
  }
  return areas;
}

void add_texture(EditBuilder& edit, LayerId layer, const std::vector<TextureLine>& lines) {
  for (const TextureLine& line : lines) {
    const bool is_dot = line.from == line.to;
    const Point to = is_dot ? line.to + Vec{kDotLengthMm, 0.0} : line.to;
    const StrokePtr stroke =
        black_polyline({line.from, to}, is_dot ? SwellRules::kDotMm : SwellRules::kLineMm);
    if (stroke) edit.add(layer, stroke);
  }
}

/// Replaces areas by textures and lines along their edges.
Result<void> change_areas(Document& document, const TouchLines& ink,
                          const std::vector<FillId>& unseen, SwellReport& report) {
  const std::vector<SwellArea> areas = areas_of(document);
  double widest_half = 0.0;
  for (const TouchPoint& p : ink.points) widest_half = std::max(widest_half, p.half_mm);
  const TouchGrid near_ink(ink.points, SwellRules::kWhiteMm + SwellRules::kLineMm + widest_half);
  std::size_t tests_left = kMaxTextureTests;
  std::vector<Rgba> colors;
  EditBuilder edit(document);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const SwellArea& area = areas[i];
    if (std::find(unseen.begin(), unseen.end(), area.id) != unseen.end()) {
      edit.remove_fill(area.id);
      continue;
    }
    const auto known = std::find(colors.begin(), colors.end(), area.fill->color);
    const auto kind = static_cast<std::size_t>(known - colors.begin());
    if (known == colors.end()) colors.push_back(area.fill->color);
    std::vector<Outline> above;
    for (std::size_t j = i + 1; j < areas.size(); ++j) above.push_back(areas[j].edges);
    const double inner_mm = largest_inner_circle(area.edges, kAreaToleranceMm).diameter_mm;
    std::vector<TextureLine> lines;
    if (inner_mm >= SwellRules::kTextureMm + 2.0 * SwellRules::kWhiteMm + SwellRules::kLineMm) {
      auto texture = texture_of({area.edges, above, ink, near_ink}, kind, tests_left);
      if (!texture) {
        return fail(ErrorCode::kUnsupported, "the areas are too large or have too many corners");
      }
      lines = *std::move(texture);
    }
    ++(lines.empty() ? report.outlines : report.textures);
    add_texture(edit, area.layer, lines);
    for (const std::vector<Point>& bare : bare_edges(area.edges, ink, near_ink)) {
      const StrokePtr stroke = black_polyline(bare, SwellRules::kLineMm);
      if (stroke) edit.add(area.layer, stroke);
    }
    edit.remove_fill(area.id);
  }
  report.area_colors = colors.size();
  FELT_CHECK(document.apply(std::move(edit).build("Swell paper")).has_value());
  return {};
}

/// Leaves out the strokes that are not seen on the paper, and returns the areas that are not.
std::vector<FillId> remove_unseen(Document& document, Rgba paper, SwellReport& report) {
  UnseenInk unseen = unseen_ink(document, paper);
  report.unseen_lines = unseen.strokes.size();
  report.unseen_areas = unseen.fills.size();
  if (!unseen.strokes.empty()) {
    EditBuilder edit(document);
    for (const StrokeId id : unseen.strokes) edit.remove(id);
    FELT_CHECK(document.apply(std::move(edit).build("Swell paper")).has_value());
  }
  return std::move(unseen.fills);
}

/// Leaves out hidden layers with all that they contain, and pictures.
void keep_visible(Document& document, SwellReport& report) {
  EditBuilder builder(document);
  std::vector<LayerChange> layers;
  for (std::size_t i = 0; i < document.layers().size(); ++i) {
    const Layer& layer = document.layers()[i];
    if (layer.visible) {
      if (layer.picture) ++report.pictures;
    } else {
      for (const StrokeId id : layer.strokes) builder.remove(id);
      for (const FillId id : layer.fills) builder.remove_fill(id);
    }
    LayerState state = layer.state();
    state.picture = nullptr;
    state.opacity = 1.0;
    if (!(state == layer.state())) layers.push_back({layer.id, layer.state(), state, i, i});
  }
  Edit edit = std::move(builder).build("Swell paper");
  edit.layers = std::move(layers);
  if (!edit.empty()) FELT_CHECK(document.apply(edit).has_value());
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

std::vector<std::string> SwellReport::sentences() const {
  std::vector<std::string> all;
  std::string styles;
  for (const double mm : widths_mm) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", mm);
    styles += (styles.empty() ? "" : ", ") + std::string(text);
  }
  if (widened > 0) all.push_back("widened " + counted(widened, "line", "lines"));
  if (made_even > 0)
    all.push_back("changed the width of " + counted(made_even, "other line", "other lines"));
  if (!styles.empty()) all.push_back("lines are " + styles + " mm wide");
  if (recolored > 0) all.push_back("made " + counted(recolored, "line", "lines") + " black");
  if (textures > 0) {
    all.push_back(counted(textures, "area has a texture", "areas have a texture"));
  }
  if (outlines > 0) {
    all.push_back(counted(outlines, "area is an outline, because it is too narrow for a texture",
                          "areas are outlines, because they are too narrow for a texture"));
  }
  if (area_colors > SwellRules::kTextures) {
    all.push_back("areas have " + std::to_string(area_colors) +
                  " colours, and some of them share one of the " +
                  std::to_string(SwellRules::kTextures) + " textures");
  }
  if (unseen_lines > 0) {
    all.push_back("left out " + counted(unseen_lines, "line that is", "lines that are") +
                  " not seen on the paper");
  }
  if (unseen_areas > 0) {
    all.push_back("left out " + counted(unseen_areas, "area that is", "areas that are") +
                  " not seen on the paper");
  }
  if (pictures > 0) all.push_back("left out " + counted(pictures, "picture", "pictures"));
  if (faults > 0) {
    all.push_back(counted(faults, "fault is", "faults are") +
                  " left that a fingertip would notice; feltline check --tactile names faults");
  }
  return all;
}

Result<Drawing> prepare_for_swell_paper(const Drawing& drawing, SwellReport& report) {
  report = {};
  // Refuses drawings that would take too long, before anything is computed.
  const Result<std::vector<TactileFault>> before =
      check_tactile(drawing.document, {.paper = drawing.page.paper});
  if (!before) return tl::unexpected(before.error());
  Drawing swell = drawing;
  swell.page.paper = {255, 255, 255, 0};
  swell.page.surface.clear();
  swell.materials.clear();
  swell.extras = nullptr;
  const std::vector<FillId> unseen = remove_unseen(swell.document, drawing.page.paper, report);
  keep_visible(swell.document, report);
  change_lines(swell.document, report);
  const Result<std::vector<TactileFault>> faults = check_tactile(swell.document);  // on white
  if (!faults) return tl::unexpected(faults.error());
  report.faults = static_cast<std::size_t>(
      std::count_if(faults->begin(), faults->end(), [](const TactileFault& f) {
        return f.rule != TactileRule::kAreaStyles;  // textures differ
      }));
  TouchLines ink;
  for (const SwellLine& line : lines_of(swell.document)) ink.add(line.id, *line.stroke);
  if (Result<void> done = change_areas(swell.document, ink, unseen, report); !done) {
    return tl::unexpected(done.error());
  }
  return swell;
}

}  // namespace felt
