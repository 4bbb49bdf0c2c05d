#pragma once

#include <array>

namespace felt {

/// How far each control point of a segment goes with a pull on its point at t, as parts of the
/// pull: B_i' = B_i + w_i V (paper, eq. 7 and its three cases; specification 5c).
///
/// All but `kPrinted` are  w = (alpha, alpha + c2, beta + c3, beta)  with  sum b_i w_i = 1, so that
/// the curve goes exactly as far as the pen: alpha moves the left joint with its handles on both
/// sides, beta the right one, c2 and c3 the handles inside alone.
struct EditWeights {
  std::array<double, 4> w{};

  /// Part of the pull that the point at t makes: sum b_i w_i.
  [[nodiscard]] double gain(double t) const noexcept;
};

enum class WeightKind {
  /// The least motion of joints and handles that does it: alpha = L (b1 + b2), c2 = L b2, ...
  kSoft,
  /// The paper's three cases, blended within tau = .25 of the joints (errata E4, E5).
  kPaper,
  /// Eq. 7 as it is printed, t V for B4 included (E1): for study, since it does not reach the pen
  /// (E2: 0.34 to 1.00 of the way).
  kPrinted,
};

/// What of a segment may move, 1 freely, 0 not at all.
struct Compliance {
  double left_joint = 1.0;
  double left_handle = 1.0;
  double right_handle = 1.0;
  double right_joint = 1.0;
};

/// `paper` blends within this of the joints; a pinned joint gives way within this of itself.
inline constexpr double kBlendTau = 0.25;

/// The weights of least motion, each counted against its compliance: minimises the sum of
/// squares of alpha, c2, c3, beta over their compliances. With all 1 those of specification 5c,
/// `soft`: at t = 0 the paper's case 1, at t = 1 case 2, at .5 (.64, 1.12, 1.12, .64). All zero
/// where nothing that may move moves the point at t. t in [0, 1].
EditWeights soft_weights(double t, const Compliance& compliance = {}) noexcept;
/// Case 3 on [tau, 1 - tau], case 1 at 0, case 2 at 1, and C1 in between.
EditWeights paper_weights(double t, double tau = kBlendTau) noexcept;
/// (1-t)^3, 3t(1-t)^2, 3t^2(1-t), t.
EditWeights printed_weights(double t) noexcept;

/// How much a pinned joint gives way when the grab is at the parameter distance t from it: all at
/// 0, where it is itself what was taken hold of, nothing from kBlendTau on, and smooth between.
double pinned_compliance(double t) noexcept;

}  // namespace felt
