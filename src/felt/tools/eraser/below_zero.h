#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace felt {

/// Parts of [0, 1], ascending and apart.
class UnitParts {
 public:
  /// Seven roots of each of two polynomials of the sixth degree, and some room.
  static constexpr std::size_t kMost = 16;

  struct Part {
    double from = 0.0;
    double to = 0.0;

    friend constexpr bool operator==(Part, Part) noexcept = default;
  };

  /// Appends a part that begins where the last one ends, or after it; then they are one. What does
  /// not fit is added to the last one.
  void append(Part part) noexcept;
  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  [[nodiscard]] const Part* begin() const noexcept { return parts_.data(); }
  [[nodiscard]] const Part* end() const noexcept { return parts_.data() + count_; }

 private:
  std::array<Part, kMost> parts_{};
  std::size_t count_ = 0;
};

/// What lies in both.
UnitParts common(const UnitParts& a, const UnitParts& b) noexcept;

/// The parts of [0, 1] where a polynomial, given by its Bernstein coefficients (degree up to 6), is
/// below zero. Certified: a piece is left alone when all coefficients are at least zero, taken
/// when none is above, and holds exactly one root when they change sign once (Descartes' rule for
/// Bernstein forms); else it is halved. So no dip below zero is missed, however narrow, down to the
/// rounding of the coefficients. Roots to 1e-15. No recursion, bounded work; nothing for
/// coefficients that are not finite.
UnitParts below_zero(std::span<const double> coefficients) noexcept;

}  // namespace felt
