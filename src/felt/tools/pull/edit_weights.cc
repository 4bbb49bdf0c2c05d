#include "felt/tools/pull/edit_weights.h"

#include <algorithm>

namespace felt {
namespace {

/// Bernstein polynomials: b1..b4 of docs/design/errata.md.
struct Basis {
  double b1, b2, b3, b4;
  explicit constexpr Basis(double t) noexcept
      : b1((1.0 - t) * (1.0 - t) * (1.0 - t)),
        b2(3.0 * t * (1.0 - t) * (1.0 - t)),
        b3(3.0 * t * t * (1.0 - t)),
        b4(t * t * t) {}
};

/// Returns S of docs/design/forces.md: 1 at x = 0, 0 for x >= 1, with zero slope at both.
double fade(double x) noexcept {
  return x < 1.0 ? 1.0 - x * x * (3.0 - 2.0 * x) : 0.0;
}

}  // namespace

double EditWeights::gain(double t) const noexcept {
  const Basis b(t);
  return b.b1 * w[0] + b.b2 * w[1] + b.b3 * w[2] + b.b4 * w[3];
}

EditWeights soft_weights(double t, const Compliance& compliance) noexcept {
  const Basis b(t);
  const double left = b.b1 + b.b2, right = b.b3 + b.b4;
  const double sum = compliance.left_joint * left * left + compliance.right_joint * right * right +
                     compliance.left_handle * b.b2 * b.b2 + compliance.right_handle * b.b3 * b.b3;
  // If the sum were smaller, the handles would have to move more than a million times the pull.
  if (!(sum > 1e-12)) return {};
  const double alpha = compliance.left_joint * left / sum;
  const double beta = compliance.right_joint * right / sum;
  return {{alpha, alpha + compliance.left_handle * b.b2 / sum,
           beta + compliance.right_handle * b.b3 / sum, beta}};
}

EditWeights paper_weights(double t, double tau) noexcept {
  const Basis b(t);
  const double alpha = fade(t / tau), beta = fade((1.0 - t) / tau);
  const double rest = 1.0 - alpha * (b.b1 + b.b2) - beta * (b.b3 + b.b4);
  const double middle = b.b2 + b.b3;  // 3 t (1 - t)
  // Near a joint `rest` falls with t^2 and `middle` with t, so the limit of their quotient is 0.
  const double c = middle > 0.0 ? rest / middle : 0.0;
  return {{alpha, alpha + c, beta + c, beta}};
}

EditWeights printed_weights(double t) noexcept {
  const Basis b(t);
  return {{b.b1, b.b2, b.b3, t}};
}

EditWeights edit_weights(WeightKind kind, double t, const Compliance& compliance) noexcept {
  switch (kind) {
    case WeightKind::kPaper:
      return paper_weights(t);
    case WeightKind::kPrinted:
      return printed_weights(t);
    case WeightKind::kSoft:
      break;
  }
  return soft_weights(t, compliance);
}

double pinned_compliance(double t) noexcept {
  return fade(std::max(t, 0.0) / kBlendTau);
}

}  // namespace felt
