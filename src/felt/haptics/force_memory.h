#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "felt/geometry/point.h"
#include "felt/haptics/force.h"
#include "felt/haptics/solid_touch.h"

namespace felt {

/// Upper bounds of the stiffness (dF/dx, N/m) that a force model presents to the hand, by purpose.
/// Slopes along the same axis add. If their sum exceeds the budget of R56, `friction_n_per_m` is
/// reduced first; `lateral_n_per_m` is reduced only if it exceeds the budget without friction.
struct Slopes {
  double normal_n_per_m = 0.0;    ///< across the surface: the plane
  double friction_n_per_m = 0.0;  ///< along the surface: the bristle of friction
  double lateral_n_per_m = 0.0;   ///< along the surface: edit, well, tether, texture

  friend constexpr Slopes operator+(const Slopes& a, const Slopes& b) noexcept {
    return {a.normal_n_per_m + b.normal_n_per_m, a.friction_n_per_m + b.friction_n_per_m,
            a.lateral_n_per_m + b.lateral_n_per_m};
  }
  friend constexpr bool operator==(const Slopes&, const Slopes&) noexcept = default;
};

/// For each kind of brick (see Compose), the share of its stiffness that it may use, 0..1. The
/// safety chain sets these shares from its stiffness budget.
struct StiffnessScale {
  double normal = 1.0;
  double friction = 1.0;
  double lateral = 1.0;

  friend constexpr bool operator==(const StiffnessScale&, const StiffnessScale&) noexcept = default;
};

/// The named parts whose sum is the force, for logs and plots. Every brick adds its own part on
/// each tick. If a model has more than kMax parts, the additional ones are summed into the last
/// entry, so that the parts always add up to the force.
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

/// A point that follows the pen, such as a towed nib; the brick that moves it stores it here.
/// When the pen lands, the follower starts under the pen; `is_set` is false until then. `gesture`
/// is always 0.
struct Follower {
  Point position{};  ///< mm
  Vec velocity{};    ///< mm/s, for followers that have a velocity
  std::uint32_t gesture = 0;
  bool is_set = false;
};

/// How far a point that follows the pen is behind it (yielding_lag()).
struct YieldState {
  Point grab{};  ///< where the gesture began, mm
  Point pen{};   ///< at the last sample, mm
  Vec lag{};     ///< from that point to the pen, mm
  std::int64_t time_ns = 0;
  bool is_set = false;
};

/// The state of a band-pass filter of the pen's velocity, mm/s (BandDamping).
struct ShakeBand {
  Vec band{};
  Vec low{};
};

/// How fast the positions of the pen move along the page, mm/s, low-pass filtered (Friction).
struct PageMotion {
  Point pen{};
  Vec velocity{};
  std::int64_t time_ns = 0;
  bool is_set = false;
};

/// Whether a guide holds the pen (Guide).
struct GuideHold {
  std::uint32_t number = 0;  ///< GuidePiece::hold
  bool is_held = false;
  double share = 0.0;  ///< 0..1, of the force
};

/// What a pen felt last of the thresholds of depth (PushClicks).
struct ClickState {
  std::size_t passed = 0;  ///< number of thresholds that the pen has passed
  double direction = 0.0;  ///< of the last click: 1 into the surface, -1 out of it, 0 none
  double age_s = 1.0;      ///< time since the last click
  double down_s = 0.0;     ///< time since the touch
};

/// The state of force bricks from tick to tick, and the data that the loop gives them for this
/// tick. Each active model has its own ForceMemory. A model that replaces another starts with a
/// copy of the previous model's memory, so that, for example, a bristle stays anchored. The type
/// has constant size and is trivially copyable.
struct ForceMemory {
  // Set by the loop before each evaluation.
  double dt_s = 0.001;                ///< time since the last tick, clamped to 0.2..5 ms
  double period_s = 0.001;            ///< nominal period of the loop
  StiffnessScale scale;               ///< shares from the stiffness budget (R56)
  double material_cap_n_per_m = 0.0;  ///< the device's maximum for a plane (R55); 0 = no bound
  // Set by bricks and read by later bricks of the same model, such as the friction after the plane.
  double normal_force_n = 0.0;  ///< total force of the plane on this tick
  /// The spring part of normal_force_n, which determines the width (R14).
  double spring_force_n = 0.0;
  // Set by the texture; used and reset by the friction, which comes after the texture.
  double friction_factor = 1.0;  ///< mu(x) / mu of this tick
  /// The part of friction_factor that is felt as grain, from the valleys of the relief on; 0..1.8.
  double friction_grain = 0.0;
  // Each of the following belongs to one kind of brick.
  Point bristle{};              ///< anchor of the friction's bristle, mm
  bool bristle_is_set = false;  ///< false while the pen is above the surface
  PageMotion page_motion;
  double normal_speed_mm_per_s = 0.0;  ///< low-pass filtered dz/dt of the plane brick
  double last_z_mm = 0.0;
  std::int64_t last_z_time_ns = 0;
  double z_repeated_s = 0.0;  ///< time for which the device has repeated its sample
  bool has_last_z = false;
  double turn_rad = 0.0;  ///< angle of a rotation about its centre, unwrapped (tether)
  std::uint32_t turn_gesture = 0;
  bool turn_is_set = false;
  YieldState yield;
  Follower nib;  ///< the nib that the pen tows or that has inertia (stabiliser)
  GuideHold guide;
  ClickState click;
  ShakeBand shake_band;
  SolidTouch solid;

  ForceTerms terms;  ///< parts of the force on this tick

  /// Prepares for an evaluation: sets the measured time and clears the terms and the push of the
  /// plane.
  constexpr void begin_tick(double measured_dt_s) noexcept {
    dt_s = measured_dt_s;
    normal_force_n = 0.0;
    spring_force_n = 0.0;
    friction_factor = 1.0;
    friction_grain = 0.0;
    terms.clear();
  }
};

static_assert(std::is_trivially_copyable_v<ForceMemory>);

}  // namespace felt
