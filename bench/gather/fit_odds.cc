#include "fit_odds.h"

#include <fmt/core.h>

#include <cmath>
#include <vector>

#include "felt/gather/line_affinity.h"

namespace felt::bench {
namespace {

constexpr double kPenalty = 3e-3;
constexpr int kNewtonSteps = 12;

struct Example {
  LinePair pair;
  bool together = false;
  double weight = 1.0;
};

using Features = std::array<double, LinePair::kFeatures>;
using Terms = std::array<double, kOddsTerms>;

std::vector<Example> examples_of(std::span<const LabelledDrawing* const> drawings) {
  std::vector<Example> examples;
  for (const LabelledDrawing* drawing : drawings) {
    const std::vector<LinePair> pairs = line_pairs(drawing->lines, drawing->diagonal()).value();
    const double weight = 1.0 / std::sqrt(static_cast<double>(pairs.size()));
    for (const LinePair& pair : pairs) {
      examples.push_back({pair, drawing->labels[pair.a] == drawing->labels[pair.b], weight});
    }
  }
  double sum = 0.0;
  for (const Example& example : examples) sum += example.weight;
  for (Example& example : examples) example.weight /= sum;
  return examples;
}

/// Solves the symmetric positive definite system `matrix` x = `x` in place by Cholesky's method.
void solve(std::vector<Terms>& matrix, Terms& x) {
  const std::size_t n = x.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      double v = matrix[i][k];
      for (std::size_t m = 0; m < k; ++m) v -= matrix[i][m] * matrix[k][m];
      matrix[i][k] = i == k ? std::sqrt(v) : v / matrix[k][k];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) x[i] -= matrix[i][k] * x[k];
    x[i] /= matrix[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) x[i] -= matrix[k][i] * x[k];
    x[i] /= matrix[i][i];
  }
}

Terms newton(const std::vector<Example>& examples, const Features& mean, const Features& spread) {
  Terms weights{};
  for (int step = 0; step < kNewtonSteps; ++step) {
    std::vector<Terms> hessian(kOddsTerms, Terms{});
    Terms gradient{};
    for (const Example& example : examples) {
      const Terms terms = odds_terms(example.pair.features, mean, spread);
      double odds = 0.0;
      for (std::size_t i = 0; i < terms.size(); ++i) odds += weights[i] * terms[i];
      const double p = 1.0 / (1.0 + std::exp(-odds));
      const double error = example.weight * ((example.together ? 1.0 : 0.0) - p);
      const double curvature = example.weight * p * (1.0 - p);
      for (std::size_t i = 0; i < terms.size(); ++i) {
        gradient[i] += error * terms[i];
        for (std::size_t k = 0; k <= i; ++k) hessian[i][k] += curvature * terms[i] * terms[k];
      }
    }
    for (std::size_t i = 0; i < kOddsTerms; ++i) {
      hessian[i][i] += kPenalty;
      gradient[i] -= kPenalty * weights[i];
    }
    solve(hessian, gradient);
    for (std::size_t i = 0; i < kOddsTerms; ++i) weights[i] += gradient[i];
  }
  return weights;
}

template <std::size_t n>
void print_values(const char* name, const std::array<double, n>& values) {
  fmt::print("inline constexpr std::array<double, {}> {}{{", n, name);
  for (std::size_t i = 0; i < n; ++i) fmt::print("{}{:.4g}", i == 0 ? "" : ", ", values[i]);
  fmt::print("}};\n");
}

}  // namespace

void print_fitted_odds(std::span<const LabelledDrawing* const> drawings) {
  const std::vector<Example> examples = examples_of(drawings);
  Features mean{}, spread{};
  for (const Example& e : examples) {
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += e.weight * e.pair.features[i];
  }
  for (const Example& e : examples) {
    for (std::size_t i = 0; i < mean.size(); ++i) {
      spread[i] += e.weight * std::pow(e.pair.features[i] - mean[i], 2);
    }
  }
  for (double& s : spread) s = std::sqrt(s);
  print_values("kOddsMean", mean);
  print_values("kOddsSpread", spread);
  print_values("kOddsWeights", newton(examples, mean, spread));
}

}  // namespace felt::bench
