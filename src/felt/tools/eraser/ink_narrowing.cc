#include "felt/tools/eraser/ink_narrowing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/geometry/polyline.h"
#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

// Bounds the memory and the time of a segment. With the finest step, 0.02 mm, samples are farther
// apart than that only in segments longer than 0.4 m.
constexpr int kMaxSteps = 1 << 16;

/// Appends breakpoints that follow the narrowed widths of places[first..last] within kWidthErrorMm
/// and their tones within kToneError. The algorithm is greedy: each breakpoint is as far from its
/// predecessor as these tolerances allow.
template <class Place>
void append_profile(const std::vector<Place>& places, std::size_t first, std::size_t last,
                    const Stroke& stroke, std::vector<WidthKnot>& knots) {
  const double n = stroke.segment_count();
  const auto fits = [&](std::size_t a, std::size_t b) {
    const double span = places[b].u - places[a].u;
    for (std::size_t k = a + 1; k < b; ++k) {
      if (places[k].u == n) return false;  // the seam
      const double share = (places[k].u - places[a].u) / span;
      const double width = 2.0 * std::lerp(places[a].clear_mm, places[b].clear_mm, share);
      if (std::fabs(width - 2.0 * places[k].clear_mm) > InkNarrowing::kWidthErrorMm) return false;
      const double tone = std::lerp(places[a].tone, places[b].tone, share);
      if (std::fabs(tone - places[k].tone) > InkNarrowing::kToneError) return false;
    }
    return true;
  };
  const auto append = [&](std::size_t k) {
    const double u = places[k].u > n ? places[k].u - n : places[k].u;
    knots.push_back({u, std::max(2.0 * places[k].clear_mm, kMinWidthMm), places[k].tone});
    if (u == n && stroke.closed()) knots.push_back({0.0, knots.back().width_mm, stroke.tone(0.0)});
  };
  append(first);
  for (std::size_t a = first; a < last;) {
    std::size_t b = a + 1;
    constexpr std::size_t kLongest = 64;
    while (b < last && b - a < kLongest && fits(a, b + 1)) ++b;
    append(b);
    a = b;
  }
}

/// Returns the profile of a stroke with the breakpoints in `replaced` replaced by `narrowed`.
std::vector<WidthKnot> with_narrowed(const Stroke& stroke, const ParameterSet& replaced,
                                     std::vector<WidthKnot> narrowed) {
  constexpr double kSame = 1e-9;
  for (const WidthKnot& k : stroke.widths()) {
    if (!replaced.contains({k.u, k.u})) narrowed.push_back(k);
  }
  std::sort(narrowed.begin(), narrowed.end(),
            [](const WidthKnot& a, const WidthKnot& b) { return a.u < b.u; });
  const double n = stroke.segment_count();
  std::vector<WidthKnot> knots;
  for (const WidthKnot& k : narrowed) {
    if (knots.empty() || k.u > knots.back().u + kSame) {
      knots.push_back(k);
    } else {
      knots.back().width_mm = std::min(knots.back().width_mm, k.width_mm);
    }
  }
  // If an end of the stroke is erased, the width there does not matter. The first and the last knot
  // are repeated at the ends.
  if (knots.front().u > kSame) knots.insert(knots.begin(), knots.front());
  if (knots.back().u < n - kSame) knots.push_back(knots.back());
  knots.front().u = 0.0;
  knots.back().u = n;
  return knots;
}

}  // namespace

InkNarrowing::InkNarrowing(std::shared_ptr<const Stroke> stroke, double radius_mm)
    : stroke_(std::move(stroke)), step_mm_(std::clamp(0.1 * radius_mm, 0.02, 0.25)) {}

int InkNarrowing::steps_of(int segment) const noexcept {
  const Cubic c = stroke_->segment(segment);
  // |f'(t)| is at most three times the longest leg of the control polygon.
  const double leg =
      std::max({distance(c.p[0], c.p[1]), distance(c.p[1], c.p[2]), distance(c.p[2], c.p[3])});
  const double steps = std::ceil(3.0 * leg / step_mm_);
  return static_cast<int>(std::clamp(steps, 1.0, static_cast<double>(kMaxSteps)));
}

