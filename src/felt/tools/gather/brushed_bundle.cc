#include "felt/tools/gather/brushed_bundle.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/gather/line_groups.h"
#include "felt/geometry/polyline.h"
#include "felt/stroke/edit/join.h"
#include "felt/stroke/edit/split.h"

namespace felt {
namespace {

// line_groups compares gaps with the size of the drawing. Under a brush this is a multiple of its
// radius, which the user sets so that it covers the strip.
constexpr double kScaleRadii = 50.0;
// Brushing along lines is evidence that they belong together.
constexpr double kBrushLeniency = 1.0;
constexpr double kMaxBeside = 0.25;  // share of a line beside the one that it continues
constexpr double kNearJointU = 0.05;

struct BundlePart {
  StrokeId id;
  StrokePart part;
  RoughLine line;
  double along_mm = 0.0;  // length of the brushed points
};

/// The end of a line.
struct LineEnd {
  Point at;
  Vec outwards;
};

LineEnd end_of(const RoughLine& line, bool is_last, double arm_mm) {
  LineEnd end{is_last ? line.back() : line.front(), {}};
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Point p = line[is_last ? line.size() - 1 - i : i];
    end.outwards = normalized(end.at - p);
    if (distance(end.at, p) >= arm_mm) break;
  }
  return end;
}

bool is_end(const RoughLine& line, const PolylineNearest& nearest) {
  return nearest.point == line.front() || nearest.point == line.back();
}

/// Returns true if `next` goes on where `line` ends.
bool continues(const RoughLine& line, const RoughLine& next, double radius_mm) {
  bool meets = false;
  for (int ends = 0; ends < 4 && !meets; ++ends) {
    const LineEnd a = end_of(line, (ends & 1) != 0, radius_mm);
    const LineEnd b = end_of(next, (ends & 2) != 0, radius_mm);
    meets = distance(a.at, b.at) <= 2.0 * radius_mm &&
            dot(a.outwards, b.outwards) <= -BrushPath::kMinCosine &&
            std::fabs(cross(b.at - a.at, a.outwards)) <= 0.5 * radius_mm;
  }
  if (!meets) return false;
  std::size_t beside = 0;
  for (const Point p : next) {
    const PolylineNearest near = nearest_on_polyline(line, p);
    if (!is_end(line, near) && distance(near.point, p) <= 2.0 * radius_mm) ++beside;
  }
  return static_cast<double>(beside) <= kMaxBeside * static_cast<double>(next.size());
}

std::map<LayerId, std::vector<BundlePart>> parts_by_layer(const BrushPath& brush) {
  std::map<LayerId, std::vector<BundlePart>> result;
  for (const auto& [id, brushed] : brush.strokes()) {
    for (StrokePart& part : brushed_parts(brushed, brush.radius_mm())) {
      BundlePart next{id, std::move(part), {}, 0.0};
      next.line = line_of(brushed, next.part);
      for (std::size_t i = 0; i + 1 < next.line.size(); ++i) {
        if (brushed.along_mm[next.part.points[i]] > 0.0) {
          next.along_mm += distance(next.line[i], next.line[i + 1]);
        }
      }
      result[brushed.layer].push_back(std::move(next));
    }
  }
  return result;
}

/// Adds the groups that continue the lines of group `best` to it.
void join_chains(const std::vector<BundlePart>& parts, double radius_mm, std::uint32_t best,
                 std::vector<std::uint32_t>& groups) {
  const auto joins = [&](std::uint32_t group) {
    bool continues_one = false;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (groups[i] != best) continue;
      for (std::size_t k = 0; k < parts.size(); ++k) {
        if (groups[k] != group) continue;
        continues_one = continues_one || continues(parts[i].line, parts[k].line, radius_mm);
      }
    }
    return continues_one;
  };
  for (bool has_joined = true; has_joined;) {
    has_joined = false;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const std::uint32_t group = groups[k];
      if (group == best || !joins(group)) continue;
      std::replace(groups.begin(), groups.end(), group, best);
      has_joined = true;
    }
  }
}

Result<Stroke> cut_out(const Stroke& stroke, const StrokePart& part) {
  if (part.is_whole) return stroke;
  Result<Stroke> cut = sub_stroke(stroke, part.u0, part.u1);
  if (cut) return cut;
  // A cut near a joint would leave a sliver; it moves to the joint.
  const auto at_joint = [](double u) {
    return std::fabs(u - std::round(u)) < kNearJointU ? std::round(u) : u;
  };
  return sub_stroke(stroke, at_joint(part.u0), at_joint(part.u1));
}

/// Moves an end onto the line, if the stroke is long enough for it.
void connect_end(Stroke& stroke, StrokeTip tip, const RoughLine& line) {
  const Point at = stroke.position(tip == StrokeTip::kStart ? 0.0 : stroke.segment_count());
  Result<Stroke> moved = with_tip_at(stroke, tip, nearest_on_polyline(line, at).point);
  if (moved) stroke = *std::move(moved);
}

