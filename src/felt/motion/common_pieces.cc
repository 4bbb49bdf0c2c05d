#include "felt/motion/common_pieces.h"

#include <algorithm>
#include <cmath>

#include "felt/motion/line_features.h"

namespace felt {
namespace {

/// Two joints become one cut if they are nearer than this share of the shorter piece beside them.
constexpr double kSnapShare = 0.4;
/// Features whose neighbours would stretch by more than this factor are not aligned.
constexpr double kMaxStretch = 4.0;

/// A place on both strokes, as arc lengths in mm.
struct Anchor {
  double a = 0.0, b = 0.0;
};

bool is_even(const Anchor& from, const Anchor& to, double ratio) noexcept {
  const double stretch = (to.b - from.b) / ((to.a - from.a) * ratio);
  return stretch < kMaxStretch && stretch > 1.0 / kMaxStretch;
}

std::vector<Anchor> anchors_of(const Stroke& a, const Stroke& b, const StepLengths& a_lengths,
                               const StepLengths& b_lengths) {
  const std::vector<LineFeature> a_features = line_features(a, a_lengths),
                                 b_features = line_features(b, b_lengths);
  const Anchor end{a_lengths.length_mm(), b_lengths.length_mm()};
  const double ratio = end.b / end.a;
  std::vector<Anchor> anchors{{0.0, 0.0}};
  for (const auto& [i, k] : align_features(a_features, b_features)) {
    const Anchor next{a_features[i].share * end.a, b_features[k].share * end.b};
    if (is_even(anchors.back(), next, ratio) && is_even(next, end, ratio)) anchors.push_back(next);
  }
  anchors.push_back(end);
  return anchors;
}

/// Returns where an arc length lies between anchors: the number of the interval, and the share in
/// it.
double place_between(const std::vector<Anchor>& anchors, double Anchor::*side, double mm) noexcept {
  std::size_t i = 0;
  while (i + 2 < anchors.size() && mm >= anchors[i + 1].*side) ++i;
  const double from = anchors[i].*side, to = anchors[i + 1].*side;
  return static_cast<double>(i) + std::clamp((mm - from) / (to - from), 0.0, 1.0);
}

double length_between(const std::vector<Anchor>& anchors, double Anchor::*side,
                      double place) noexcept {
  const auto i = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
  const double t = place - static_cast<double>(i);
  return (1.0 - t) * (anchors[i].*side) + t * (anchors[i + 1].*side);
}

/// The joints of both strokes, at their places between anchors.
struct PlacedJoint {
  double place = 0.0;
  int a_joint = 0, b_joint = 0;
};

std::vector<PlacedJoint> joints_of(const Stroke& a, const Stroke& b, const StepLengths& a_lengths,
                                   const StepLengths& b_lengths,
                                   const std::vector<Anchor>& anchors) {
  std::vector<PlacedJoint> joints;
  for (int i = 1; i < a.segment_count(); ++i) {
    joints.push_back({place_between(anchors, &Anchor::a, a_lengths.length_at(i)), i, 0});
  }
  for (int i = 1; i < b.segment_count(); ++i) {
    joints.push_back({place_between(anchors, &Anchor::b, b_lengths.length_at(i)), 0, i});
  }
  std::stable_sort(joints.begin(), joints.end(),
                   [](const PlacedJoint& x, const PlacedJoint& y) { return x.place < y.place; });
  return joints;
}

/// Joins neighbouring joints of different strokes that are close to each other.
std::vector<PlacedJoint> snapped(const std::vector<PlacedJoint>& joints, double end) {
  std::vector<PlacedJoint> result;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (i + 1 == joints.size()) {
      result.push_back(joints[i]);
      break;
    }
    const PlacedJoint &now = joints[i], &next = joints[i + 1];
    const bool differ = (now.a_joint == 0) != (next.a_joint == 0);
    const double before = now.place - (result.empty() ? 0.0 : result.back().place);
    const double after = (i + 2 < joints.size() ? joints[i + 2].place : end) - next.place;
    const double gap = next.place - now.place;
    if (!differ || gap > kSnapShare * std::min(before + gap, after + gap)) {
      result.push_back(now);
      continue;
    }
    result.push_back(
        {0.5 * (now.place + next.place), now.a_joint + next.a_joint, now.b_joint + next.b_joint});
    ++i;
  }
  return result;
}

}  // namespace

CommonPieces common_pieces(const Stroke& a, const Stroke& b) {
  const StepLengths a_lengths(a), b_lengths(b);
  const std::vector<Anchor> anchors = anchors_of(a, b, a_lengths, b_lengths);
  const auto end = static_cast<double>(anchors.size() - 1);
  CommonPieces pieces{{0.0}, {0.0}};
  const auto cut = [&](double a_u, double b_u) {
    pieces.a_u.push_back(std::max(a_u, pieces.a_u.back()));
    pieces.b_u.push_back(std::max(b_u, pieces.b_u.back()));
  };
  for (const PlacedJoint& joint : snapped(joints_of(a, b, a_lengths, b_lengths, anchors), end)) {
    const auto u_on = [&](int own, const StepLengths& lengths, double Anchor::*side) {
      return own > 0 ? own : lengths.u_at(length_between(anchors, side, joint.place));
    };
    cut(u_on(joint.a_joint, a_lengths, &Anchor::a), u_on(joint.b_joint, b_lengths, &Anchor::b));
  }
  cut(a.segment_count(), b.segment_count());
  return pieces;
}

}  // namespace felt
