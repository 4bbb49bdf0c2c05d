#include "felt/tools/pencil/wet_ink.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace felt {

namespace {

/// A bend of the width on a line of metres has no more pieces than this.
constexpr int kMaxBendPieces = 32;

/// Returns the least number of pieces of a segment.
int pieces_of(const Cubic& segment) {
  const double pieces = std::ceil(control_length(segment) / WetInk::kPieceMm);
  return static_cast<int>(std::clamp(pieces, 1.0, 64.0));
}

/// Returns the width and tone at a share of a line.
InkWidth between(const InkWidth& from, const InkWidth& to, double share) {
  return {from.width_mm + share * (to.width_mm - from.width_mm),
          from.tone + share * (to.tone - from.tone)};
}

/// Appends a line as pieces over which width and tone change linearly.
template <class Line>
void append_pieces(const Line& line, std::vector<Overlay::InkSegment>& out) {
  const ProfileBend &radius = line.profile.piece.radius_mm, &tone = line.profile.piece.tone;
  const int enough =
      tone.steps(WetInk::kBendToneError, radius.steps(0.5 * WetInk::kBendErrorMm, 1));
  const double most = std::max(control_length(line.curve) / WetInk::kMinBendMm, 1.0);
  const int bends = static_cast<int>(std::min({1.0 * enough, most, 1.0 * kMaxBendPieces}));
  const int steps = std::max(bends, line.min_pieces);
  InkWidth from = line.from;
  for (int s = 1; s <= steps; ++s) {
    const double x0 = (s - 1.0) / steps, x1 = static_cast<double>(s) / steps;
    InkWidth to = s == steps ? line.to : between(line.from, line.to, x1);
    if (s < steps) {
      to.width_mm += 2.0 * radius.at(x1);
      to.tone = std::clamp(to.tone + tone.at(x1), 0.0, 1.0);
    }
    const Cubic curve = steps == 1 ? line.curve : sub_segment(line.curve, x0, x1);
    out.push_back({curve, from.width_mm, to.width_mm, from.tone, to.tone});
    from = to;
  }
}

/// Receives lines in order, and appends each one as soon as its end can be drawn smooth.
template <class Line>
void append_smooth(Line line, std::optional<Line>& last, std::vector<Overlay::InkSegment>& out) {
  if (last) {
    smooth_node(last->profile, line.profile);
    append_pieces(*last, out);
  }
  last.emplace(line);
}

}  // namespace

WetInk::Line::Line(const Cubic& c, const InkWidth& start, const InkWidth& end) noexcept
    : curve(c), from(start), to(end) {
  profile.radius_mm = 0.5 * (end.width_mm - start.width_mm);
  profile.tone = end.tone - start.tone;
  profile.speed0_mm = 3.0 * distance(c.p[0], c.p[1]);
  profile.speed1_mm = 3.0 * distance(c.p[2], c.p[3]);
}

void WetInk::begin(const InkFitOptions& options) {
  static std::atomic<std::uint64_t> strokes{0};
  stroke_ = ++strokes;
  pieces_.clear();
  segments_ = 0;
  places_ = samples_ = 0;
  nodes_.clear();
  first_node_ = taken_ = 0;
  path_mm_ = 0.0;
  stable_widths_ = WidthMap(options.width_map);
  pen_widths_ = WidthMap(options.width_map);
  has_tone_ = options.width_map.tone.has_value();
  profile_ = WidthFitter(options.width);
  profile_.begin();
  knots_ = 0;
  open_ = {};
  bent_.reset();
}

void WetInk::update(const InkFitter& fitter, const InkSample& sample) {
  pen_ = pen_widths_.push(sample);
  last_ = sample.position;
  add_node(sample.position);
  if (segments_ == fitter.segment_count()) return;
  while (segments_ < fitter.segment_count()) add_segment(fitter, segments_++);
  add_lines(fitter);
}

void WetInk::add_node(Point pen) {
  if (taken_ == 0) path_end_ = pen;
  const double step = distance(path_end_, pen);
  if (taken_ == 0 || step >= kNodeMm) {
    path_mm_ += step;
    path_end_ = pen;
    nodes_.push_back({taken_, path_mm_, pen_});
  }
  ++taken_;
}

/// Passes the samples of a segment through the width map again, and fits their widths.
void WetInk::add_segment(const InkFitter& fitter, int i) {
  const auto& places = fitter.places();
  const auto& samples = fitter.samples();
  for (; places_ < places.size() && places[places_].u <= i + 1; ++places_) {
    for (std::uint32_t k = 0; k < places[places_].count && samples_ < samples.size(); ++k) {
      stable_ = stable_widths_.push(samples[samples_++]);
      if (has_tone_) {
        profile_.push(places[places_].u, stable_.width_mm, stable_.tone);
      } else {
        profile_.push(places[places_].u, stable_.width_mm);
      }
    }
  }
  // Keeps the node before the tail, because the tail's widths begin between this node and the next.
  while (first_node_ + 1 < nodes_.size() && nodes_[first_node_ + 1].sample <= samples_) {
    ++first_node_;
  }
}

template <class Visit>
void WetInk::for_each_line(const InkFitter& fitter, const WidthKnot& end, Visit visit) const {
  const InkWidth first{open_.width_mm, open_.tone}, last{end.width_mm, end.tone};
  InkWidth from = first;
  for (double u0 = open_.u; u0 < end.u;) {
    const int i = static_cast<int>(u0);
    const double u1 = std::min(i + 1.0, end.u);
    const InkWidth to =
        u1 < end.u ? between(first, last, (u1 - open_.u) / (end.u - open_.u)) : last;
    Line line(sub_segment(fitter.segment(i), u0 - i, u1 - i), from, to);
    line.min_pieces = pieces_of(line.curve);
    visit(line);
    from = to;
    u0 = u1;
  }
}

