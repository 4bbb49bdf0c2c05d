#include "felt/tools/transform/connected_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "felt/stroke/edit/point_marks.h"
#include "felt/stroke/edit/subdivide.h"
#include "felt/tools/junctions.h"

namespace felt {
namespace {

enum class Motion { kStays, kMapped, kBends };

/// Returns how the point at u of a line with these marks moves.
Motion motion_at(const Selection::Marks& marks, double u) {
  constexpr double kAtJoint = 1e-3;
  const double joint = std::round(u);
  if (std::fabs(u - joint) < kAtJoint) {
    return marks[3 * static_cast<std::size_t>(joint)] ? Motion::kMapped : Motion::kStays;
  }
  const auto first = marks.begin() + 3 * static_cast<std::ptrdiff_t>(u);
  const auto count = std::count(first, first + 4, std::uint8_t{1});
  return count == 4 ? Motion::kMapped : count == 0 ? Motion::kStays : Motion::kBends;
}

/// The changes to one stroke that its connections with moving strokes require.
struct Demand {
  std::vector<double> us;  // parameters of points that are mapped
  std::optional<std::pair<MovedLine::Leader, double>> led;
};

/// Returns the control point index of the end at u of an open stroke, or nullopt if u is not an
/// end.
std::optional<std::size_t> end_at(const Stroke& stroke, double u) {
  if (stroke.closed()) return std::nullopt;
  const int n = stroke.segment_count();
  if (u <= 0.0) return std::size_t{0};
  if (u >= n) return 3 * static_cast<std::size_t>(n);
  return std::nullopt;
}

/// Marks an end and its handle.
void mark_end(Selection::Marks& marks, std::size_t end) {
  marks[end] = 1;
  marks[end == 0 ? 1 : end - 1] = 1;
}

std::optional<MovedLine> line_of(const Document& document, StrokeId id, Demand demand) {
  MovedLine line{id, document.find(id), {}, std::nullopt};
  if (demand.us.empty()) {
    const auto end = end_at(*line.stroke, demand.led->second);
    if (!end) return std::nullopt;
    line.leader = demand.led->first;
    line.marks.resize(line.stroke->data().points.size());
    mark_end(line.marks, *end);
    close_marks(*line.stroke, line.marks);
    return line;
  }
  std::sort(demand.us.begin(), demand.us.end());
  demand.us.erase(std::unique(demand.us.begin(), demand.us.end()), demand.us.end());
  std::vector<int> joints;
  auto cut = subdivided(*line.stroke, demand.us, &joints);
  if (!cut) return std::nullopt;
  if (cut->segment_count() != line.stroke->segment_count()) {
    line.stroke = std::make_shared<const Stroke>(*std::move(cut));
  }
  line.marks.resize(line.stroke->data().points.size());
  for (const int joint : joints) {
    if (const auto end = end_at(*line.stroke, joint)) {
      mark_end(line.marks, *end);
    } else {
      line.marks[3 * static_cast<std::size_t>(joint)] = 1;
    }
  }
  close_marks(*line.stroke, line.marks);
  return line;
}

/// Unmarks an end that lies on a locked stroke, and the handle of this end.
void hold_end(MovedLine& line, double u) {
  const auto end = end_at(*line.stroke, u);
  if (!end) return;
  line.marks[*end] = 0;
  line.marks[*end == 0 ? 1 : *end - 1] = 0;
  close_marks(*line.stroke, line.marks);
}

}  // namespace

std::vector<MovedLine> connected_lines(const Document& document, const StrokeIndex& index,
                                       std::vector<MovedLine> lines) {
  std::set<StrokeId> known;
  for (const MovedLine& line : lines) known.insert(line.id);
  for (std::size_t done = 0; done < lines.size();) {
    std::map<StrokeId, Demand> demands;
    for (; done < lines.size(); ++done) {
      MovedLine& line = lines[done];
      const auto junctions = junctions_of(document, index, line.id, *line.stroke);
      // A line that moves as a whole keeps its shape, even if it separates from a locked line.
      if (!all_marked(line.marks)) {
        for (const Junction& j : junctions) {
          if (!j.editable) hold_end(line, j.u);
        }
      }
      for (const Junction& j : junctions) {
        if (!j.editable || known.contains(j.other)) continue;
        Motion motion = motion_at(line.marks, j.u);
        if (motion == Motion::kMapped && line.leader) motion = Motion::kBends;
        if (motion == Motion::kMapped) demands[j.other].us.push_back(j.other_u);
        if (motion == Motion::kBends) demands[j.other].led = {{done, j.u}, j.other_u};
      }
    }
    for (auto& [id, demand] : demands) {
      known.insert(id);
      if (auto line = line_of(document, id, std::move(demand))) lines.push_back(*std::move(line));
    }
  }
  return lines;
}

}  // namespace felt
