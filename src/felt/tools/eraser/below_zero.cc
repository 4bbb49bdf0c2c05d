#include "felt/tools/eraser/below_zero.h"

#include <algorithm>
#include <cmath>

#include "felt/base/check.h"

namespace felt {
namespace {

constexpr std::size_t kMaxCoefficients = 7;
constexpr std::size_t kMaxHalvings = 48;

struct Piece {
  std::array<double, kMaxCoefficients> c;
  double from;
  double width;
};

/// Splits a piece in the middle by de Casteljau's algorithm. Sets `left` to the left half and
/// returns the right half.
Piece halve(Piece& left, std::size_t n) noexcept {
  Piece right = left;
  left.width *= 0.5;
  right.width = left.width;
  right.from = left.from + left.width;
  for (std::size_t step = 1; step < n; ++step) {
    // `right` keeps the last value of each step, `left` the first one.
    for (std::size_t k = 0; k + step < n; ++k) right.c[k] = 0.5 * (right.c[k] + right.c[k + 1]);
    left.c[step] = right.c[0];
  }
  return right;
}

double value(const Piece& piece, std::size_t n, double u) noexcept {
  std::array<double, kMaxCoefficients> c = piece.c;
  for (std::size_t step = 1; step < n; ++step) {
    for (std::size_t k = 0; k + step < n; ++k) c[k] = (1.0 - u) * c[k] + u * c[k + 1];
  }
  return c[0];
}

/// Returns true if the polynomial is positive just after the left end. The sign of the first
/// non-zero coefficient decides.
bool starts_above(const Piece& piece, std::size_t n) noexcept {
  for (std::size_t k = 0; k < n; ++k) {
    if (piece.c[k] != 0.0) return piece.c[k] > 0.0;
  }
  return true;
}

/// Returns the only root in a piece, u in [0, 1], by the Illinois method (a secant method that
/// keeps an interval around the root). Every third step is a bisection.
double only_root(const Piece& piece, std::size_t n) noexcept {
  double lo = 0.0, hi = 1.0;
  double at_lo = piece.c[0], at_hi = piece.c[n - 1];
  const bool falls = starts_above(piece, n);
  int side = 0;
  for (int i = 0; i < 120 && hi - lo > 1e-15; ++i) {
    const double secant = lo + (hi - lo) * (at_lo / (at_lo - at_hi));
    const double u = i % 3 != 2 && secant > lo && secant < hi ? secant : 0.5 * (lo + hi);
    const double v = value(piece, n, u);
    if (v == 0.0) return u;
    if ((v > 0.0) == falls) {
      lo = u;
      at_lo = v;
      if (side == 1) at_hi *= 0.5;
      side = 1;
    } else {
      hi = u;
      at_hi = v;
      if (side == -1) at_lo *= 0.5;
      side = -1;
    }
  }
  return 0.5 * (lo + hi);
}

int sign_changes(const Piece& piece, std::size_t n) noexcept {
  int changes = 0;
  double last = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    if (piece.c[k] == 0.0) continue;
    if (last != 0.0 && (piece.c[k] > 0.0) != (last > 0.0)) ++changes;
    last = piece.c[k];
  }
  return changes;
}

/// Adds the part of a piece that is below zero. Returns false if the piece must be halved first.
bool settle(const Piece& piece, std::size_t n, UnitParts& parts) noexcept {
  const auto end = piece.c.begin() + static_cast<std::ptrdiff_t>(n);
  const auto [smallest, largest] = std::minmax_element(piece.c.begin(), end);
  if (*smallest >= 0.0) return true;
  const double to = piece.from + piece.width;
  if (*largest <= 0.0) {
    parts.append({piece.from, to});
    return true;
  }
  if (sign_changes(piece, n) != 1) return false;
  const double root = piece.from + piece.width * only_root(piece, n);
  parts.append(starts_above(piece, n) ? UnitParts::Part{root, to}
                                      : UnitParts::Part{piece.from, root});
  return true;
}

}  // namespace

void UnitParts::append(Part part) noexcept {
  if (!(part.from < part.to)) return;
  if (count_ > 0 && (part.from <= parts_[count_ - 1].to || count_ == kMax)) {
    parts_[count_ - 1].to = std::max(parts_[count_ - 1].to, part.to);
  } else {
    parts_[count_++] = part;
  }
}

UnitParts common(const UnitParts& a, const UnitParts& b) noexcept {
  UnitParts both;
  const auto* i = a.begin();
  const auto* j = b.begin();
  while (i != a.end() && j != b.end()) {
    both.append({std::max(i->from, j->from), std::min(i->to, j->to)});
    (i->to < j->to ? i : j) += 1;
  }
  return both;
}

UnitParts below_zero(std::span<const double> coefficients) noexcept {
  const std::size_t n = coefficients.size();
  FELT_CHECK(n > 0 && n <= kMaxCoefficients);
  UnitParts parts;
  Piece piece{{}, 0.0, 1.0};
  for (std::size_t k = 0; k < n; ++k) {
    if (!std::isfinite(coefficients[k])) return parts;
    piece.c[k] = coefficients[k];
  }
  if (settle(piece, n, parts)) return parts;
  std::array<Piece, kMaxHalvings> waiting{};
  waiting[0] = halve(piece, n);
  std::size_t count = 1;
  while (true) {
    if (!settle(piece, n, parts) && piece.width > 0x1p-47) {
      waiting[count++] = halve(piece, n);
      continue;
    }
    if (count == 0) return parts;
    piece = waiting[--count];
  }
}

}  // namespace felt