/// Returns what remains of a stroke, connected with the line.
std::vector<StrokePtr> connected_remainders(const Stroke& stroke,
                                            const std::vector<StrokePart>& parts,
                                            const RoughLine& line) {
  std::vector<StrokePtr> result;
  for (const StrokePart& part : remainders(stroke, parts)) {
    Result<Stroke> rest = cut_out(stroke, part);
    if (!rest) continue;  // too short
    if (stroke.closed() || part.u0 > 0.0) connect_end(*rest, StrokeTip::kStart, line);
    if (stroke.closed() || part.u1 < stroke.segment_count()) {
      connect_end(*rest, StrokeTip::kEnd, line);
    }
    result.push_back(std::make_shared<const Stroke>(*std::move(rest)));
  }
  return result;
}

}  // namespace

BrushedBundle brushed_bundle(const BrushPath& brush) {
  BrushedBundle bundle;
  double farthest_mm = 0.0;
  for (const auto& [layer, parts] : parts_by_layer(brush)) {
    std::vector<RoughLine> lines;
    for (const BundlePart& part : parts) lines.push_back(part.line);
    Result<std::vector<std::uint32_t>> groups =
        line_groups(lines, {.scale_mm = kScaleRadii * brush.radius_mm(),
                            .leniency = kBrushLeniency,
                            .keeps_hatchings = false});
    if (!groups) continue;
    std::map<std::uint32_t, double> along_mm;
    for (std::size_t i = 0; i < parts.size(); ++i) along_mm[(*groups)[i]] += parts[i].along_mm;
    const auto best =
        std::max_element(along_mm.begin(), along_mm.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (best == along_mm.end() || best->second <= farthest_mm) continue;
    farthest_mm = best->second;
    join_chains(parts, brush.radius_mm(), best->first, *groups);
    bundle = {.layer = layer, .parts = {}, .count = 0};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if ((*groups)[i] != best->first) continue;
      bundle.parts[parts[i].id].push_back(parts[i].part);
      ++bundle.count;
    }
  }
  return bundle;
}

double spread_mm(const BrushPath& brush, const BrushedBundle& bundle, Point pen) {
  struct Section {
    double across_mm = 0.0, remaining = 0.0, points = 0.0;
  };
  const Vec across = perp(brush.direction());
  std::vector<Section> sections;
  double middle_mm = 0.0;
  for (const auto& [id, parts] : bundle.parts) {
    const auto at = brush.strokes().find(id);
    if (at == brush.strokes().end()) continue;
    const BrushedStroke& stroke = at->second;
    for (const StrokePart& part : parts) {
      Section section;
      for (const std::size_t i : part.points) {
        if (distance(stroke.points[i], pen) > brush.radius_mm()) continue;
        section.across_mm += dot(stroke.points[i] - pen, across);
        section.remaining += std::max(0.0, 1.0 - stroke.along_mm[i] / brush.radius_mm());
        section.points += 1.0;
      }
      if (section.points == 0.0) continue;
      section.across_mm /= section.points;
      section.remaining /= section.points;
      middle_mm += section.across_mm;
      sections.push_back(section);
    }
  }
  if (sections.size() < 2) return 0.0;
  const auto count = static_cast<double>(sections.size());
  double squares = 0.0;
  for (const Section& section : sections) {
    squares += std::pow(section.remaining * (section.across_mm - middle_mm / count), 2);
  }
  return std::sqrt(squares / count);
}

std::optional<Edit> gather_edit(const Document& document, const BrushedBundle& bundle,
                                const GatherOptions& options) {
  if (bundle.count < 2) return std::nullopt;
  std::vector<StrokePtr> gathered;
  for (const auto& [id, parts] : bundle.parts) {
    for (const StrokePart& part : parts) {
      Result<Stroke> piece = cut_out(*document.find(id), part);
      if (piece) gathered.push_back(std::make_shared<const Stroke>(*std::move(piece)));
    }
  }
  Result<Stroke> made = gathered_stroke(gathered, options);
  if (!made || gathered.size() < 2) return std::nullopt;
  const RoughLine line = rough_line(*made);
  StrokePtr pressed = std::make_shared<const Stroke>(*std::move(made));
  EditBuilder builder(document);
  std::vector<StrokePtr> added;
  for (const auto& [id, parts] : bundle.parts) {
    std::vector<StrokePtr> rest = connected_remainders(*document.find(id), parts, line);
    if (rest.empty()) {
      if (pressed) {
        builder.replace(id, std::exchange(pressed, nullptr));
      } else {
        builder.remove(id);
      }
      continue;
    }
    builder.replace(id, rest.front());
    added.insert(added.end(), rest.begin() + 1, rest.end());
  }
  if (pressed) added.push_back(pressed);
  for (StrokePtr& stroke : added) builder.add(bundle.layer, std::move(stroke));
  return std::move(builder).build("Gather");
}

}  // namespace felt
