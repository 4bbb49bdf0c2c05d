#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace felt {

/// Disjoint parts of [0, 1], ascending.
class UnitParts {
 public:
  /// Maximum number of parts: enough for all roots of two polynomials of degree 6.
  static constexpr std::size_t kMax = 16;

  struct Part {
    double from = 0.0;
    double to = 0.0;

    friend constexpr bool operator==(Part, Part) noexcept = default;
  };

  /// Appends a part that begins at or after the end of the last part. If it begins exactly there,
  /// the two are joined. If the list is full, the last part is extended.
  void append(Part part) noexcept;
  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  [[nodiscard]] const Part* begin() const noexcept { return parts_.data(); }
  [[nodiscard]] const Part* end() const noexcept { return parts_.data() + count_; }

 private:
  std::array<Part, kMax> parts_{};
  std::size_t count_ = 0;
};

/// Returns the intersection of the two lists.
UnitParts common(const UnitParts& a, const UnitParts& b) noexcept;

/// Returns the parts of [0, 1] in which a polynomial, given by its Bernstein coefficients (degree
/// up to 6), is below zero. The result is certified. The interval is examined piece by piece: a
/// piece is skipped if all its coefficients are >= 0, and added if all are <= 0. If the
/// coefficients change sign once, the piece has exactly one root (Descartes' rule for Bernstein
/// forms). Otherwise the piece is halved. So no part below zero is missed, however narrow, except
/// for the rounding of the coefficients. Roots are accurate to 1e-15. The work is bounded, without
/// recursion. The result is empty if a coefficient is not finite.
UnitParts below_zero(std::span<const double> coefficients) noexcept;

}  // namespace felt
