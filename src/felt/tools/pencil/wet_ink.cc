#include "felt/tools/pencil/wet_ink.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace felt {

namespace {

/// Returns the number of pieces of a segment over which the width changes linearly.
double pieces_of(const Cubic& segment) {
  return std::clamp(std::ceil(control_length(segment) / WetInk::kPieceMm), 1.0, 64.0);
}

Overlay::InkSegment piece(const Cubic& curve, const InkWidth& from, const InkWidth& to) {
  return {curve, from.width_mm, to.width_mm, from.tone, to.tone};
}

}  // namespace

void WetInk::begin(const WidthMapOptions& widths) {
  static std::atomic<std::uint64_t> strokes{0};
  stroke_ = ++strokes;
  pieces_.clear();
  segments_ = 0;
  places_ = samples_ = 0;
  nodes_.clear();
  first_node_ = taken_ = 0;
  path_mm_ = 0.0;
  stable_widths_ = WidthMap(widths);
  pen_widths_ = WidthMap(widths);
}

void WetInk::update(const InkFitter& fitter, const InkSample& sample) {
  pen_ = pen_widths_.push(sample);
  add_node(sample.position);
  while (segments_ < fitter.segment_count()) add_segment(fitter, segments_++);
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

/// Passes the samples of a segment through the width map again and divides the segment into pieces,
/// each at least 1/pieces of the parameter range long.
void WetInk::add_segment(const InkFitter& fitter, int i) {
  const Cubic segment = fitter.segment(i);
  const double pieces = pieces_of(segment);
  double t0 = 0.0;
  InkWidth from = stable_;
  const auto add_piece = [&](double t1) {
    pieces_.push_back(piece(sub_segment(segment, t0, t1), from, stable_));
    t0 = t1;
    from = stable_;
  };
  const auto& places = fitter.places();
  const auto& samples = fitter.samples();
  for (; places_ < places.size() && places[places_].u <= i + 1; ++places_) {
    for (std::uint32_t k = 0; k < places[places_].count && samples_ < samples.size(); ++k) {
      const bool first = samples_ == 0;
      stable_ = stable_widths_.push(samples[samples_++]);
      if (first) from = stable_;
    }
    const double t = places[places_].u - i;
    if (t < 1.0 && (t - t0) * pieces >= 1.0) add_piece(t);
  }
  add_piece(1.0);
  // Keeps the node before the tail, because the tail's widths begin between this node and the next.
  while (first_node_ + 1 < nodes_.size() && nodes_[first_node_ + 1].sample <= samples_) {
    ++first_node_;
  }
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

/// Adds the stable pieces, then the tail. The tail does not have samples of its own, so a point of
/// the tail gets the width of the point at the same relative length along the pen's path.
void WetInk::draw(InkFitter& fitter, Overlay& overlay) const {
  overlay.add_stable_ink(stroke_, pieces_);
  const auto tail = fitter.live_tail();
  double length = 0.0, along = 0.0;
  for (const Cubic& c : tail) length += control_length(c);
  const double from = nodes_.empty() ? 0.0 : nodes_[first_node_].path_mm;
  InkWidth ink = pieces_.empty() ? open_width(from) : stable_;
  for (const Cubic& c : tail) {
    const double pieces = pieces_of(c);
    for (double k = 0; k < pieces; ++k) {
      along += control_length(c) / pieces;
      const bool last = &c == &tail.back() && k + 1 == pieces;
      const double share = length > 0.0 ? along / length : 1.0;
      const InkWidth next = last ? pen_ : open_width(from + share * (path_mm_ - from));
      overlay.ink.push_back(piece(sub_segment(c, k / pieces, (k + 1) / pieces), ink, next));
      ink = next;
    }
  }
}

}  // namespace felt