bool InkNarrowing::add(int segment, const ParameterSet& covered, const Capsule& capsule) {
  bool changed = false;
  const Cubic curve = stroke_->segment(segment);
  const int steps = steps_of(segment);
  for (const ParameterSet::Interval& part : covered.intervals()) {
    changed |= touched_.add(part);
    const int first = static_cast<int>(std::ceil((part.from - segment) * steps));
    const int last = static_cast<int>(std::floor((part.to - segment) * steps));
    for (int k = first; k <= last; ++k) {
      changed |= add_sample({segment, static_cast<double>(k) / steps}, curve, capsule);
    }
    // A segment of many metres may be covered between two samples. Elsewhere, such a part is beside
    // the samples of a larger one, and other capsules would not lower a sample of its own.
    if (first > last && steps == kMaxSteps) {
      changed |= add_sample({segment, 0.5 * (part.from + part.to) - segment}, curve, capsule);
    }
  }
  return changed;
}

bool InkNarrowing::add_sample(Sample at, const Cubic& curve, const Capsule& capsule) {
  const Point p = evaluate(curve, at.second);
  const double clear =
      std::sqrt(nearest_on_line(capsule.from, capsule.to, p).distance_squared) - capsule.radius_mm;
  const auto [entry, is_new] = clear_.try_emplace(at, clear);
  if (!is_new && clear >= entry->second) return false;
  entry->second = clear;
  return true;
}

InkNarrowing::Place InkNarrowing::place_at(double u, double clear_mm) const noexcept {
  const double n = stroke_->segment_count();
  const double within = u > n ? u - n : u;
  const WidthKnot ink = knot_at(stroke_->widths(), within);
  const double half = 0.5 * ink.width_mm;
  return {u, stroke_->position(within), half, std::min(half, clear_mm), ink.tone};
}

void InkNarrowing::append_samples(double from, double to, double add_u,
                                  std::vector<Place>& places) const {
  const auto begin = clear_.lower_bound({static_cast<int>(std::floor(from)), 0.0});
  for (auto s = begin; s != clear_.end() && s->first.first <= to; ++s) {
    const double u = s->first.first + s->first.second;
    if (u < from || u > to) continue;
    // A joint is sampled twice, on both of its segments. The samples are merged.
    if (!places.empty() && u + add_u <= places.back().u + 1e-9) {
      places.back().clear_mm = std::min(places.back().clear_mm, s->second);
      continue;
    }
    places.push_back(place_at(u + add_u, s->second));
  }
}

InkNarrowing::Part InkNarrowing::part_between(double from, double to) const {
  const double n = stroke_->segment_count();
  const bool closed = stroke_->closed();
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Part part;
  part.free_start = !closed && from <= 0.0;
  part.free_end = !closed && to >= n;
  const bool everywhere = closed && to - from >= n - ParameterSet::kGap;
  if (!part.free_start && !everywhere) part.places.push_back(place_at(from, kFar));
  append_samples(from, std::min(to, n), 0.0, part.places);
  // `to - n` may be less than `from` by rounding, which would leave out the last sample.
  if (to > n) append_samples(0.0, everywhere ? from : to - n, n, part.places);
  if (!part.free_end && !everywhere) {
    if (part.places.back().u >= to - 1e-9) part.places.pop_back();
    part.places.push_back(place_at(to, kFar));
  }
  return part;
}

std::vector<InkNarrowing::Part> InkNarrowing::parts() const {
  const double n = stroke_->segment_count();
  std::vector<ParameterSet::Interval> spans = touched_.intervals();
  if (stroke_->closed() && !spans.empty() && spans.front().from <= 0.0 && spans.back().to >= n) {
    if (spans.size() > 1) {
      spans.back().to = n + spans.front().to;
      spans.erase(spans.begin());
    } else {
      // The whole closed stroke is touched. The part begins at an erased point, if there is one.
      Part all = part_between(0.0, n);
      const auto gone = std::find_if(all.places.begin(), all.places.end(),
                                     [](const Place& p) { return !stays(p); });
      if (gone == all.places.end()) return {all};
      if (gone->u > 0.0 && gone->u < n) all = part_between(gone->u, n + gone->u);
      all.free_start = all.free_end = true;
      return {all};
    }
  }
  std::vector<Part> result;
  for (const auto& span : spans) {
    Part part = part_between(span.from, span.to);
    if (part.places.size() > 1) result.push_back(std::move(part));
  }
  return result;
}

