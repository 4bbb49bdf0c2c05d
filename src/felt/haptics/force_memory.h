#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "felt/geometry/point.h"
#include "felt/haptics/force.h"

namespace felt {

/// Upper bounds of the stiffness (dF/dx, N/m) that a force model shows the hand, by what they are
/// for: the budget of R56 shrinks friction first, then the rest. Slopes along the same axis add.
struct Slopes {
  double normal_n_per_m = 0.0;    ///< out of the sheet: plane
  double friction_n_per_m = 0.0;  ///< in the sheet: bristles
  double lateral_n_per_m = 0.0;   ///< in the sheet: everything else (edit, well, tether, texture)

  friend constexpr Slopes operator+(const Slopes& a, const Slopes& b) noexcept {
    return {a.normal_n_per_m + b.normal_n_per_m, a.friction_n_per_m + b.friction_n_per_m,
            a.lateral_n_per_m + b.lateral_n_per_m};
  }
  friend constexpr bool operator==(const Slopes&, const Slopes&) noexcept = default;
};

/// How much of its stiffness each kind of brick may use, 0..1; the limiter's budget sets it.
struct StiffnessScale {
  double normal = 1.0;
  double friction = 1.0;
  double lateral = 1.0;

  friend constexpr bool operator==(const StiffnessScale&, const StiffnessScale&) noexcept = default;
};

/// The parts of which a force is the sum, by name, for logs and plots. Every brick adds itself on
/// each tick; what does not fit is summed into the last entry, so that the sum stays the force.
class ForceTerms {
 public:
  static constexpr std::size_t kMax = 8;

  struct Term {
    const char* name = "";  ///< a string literal: the name of the brick
    Force force;
  };

  constexpr void clear() noexcept { count_ = 0; }
  constexpr void add(const char* name, const Force& force) noexcept {
    if (count_ < kMax) {
      terms_[count_++] = {name, force};
    } else {
      terms_[kMax - 1].name = "other";
      terms_[kMax - 1].force += force;
    }
  }
  [[nodiscard]] constexpr std::size_t size() const noexcept { return count_; }
  [[nodiscard]] constexpr const Term& operator[](std::size_t i) const noexcept { return terms_[i]; }
  [[nodiscard]] constexpr const Term* begin() const noexcept { return terms_.data(); }
  [[nodiscard]] constexpr const Term* end() const noexcept { return terms_.data() + count_; }

 private:
  std::array<Term, kMax> terms_{};
  std::size_t count_ = 0;
};

/// A point that follows the pen in its own way, remembered by the brick that moves it. `gesture`
/// is the number that the tool gave its gesture: another number starts the follower afresh.
struct Follower {
  Point position{};  ///< mm
  Vec velocity{};    ///< mm/s, of followers that have one
  std::uint32_t gesture = 0;
  bool is_set = false;
};

/// What force bricks remember from tick to tick, and what the loop tells them about this one. One
/// per model in use; when a model takes over from another it starts with a copy of the other's
/// memory, so that a bristle stays where it was. Constant size, trivially copyable.
struct ForceMemory {
  // Set by the loop before each evaluation.
  double dt_s = 0.001;                ///< measured since the last tick, clamped to 0.2..5 ms
  double period_s = 0.001;            ///< nominal
  StiffnessScale scale;               ///< budget of R56
  double material_cap_n_per_m = 0.0;  ///< stiffest plane that the device bears (R55); 0 = no bound
  // Set by bricks, read by later bricks of the same model: the plane before the friction.
  double normal_force_n = 0.0;  ///< total push of the plane, this tick
  double spring_force_n = 0.0;  ///< its spring part alone: what the width is made of (R14)
  // Set by the texture, used up by the friction after it.
  double friction_factor = 1.0;  ///< mu(x) / mu of this tick
  // Belongs to one kind of brick each.
  Point bristle{};                     ///< where the friction's bristle is anchored, mm
  bool bristle_is_set = false;         ///< false while the pen is in the air
  double normal_speed_mm_per_s = 0.0;  ///< low-passed dz/dt of the plane brick
  double last_z_mm = 0.0;
  std::int64_t last_z_time_ns = 0;
  bool has_last_z = false;
  double turn_rad = 0.0;  ///< angle of a rotation about its centre, unwrapped (tether)
  std::uint32_t turn_gesture = 0;
  bool turn_is_set = false;
  Follower nib;  ///< the nib that the pen tows or that has inertia (stabiliser)

  ForceTerms terms;  ///< of this tick

  /// Before each evaluation: this tick's time, no terms, no push of a plane yet.
  constexpr void begin_tick(double measured_dt_s) noexcept {
    dt_s = measured_dt_s;
    normal_force_n = 0.0;
    spring_force_n = 0.0;
    friction_factor = 1.0;
    terms.clear();
  }
};

static_assert(std::is_trivially_copyable_v<ForceMemory>);

}  // namespace felt
