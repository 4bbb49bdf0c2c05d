#include "felt/tools/smooth/ironing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "felt/stroke/edit/subdivide.h"
#include "felt/tools/brush_bump.h"
#include "felt/tools/smooth/ironed_stroke.h"

namespace felt {
namespace {

constexpr std::size_t kBlock = IronedBlocks::kPlaces;

}  // namespace

Ironing::Ironing(const Stroke& stroke, const ArcMap& map, const IronOptions& options)
    : stroke_(stroke),
      map_(map),
      options_(options),
      places_(stroke, map, !options.smooth_corners),
      blocks_(places_.count()) {
  const auto size = static_cast<std::size_t>(places_.count()) + 1;
  doses_.assign(size, 0.0);
  longest_.assign(size, std::numeric_limits<double>::quiet_NaN());
  ironed_.resize(size);
  is_new_.assign(size / kBlock + 1, 0);
}

void Ironing::add(double length_mm, double reach_mm, double dose) {
  const int here = places_.nearest(length_mm),
            largest = places_.count() - (places_.closed() ? 1 : 0);
  const auto give = [&](int k) {
    const double way = std::fabs(map_.way(length_mm, places_.length_at(k)));
    if (way >= reach_mm) return false;
    is_new_[index(k) / kBlock] = 1;
    if (!is_dosed(k)) ironed_[index(k)] = places_.point(places_.wrapped(k));
    doses_[index(k)] += dose * places_.inflation(k) * bump(way / reach_mm);
    return true;
  };
  give(places_.wrapped(here));
  int left = largest;
  for (const int side : {1, -1}) {
    for (int i = 1; left > 0; ++i) {
      const int k = here + side * i;
      if (!places_.closed() && (k < 0 || k > places_.count())) break;
      if (!give(places_.wrapped(k))) break;
      --left;
    }
  }
}

/// Returns the filter weight at a place that removes waves of at most `share` times wave_mm,
/// limited by the local bend.
double Ironing::weight_of(int k, double share) {
  double& longest = longest_[index(k)];
  if (std::isnan(longest)) {
    const int at = places_.wrapped(k);
    const double bend = places_.mean_curvature(at, options_.wave_mm);
    const double end = bump(places_.from_fixed_mm(at, options_.wave_mm) / options_.wave_mm);
    const double part = kBendShare + end * (kEndBendShare - kBendShare);
    const double limit = part * 2.0 * std::numbers::pi;
    longest = bend * options_.wave_mm > limit ? limit / bend : options_.wave_mm;
  }
  return jerk_weight(std::min(longest, options_.wave_mm * share), IronPlaces::kSpacingMm);
}

/// Filters the places of `row` and stores the result for those of `kept`.
void Ironing::filter_row(Run row, Run kept) {
  row_.clear();
  for (int k = row.first; k <= row.last; ++k) {
    const int at = places_.wrapped(k);
    const double dose = doses_[index(k)];
    const double weight = dose > 0.0 ? weight_of(k, std::sqrt(-std::expm1(-dose))) : 0.0;
    row_.push_back({places_.point(at), weight, places_.is_fixed(at)});
  }
  out_.resize(row_.size());
  filter_.apply(row_, out_);
  for (int k = kept.first; k <= kept.last; ++k) {
    ironed_[index(k)] = out_[static_cast<std::size_t>(k - row.first)];
  }
  // Directions near the border depend on these points, too.
  for (int k = kept.first - 2; k <= kept.last + 2; ++k) blocks_.forget(places_.wrapped(k));
}

/// Filters the places of `scanned` that got a new dose and the places that these affect, within
/// `row`.
void Ironing::filter_new(Run scanned, Run row) {
  const int margin = static_cast<int>(kMarginWaves * options_.wave_mm / IronPlaces::kSpacingMm);
  for (int k = scanned.first; k <= scanned.last; ++k) {
    if (!is_new(k)) continue;
    int last = k;
    for (int i = k; i <= scanned.last && i <= last + 4 * margin; ++i) last = is_new(i) ? i : last;
    const auto around = [&](int by) {
      return Run{std::max(k - by, row.first), std::min(last + by, row.last)};
    };
    filter_row(around(3 * margin), around(margin));
    k = last;
  }
}

void Ironing::catch_up() {
  const int n = places_.count();
  int start = 0;
  while (places_.closed() && start < n && is_dosed(start)) ++start;
  if (start == n) {
    catch_up_all_around();
  } else {
    catch_up_stretches(start);
  }
  is_new_.assign(is_new_.size(), 0);
  if (places_.closed()) ironed_.back() = ironed_.front();
}

/// Filters a closed stroke that has a dose everywhere. The filtered row continues beyond the place
/// at which the stroke is cut open, on both sides, so that this place has no effect.
void Ironing::catch_up_all_around() {
  const int n = places_.count();
  const int overlap = std::min(n, static_cast<int>(4.0 * options_.wave_mm / 0.25));
  int start = 0;
  while (start < n && is_new(start)) ++start;
  if (start == n) {
    filter_row({-overlap, n - 1 + overlap}, {0, n - 1});
  } else {
    filter_new({start, start + n - 1}, {start - overlap, start + n - 1 + overlap});
  }
}

/// Filters the stretches that have a dose. `start` is a place without a dose, or the start of the
/// stroke.
void Ironing::catch_up_stretches(int start) {
  const int n = places_.count(), end = start + n + (places_.closed() ? 0 : 1);
  for (int k = start; k < end;) {
    if (!is_dosed(k)) {
      ++k;
      continue;
    }
    int last = k;
    while (last < end && is_dosed(last)) ++last;
    // Includes one place without a dose on each side, or the end of the stroke.
    const int from = places_.closed() ? k - 1 : std::max(k - 1, 0);
    const int to = places_.closed() ? last : std::min(last, n);
    filter_new({k, last - 1}, {from, to});
    k = last;
  }
}

/// Returns true if a place has moved by more than kMinMm.
bool Ironing::has_moved() const {
  for (int k = 0; k <= places_.count(); ++k) {
    if (is_dosed(k) && distance(ironed_[index(k)], places_.point(k)) > kMinMm) return true;
  }
  return false;
}

/// Compares the ink around the point, as filtered by its doses so far, with the fully filtered ink.
/// The roughness is computed from the weighted rms distance between the two.
double Ironing::roughness_mm(double length_mm, double reach_mm) {
  const int here = places_.nearest(length_mm);
  const int half = static_cast<int>(reach_mm / IronPlaces::kSpacingMm) + 1;
  const int margin = static_cast<int>(options_.wave_mm / IronPlaces::kSpacingMm) + 1;
  int first = here - half - margin, last = here + half + margin;
  if (places_.closed()) {
    last = std::min(last, first + places_.count() - 1);
  } else {
    first = std::max(first, 0);
    last = std::min(last, places_.count());
  }
  const auto filtered = [&](bool fully) {
    row_.clear();
    for (int k = first; k <= last; ++k) {
      const int at = places_.wrapped(k);
      const double dose = doses_[index(k)];
      const double share = fully ? 1.0 : std::sqrt(-std::expm1(-dose));
      row_.push_back(
          {places_.point(at), share > 0.0 ? weight_of(k, share) : 0.0, places_.is_fixed(at)});
    }
    out_.resize(row_.size());
    filter_.apply(row_, out_);
  };
  filtered(false);
  const std::vector<Point> now = out_;
  filtered(true);
  double sum = 0.0, weights = 0.0;
  for (int k = first; k <= last; ++k) {
    const auto i = static_cast<std::size_t>(k - first);
    const double way = std::fabs(map_.way(length_mm, places_.length_at(places_.wrapped(k))));
    const double weight = bump(way / reach_mm);
    sum += weight * distance_squared(now[i], out_[i]);
    weights += weight;
  }
  const double rms = weights > 0.0 ? std::sqrt(sum / weights) : 0.0;
  return std::max(0.0, rms - kSmoothMm);
}

/// Returns the stretches of places that have a dose, each from the place before it to the place
/// after it.
std::vector<Ironing::Run> Ironing::runs() const {
  std::vector<Run> runs;
  const int n = places_.count();
  for (int k = 0; k <= n;) {
    if (!is_dosed(k)) {
      ++k;
      continue;
    }
    int last = k;
    while (last <= n && is_dosed(last)) ++last;
    const Run run{std::max(k - 1, 0), std::min(last, n)};
    // Between two runs at least one segment of the old stroke must remain.
    if (!runs.empty() && run.first - runs.back().last < 2) {
      runs.back().last = run.last;
    } else if (run.last - run.first >= 4) {
      runs.push_back(run);
    }
    k = last + 1;
  }
  return runs;
}

std::optional<Stroke> Ironing::build(std::vector<Run>& joints, IronedStroke::Detail detail) {
  if (!has_moved()) return std::nullopt;
  IronedStroke result(stroke_, map_, places_, {doses_, ironed_}, blocks_, detail);
  for (const Run& run : runs()) {
    const auto made = result.add(run.first, run.last, is_dosed(0) && places_.closed());
    joints.push_back({made.first, made.last});
  }
  auto stroke = std::move(result).finish();
  // If an invariant is broken, the ink stays as it was.
  if (!stroke) return std::nullopt;
  return *std::move(stroke);
}

std::optional<Stroke> Ironing::shown() {
  std::vector<Run> joints;
  return build(joints, IronedStroke::Detail::kShown);
}

std::optional<Stroke> Ironing::finished() {
  std::vector<Run> joints;
  is_new_.assign(is_new_.size(), 1);
  catch_up();
  std::optional<Stroke> stroke = build(joints, IronedStroke::Detail::kExact);
  if (!stroke) return stroke;
  for (auto run = joints.rbegin(); run != joints.rend(); ++run) {
    const bool whole = stroke->closed() && run->first == 0 && run->last == stroke->segment_count();
    auto fewer =
        with_fewer_segments(*stroke, run->first, whole ? 0 : run->last, options_.tolerance_mm);
    if (fewer) stroke = *std::move(fewer);
  }
  return stroke;
}

}  // namespace felt