bool InkNarrowing::stays(const Place& place) noexcept {
  const double smallest = std::clamp(place.half_mm, 0.5 * kMinWidthMm, 0.5 * kThinnestMm);
  return place.clear_mm >= smallest - 1e-12;
}

InkNarrowing::Run InkNarrowing::trimmed(const Part& part, Run run) {
  const auto& places = part.places;
  const auto [first, last] = run;
  const auto covers = [&](std::size_t j, std::size_t k, double slack) {
    return distance(places[j].point, places[k].point) + places[k].clear_mm - places[j].clear_mm <=
           slack;
  };
  // Finds the first sample whose round cap covers all samples after it.
  if (last + 1 < places.size() || part.free_end) {
    const double slack = last + 1 < places.size() ? kLostTipMm : kWidthErrorMm;
    std::size_t j = first, k = first + 1;
    while (k <= last) {
      const bool ok = covers(j, k, slack);
      k = ok ? k + 1 : j + 2;
      if (!ok) ++j;
    }
    run.second = j;
  }
  if (first > 0 || part.free_start) {
    const double slack = first > 0 ? kLostTipMm : kWidthErrorMm;
    std::size_t j = run.second, k = run.second;
    while (k > first) {
      const bool ok = covers(j, k - 1, slack);
      k = ok ? k - 1 : j - 1;
      if (!ok) --j;
    }
    run.first = j;
  }
  const bool is_island =
      (first > 0 || part.free_start) && (last + 1 < places.size() || part.free_end);
  return is_island && run.first == run.second ? Run{first, last} : run;
}

void InkNarrowing::add_hole(double from, double to, ParameterSet& holes) const {
  const double n = stroke_->segment_count();
  if (from >= n) {
    holes.add({from - n, to - n});
  } else {
    holes.add({from, std::min(to, n)});
    if (to > n) holes.add({0.0, to - n});
  }
}

/// Goes through the samples in order. Each run of remaining samples is trimmed at its cut ends and
/// gets a width profile. Everything between the runs becomes a hole.
std::vector<WidthKnot> InkNarrowing::cut(const Part& part, ParameterSet& holes) const {
  const auto& places = part.places;
  const double n = stroke_->segment_count();
  std::vector<WidthKnot> knots;
  double hole = places.front().u;
  for (std::size_t i = 0; i < places.size();) {
    if (!stays(places[i])) {
      ++i;
      continue;
    }
    Run run{i, i};
    while (run.second + 1 < places.size() && stays(places[run.second + 1])) ++run.second;
    i = run.second + 1;
    run = trimmed(part, run);
    const double from = places[run.first].u, to = places[run.second].u;
    if (run.first == run.second && from > places.front().u && to < places.back().u) continue;
    add_hole(hole, from, holes);
    hole = to;
    if (run.first < run.second) append_profile(places, run.first, run.second, *stroke_, knots);
  }
  add_hole(hole, places.back().u, holes);
  if (knots.empty()) return knots;
  for (const double u : {places.front().u, places.back().u}) {
    const WidthKnot edge = knot_at(stroke_->widths(), u > n ? u - n : u);
    const bool known =
        std::any_of(knots.begin(), knots.end(), [&](const WidthKnot& k) { return k.u == edge.u; });
    if (!known) knots.push_back(edge);
  }
  return knots;
}

InkNarrowing::Result InkNarrowing::result() const {
  Result result;
  std::vector<WidthKnot> narrowed;
  ParameterSet replaced;
  for (const Part& part : parts()) {
    const auto knots = cut(part, result.holes);
    add_hole(part.places.front().u, part.places.back().u, result.touched);
    if (knots.empty()) continue;
    add_hole(part.places.front().u, part.places.back().u, replaced);
    narrowed.insert(narrowed.end(), knots.begin(), knots.end());
  }
  if (!narrowed.empty()) result.widths = with_narrowed(*stroke_, replaced, std::move(narrowed));
  return result;
}

}  // namespace felt
