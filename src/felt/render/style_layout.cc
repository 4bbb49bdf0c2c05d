#include "felt/render/style_layout.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

/// Smallest distance of corners that divide a line, as a share of a dash and its gap. From here on,
/// rounding gives a gap between two corners.
constexpr double kMinSection = 0.5;

/// A part of a line between two corners or ends.
struct LineSection {
  StyleSpan span;
  bool begins_at_corner = false, ends_at_corner = false;
};

/// Returns the corners at which the line is divided, ascending. A corner that is too near to the
/// one before has no room for a gap in between: a zigzag would become a solid line.
std::vector<double> dividing_corners(const Spine& spine, StyleSpan range, double min_distance) {
  std::vector<double> corners;
  for (const double at : spine.corners()) {
    if (!spine.closed() && !(at > range.from && at < range.to)) continue;
    if (corners.empty() || at - corners.back() >= min_distance) corners.push_back(at);
  }
  if (spine.closed() && corners.size() > 1 &&
      corners.front() + spine.end() - corners.back() < min_distance) {
    corners.pop_back();
  }
  return corners;
}

/// Returns the parts of the line between its corners. Empty if the line is a ring without corners.
std::vector<LineSection> sections_of(const Spine& spine, StyleSpan range, const StyleRhythm& r) {
  const std::vector<double> corners =
      dividing_corners(spine, range, kMinSection * (r.length + r.gap));
  std::vector<LineSection> sections;
  if (spine.closed()) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const double to = i + 1 < corners.size() ? corners[i + 1] : corners.front() + spine.end();
      sections.push_back({{corners[i], to}, true, true});
    }
    return sections;
  }
  double from = range.from;
  for (const double corner : corners) {
    sections.push_back({{from, corner}, !sections.empty(), true});
    from = corner;
  }
  sections.push_back({{from, range.to}, !sections.empty(), false});
  return sections;
}

/// Returns the rhythm, stretched if it would give more than max_count spans.
StyleRhythm bounded(const Spine& spine, StyleRhythm rhythm) {
  const double count = spine.end() / (rhythm.length + rhythm.gap);
  const double factor = std::max(1.0, count / rhythm.max_count);
  rhythm.length *= factor;
  rhythm.gap *= factor;
  return rhythm;
}

/// Returns the centre line of a dash that fills the visible part `seen` of a line: without its
/// round ends, unless it goes on around a corner there.
StyleSpan without_caps(StyleSpan seen, double half_cap, bool begins_at_corner,
                       bool ends_at_corner) {
  StyleSpan dash = seen;
  if (!begins_at_corner) dash.from += half_cap;
  if (!ends_at_corner) dash.to -= half_cap;
  if (dash.to < dash.from) dash.from = dash.to = 0.5 * (dash.from + dash.to);
  return dash;
}

void add_dashes(const LineSection& section, const StyleRhythm& r, std::vector<StyleSpan>& out) {
  const double half_cap = 0.5 * r.cap;
  const double first = section.begins_at_corner ? 0.5 * r.length : r.length;
  const double last = section.ends_at_corner ? 0.5 * r.length : r.length;
  // The visible part of the line, with the caps at its ends.
  const double begin = section.span.from - (section.begins_at_corner ? 0.0 : half_cap);
  const double end = section.span.to + (section.ends_at_corner ? 0.0 : half_cap);
  const double gaps =
      std::floor((end - begin - first - last + r.length) / (r.length + r.gap) + 0.5);
  if (!(gaps >= 1.0)) return out.push_back(section.span);
  const double scale = (end - begin) / (first + last + gaps * r.gap + (gaps - 1.0) * r.length);
  const int count = static_cast<int>(gaps);
  for (int k = 0; k <= count; ++k) {
    const double from = begin + scale * (first + k * r.gap + (k - 1) * r.length);
    const double to = begin + scale * (first + k * (r.gap + r.length));
    out.push_back(without_caps({k == 0 ? begin : from, k == count ? end : to}, half_cap,
                               k == 0 && section.begins_at_corner,
                               k == count && section.ends_at_corner));
  }
}

}  // namespace

std::vector<StyleSpan> dash_spans(const Spine& spine, StyleSpan range, const StyleRhythm& rhythm) {
  const StyleRhythm r = bounded(spine, rhythm);
  const std::vector<LineSection> sections = sections_of(spine, range, r);
  std::vector<StyleSpan> dashes;
  if (sections.empty()) {
    const double count = std::max(1.0, std::round(spine.end() / (r.length + r.gap)));
    const double scale = spine.end() / (count * (r.length + r.gap));
    const double half = std::max(0.0, 0.5 * (scale * r.length - r.cap));
    for (int k = 1; k <= static_cast<int>(count); ++k) {
      const double middle = spine.end() * k / count;
      dashes.push_back({middle - half, middle + half});
    }
    return dashes;
  }
  std::vector<StyleSpan> part;
  for (const LineSection& section : sections) {
    part.clear();
    add_dashes(section, r, part);
    auto first = part.begin();
    if (section.begins_at_corner && !dashes.empty()) {  // the halves on both sides of a corner
      dashes.back().to = first->to;
      ++first;
    }
    dashes.insert(dashes.end(), first, part.end());
  }
  if (spine.closed() && dashes.size() > 1) {  // both halves at the first corner
    dashes.back().to = dashes.front().to + spine.end();
    dashes.erase(dashes.begin());
  }
  return dashes;
}

std::vector<StyleSpan> repeat_spans(const Spine& spine, StyleSpan range,
                                    const StyleRhythm& rhythm) {
  const StyleRhythm r = bounded(spine, rhythm);
  std::vector<LineSection> sections = sections_of(spine, range, r);
  const bool is_ring = sections.empty();
  if (is_ring) sections.push_back({{0.0, spine.end()}, false, false});
  std::vector<StyleSpan> spans;
  for (const LineSection& section : sections) {
    const double from = section.span.from, size = section.span.to - from;
    const double extra = is_ring ? 0.0 : r.gap;
    const double count = std::max(1.0, std::round((size + extra) / (r.length + r.gap)));
    const double scale = size / (count * (r.length + r.gap) - extra);
    for (int k = 0; k < static_cast<int>(count); ++k) {
      const double at = from + k * scale * (r.length + r.gap);
      const bool is_last =
          !is_ring && k + 1 == static_cast<int>(count);  // ends exactly at the corner or end
      spans.push_back({at, is_last ? section.span.to : at + scale * r.length});
    }
  }
  return spans;
}

}  // namespace felt
