#include "felt/stroke/fit/refine.h"

#include <algorithm>
#include <optional>

#include "felt/stroke/fit/corner_detector.h"

namespace felt {
namespace {

constexpr std::size_t kNoNode = static_cast<std::size_t>(-1);

}  // namespace

Refiner::Refiner(const CurveFitOptions& options)
    : kept_(options.effective_tolerance_mm(),
            CurveFitter::spacing_mm(options.effective_tolerance_mm())) {}

void Refiner::begin() {
  kept_.clear();
  guide_.clear();
}

void Refiner::push(Point p) {
  kept_.add(p);
}

void Refiner::follow(const FittedCurve& online) {
  guide_.follow(kept_, online);
}

// Each pass extends all partial curves of the beam by one segment, so the first one that reaches
// the end of the stroke has the fewest segments.
FittedCurve Refiner::end() {
  const std::size_t size = kept_.size();
  if (size < 2 || kept_.path_mm(size - 1) < kMinSegmentMm) return {};
  find_next_corners();
  search_.set_guide(&guide_);
  nodes_.clear();
  places_.clear();
  beam_.assign(1, Partial{kNoNode, {}, 0});
  while (true) {
    cuts_.clear();
    if (runs_.size() < beam_.size()) runs_.resize(beam_.size());
    run_count_ = 0;
    for (const Partial& partial : beam_) {
      Run& run = runs_[run_count_];
      find_run(partial, run);
      if (!search_.is_close_to_guide()) continue;
      ++run_count_;
      if (run.is_last) {
        return assemble(extend({run_count_ - 1, run.t.size() - 1}).node);
      }
      add_cuts(run_count_ - 1);
    }
    if (cuts_.empty()) return {};
    keep_best_cuts();
    beam_.clear();
    for (const Cut& cut : cuts_) beam_.push_back(extend(cut));
  }
}

void Refiner::find_next_corners() {
  CornerDetector detector;
  detector.finish(kept_);
  run_limits_.resize(kept_.size());
  std::size_t limit = kept_.size();
  for (std::size_t i = kept_.size(); i-- > 0;) {
    if (kept_.is_corner(i)) limit = i + 1;
    run_limits_[i] = limit;
  }
}

void Refiner::find_run(const Partial& from, Run& run) {
  search_.begin(kept_, from.start, from.first);
  find_longest(from, run);
  RunPlacer placer;
  while (!place_samples(placer, run) &&
         search_.search_again(kept_, placer.next(), placer.furthest())) {
    find_longest(from, run);
  }
  if (placer.next() == search_.end() || run.t.size() >= SegmentFit::kMaxRun / 2) return;
  search_.begin(kept_, from.start, from.first, LongRun::Detail::kEverySample);
  find_longest(from, run);
  place_samples(placer, run);
}

void Refiner::find_longest(const Partial& from, Run& run) {
  const std::size_t limit = run_limits_[from.first];
  while (search_.step(kept_, limit, true) != RunSearch::Status::kDone) {
  }
  search_.ensure_length();
  run.from = from;
  run.is_last = search_.end() == kept_.size();
  run.ends_at_corner = search_.end() == limit && !run.is_last;
  const bool to_sample = run.is_last || run.ends_at_corner;
  if (from.node == kNoNode || to_sample) search_.pin(from.node == kNoNode, to_sample);
  run.curve = search_.curve();
}

// Assigns each sample of the run its parameter. Returns false if the curve misses a sample; the run
// then ends before the first sample that it misses.
bool Refiner::place_samples(RunPlacer& placer, Run& run) const {
  run.t.clear();
  placer.begin(search_, run.curve, 1.0);
  while (placer.next() < search_.end()) {
    const std::optional<double> t = placer.place(search_, kept_);
    if (!t) {
      run.is_last = run.ends_at_corner = false;
      return false;
    }
    run.t.push_back(*t);
  }
  return true;
}

void Refiner::add_cuts(std::size_t run_index) {
  const Run& run = runs_[run_index];
  if (run.ends_at_corner) {
    cuts_.push_back({run_index, run.t.size() - 1});
    return;
  }
  std::size_t last = run.t.size();
  for (const double reach : kReaches) {
    const std::size_t joint = choose_joint(run.curve, run.t, reach);
    if (joint == last) continue;
    last = joint;
    cuts_.push_back({run_index, joint});
  }
}

std::size_t Refiner::next_first(const Cut& cut) const noexcept {
  return runs_[cut.run].from.first + cut.joint + 1;
}

void Refiner::keep_best_cuts() {
  // A stable insertion sort: there are at most 24 cuts, and std::stable_sort would allocate.
  for (std::size_t i = 1; i < cuts_.size(); ++i) {
    const Cut cut = cuts_[i];
    std::size_t to = i;
    for (; to > 0 && next_first(cuts_[to - 1]) < next_first(cut); --to) cuts_[to] = cuts_[to - 1];
    cuts_[to] = cut;
  }
  std::size_t kept = 0, same = 0, last = 0;
  for (const Cut& cut : cuts_) {
    const std::size_t first = next_first(cut);
    same = first == last ? same + 1 : 1;
    last = first;
    if (same <= kPerJoint) cuts_[kept++] = cut;
    if (kept == kBeam) break;
  }
  cuts_.resize(kept);
}

// Turns a cut into a segment and returns the partial curve that ends with it.
Refiner::Partial Refiner::extend(const Cut& cut) {
  const Run& run = runs_[cut.run];
  const bool is_whole = run.is_last || run.ends_at_corner;
  const double t = is_whole ? 1.0 : run.t[cut.joint];
  Node node;
  node.parent = run.from.node;
  node.segment = is_whole ? run.curve : split(run.curve, t).first;
  node.joint =
      run.from.start.kind == RunStart::Kind::kTangent ? JointKind::kSmooth : JointKind::kCorner;
  node.first = run.from.first;
  node.count = cut.joint + 1;
  node.places = places_.size();
  for (std::size_t i = 0; i < cut.joint; ++i) places_.push_back(std::min(1.0, run.t[i] / t));
  places_.push_back(1.0);
  nodes_.push_back(node);
  RunStart start{RunStart::Kind::kPoint, node.segment.p[3], {}};
  if (!is_whole) {
    start.kind = RunStart::Kind::kTangent;
    start.tangent = tangent(run.curve, t);
  }
  return {nodes_.size() - 1, start, next_first(cut)};
}

FittedCurve Refiner::assemble(std::size_t node) const {
  std::vector<std::size_t> chain;
  for (std::size_t i = node; i != kNoNode; i = nodes_[i].parent) chain.push_back(i);
  std::reverse(chain.begin(), chain.end());
  FittedCurve curve;
  double index = 0.0;
  for (const std::size_t i : chain) {
    const Node& n = nodes_[i];
    if (curve.points.empty()) {
      curve.points.push_back(n.segment.p[0]);
    } else {
      curve.joints.push_back(n.joint);
    }
    curve.points.insert(curve.points.end(), n.segment.p.begin() + 1, n.segment.p.end());
    for (std::size_t k = 0; k < n.count; ++k) {
      const SamplePlace place{index + places_[n.places + k], kept_.sample_count(n.first + k)};
      const double next = k + 1 < n.count ? index + places_[n.places + k + 1] : index + 1.0;
      append_sample_places(place, next, n.segment, kept_.tolerance_mm(), curve.sample_u);
    }
    index += 1.0;
  }
  return curve;
}

}  // namespace felt