void WetInk::close_line(const InkFitter& fitter, const WidthKnot& end) {
  for_each_line(fitter, end, [&](const Line& line) { append_smooth(line, bent_, pieces_); });
  open_ = end;
}

/// Makes pieces of the lines that no longer change: those up to the last breakpoint.
void WetInk::add_lines(const InkFitter& fitter) {
  const auto knots = profile_.knots();
  if (knots_ == 0 && !knots.empty()) open_ = knots[knots_++];
  for (; knots_ < knots.size(); ++knots_) {
    if (knots[knots_].u > open_.u) close_line(fitter, knots[knots_]);
  }
  fix_open_line(fitter);
}

/// If the open line is long, ends it at a joint far behind the pen.
void WetInk::fix_open_line(const InkFitter& fitter) {
  int joint = segments_;
  double length = 0.0;
  while (joint > open_.u && length < kOpenMm) length += control_length(fitter.segment(--joint));
  if (joint > open_.u) close_line(fitter, open_end(joint));
}

/// Returns width and tone of the open line at u.
WidthKnot WetInk::open_end(double u) const noexcept {
  InkWidth end = stable_;
  if (!profile_.knots().empty()) {
    const WidthKnot fitted = profile_.open_end();
    // Widths a little behind the last sample are on the same line.
    const double share = (u - open_.u) / (fitted.u - open_.u);
    if (fitted.u > open_.u && share < 2.0) {
      end = between({open_.width_mm, open_.tone}, {fitted.width_mm, fitted.tone}, share);
    }
  }
  return {u, std::max(end.width_mm, kMinWidthMm), std::clamp(end.tone, 0.0, 1.0)};
}

InkWidth WetInk::open_width(double path_mm) const {
  const auto first = nodes_.begin() + static_cast<std::ptrdiff_t>(first_node_);
  const auto after = std::upper_bound(first, nodes_.end(), path_mm,
                                      [](double x, const Node& n) { return x < n.path_mm; });
  if (after == first) return pen_;
  const Node& a = *(after - 1);
  const double end_mm = after == nodes_.end() ? path_mm_ + kNodeMm : after->path_mm;
  const InkWidth end = after == nodes_.end() ? pen_ : after->ink;
  const double share = (path_mm - a.path_mm) / (end_mm - a.path_mm);
  return {a.ink.width_mm + share * (end.width_mm - a.ink.width_mm),
          a.ink.tone + share * (end.tone - a.ink.tone)};
}

/// Adds the stable pieces, then the open line, then the tail. The tail does not have samples of its
/// own, so a point of the tail gets the width of the point at the same relative length along the
/// pen's path.
void WetInk::draw(InkFitter& fitter, Overlay& overlay) const {
  overlay.add_stable_ink(stroke_, pieces_);
  const auto tail = fitter.live_tail();
  double length = 0.0, along = 0.0;
  for (const Cubic& c : tail) length += control_length(c);
  const double from = nodes_.empty() ? 0.0 : nodes_[first_node_].path_mm;
  std::optional<Line> last_line = bent_;
  const auto add = [&](const Line& line) { append_smooth(line, last_line, overlay.ink); };
  InkWidth ink = open_width(from);
  if (segments_ > 0) {
    const WidthKnot end = open_end(segments_);
    for_each_line(fitter, end, add);
    ink = {end.width_mm, end.tone};
  }
  for (const Cubic& c : tail) {
    const int pieces = pieces_of(c);
    for (int k = 0; k < pieces; ++k) {
      along += control_length(c) / pieces;
      const bool last = &c == &tail.back() && k + 1 == pieces;
      const double share = length > 0.0 ? along / length : 1.0;
      const InkWidth next = last ? pen_ : open_width(from + share * (path_mm_ - from));
      add(Line(sub_segment(c, 1.0 * k / pieces, (k + 1.0) / pieces), ink, next));
      ink = next;
    }
  }
  if (last_line) append_pieces(*last_line, overlay.ink);
}

/// Joins the samples by curves whose tangent at a sample is that of its neighbours (Catmull and
/// Rom, "A class of local interpolating splines", 1974), with handles of a third of the distance.
void WetInk::draw_ahead(std::span<const InkSample> ahead, Overlay& overlay) const {
  if (ahead.empty()) return;
  WidthMap widths = pen_widths_;
  const bool is_start = taken_ == 0;
  Point at = is_start ? ahead.front().position : last_;
  InkWidth from = is_start ? widths.push(ahead.front()) : pen_;
  Vec tangent = ahead.front().position - at;
  for (std::size_t i = is_start && ahead.size() > 1 ? 1 : 0; i < ahead.size(); ++i) {
    const Point to = ahead[i].position;
    const Vec next = (i + 1 < ahead.size() ? ahead[i + 1].position : to) - at;
    const double handle = distance(at, to) / 3.0;
    const auto toward = [&](Vec v) { return norm(v) > 0.0 ? (handle / norm(v)) * v : Vec{}; };
    const InkWidth ink = widths.push(ahead[i]);
    overlay.ink.push_back({Cubic{{at, at + toward(tangent), to - toward(next), to}}, from.width_mm,
                           ink.width_mm, from.tone, ink.tone});
    tangent = next;
    at = to;
    from = ink;
  }
}

}  // namespace felt
