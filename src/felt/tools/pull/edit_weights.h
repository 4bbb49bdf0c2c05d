#pragma once

#include <array>

namespace felt {

/// How far each control point of a segment moves if the point of the segment at t is pulled by V.
/// The weights w_i are fractions of V: B_i' = B_i + w_i V (paper, eq. 7 and its three cases;
/// docs/design/editing.md#pull-weights).
///
/// All kinds of weights except `kPrinted` have the form w = (alpha, alpha + c2, beta + c3, beta)
/// with sum b_i w_i = 1, so that the point moves exactly as far as the pen. alpha moves the left
/// joint with its handles on both sides, beta the right one; c2 and c3 move only the inner handles.
struct EditWeights {
  std::array<double, 4> w{};

  /// Returns the fraction of the pull by which the point at t moves: sum b_i w_i.
  [[nodiscard]] double gain(double t) const noexcept;
};

enum class WeightKind {
  /// Of all weights with which the curve reaches the pen, those with the smallest sum of the
  /// squares of alpha, c2, c3, beta (soft_weights).
  kSoft,
  /// The paper's three cases, blended within tau = .25 of the joints (docs/design/errata.md#e4,
  /// #e5).
  kPaper,
  /// Eq. 7 as printed, including t V for B4 (docs/design/errata.md#e1). For study only, because the
  /// curve does not reach the pen: it moves by only 0.34 to 1.00 of the displacement
  /// (docs/design/errata.md#e2).
  kPrinted,
};

/// How freely the parts of a segment may move: 1 means freely, 0 not at all.
struct Compliance {
  double left_joint = 1.0;
  double left_handle = 1.0;
  double right_handle = 1.0;
  double right_joint = 1.0;
};

/// Within this parameter distance of a joint, kPaper blends its cases, and a pinned joint may move.
inline constexpr double kBlendTau = 0.25;

/// Returns the weights kSoft: they minimise the sum of the squares of alpha, c2, c3, beta, each
/// divided by its compliance. If all compliances are 1, these are the weights `soft` of
/// docs/design/editing.md#pull-weights: the paper's case 1 at t = 0, case 2 at t = 1, and (.64,
/// 1.12, 1.12, .64) at t = .5. The weights are all zero if no movable part moves the point at t.
/// Requires t in [0, 1].
EditWeights soft_weights(double t, const Compliance& compliance = {}) noexcept;
/// Returns the paper's case 3 on [tau, 1 - tau], case 1 at 0, case 2 at 1, and a C1 blend in
/// between.
EditWeights paper_weights(double t, double tau = kBlendTau) noexcept;
/// Returns (1-t)^3, 3t(1-t)^2, 3t^2(1-t), t.
EditWeights printed_weights(double t) noexcept;
/// Returns the weights of this kind at t. Only kSoft uses the compliance.
EditWeights edit_weights(WeightKind kind, double t, const Compliance& compliance) noexcept;

/// Returns the compliance of a pinned joint at the parameter distance t from the grab: 1 at t = 0
/// (the joint itself is grabbed), 0 if t >= kBlendTau, and a smooth transition in between.
double pinned_compliance(double t) noexcept;

}  // namespace felt
