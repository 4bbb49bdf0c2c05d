#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "felt/devices/simulated/scripted_hand.h"
#include "felt/devices/simulated/stylus_presets.h"

namespace felt {

/// A simulated person who draws with a pen: how this person plans a movement, perceives errors, and
/// moves the arm. The defaults are the medians of the population. docs/design/simulation.md#people
/// lists the distributions and their sources. Requires that all numbers are finite and not
/// negative, and arm_kg positive.
struct Person {
  std::uint64_t seed = 0;  ///< of all noise

  // Planning
  double pace = 0.45;        ///< 1: 40 mm/s in a circle with a radius of 1 mm
  double power = 0.15;       ///< speed ~ curvature^-power
  double scatter = 0.65;     ///< standard deviation of ln(speed) around this law
  double rhythm_hz = 5.5;    ///< frequency around which the speed varies
  double steering_s = 0.12;  ///< in a tunnel of width W, the speed is at most W / steering_s
  double preview_s = 0.25;   ///< how far ahead of the pen the person plans
  double wander_mm = 0.12;   ///< RMS of slow deviations of the plan from the path, per axis
  double caution = 0.0;      ///< 1: slower on a plane than in the air, and slower against friction

  // Depth and pressure
  double depth_mm = 0.0;       ///< RMS of slow deviations from the height of the plan in the air
  double press_noise_n = 0.0;  ///< RMS of slow deviations of the press: a constant part ...
  double press_noise = 0.0;    ///< ... plus this share of the force

  // Perception
  double eye_delay_s = 0.135;   ///< from the position of the pen to a corrected plan
  double eye_noise_mm = 0.15;   ///< RMS of the error of the perceived position, per axis
  double eye_gain_per_s = 2.5;  ///< share of the perceived error that is corrected per second
  double arm_delay_s = 0.04;    ///< from a deviation of the arm to a changed muscle command

  // Arm and hand
  double muscle_lag_s = 0.04;    ///< each of two low-pass filters in a row
  double motor_noise = 0.1;      ///< standard deviation of the muscle force divided by that force
  double force_noise_n = 0.0;    ///< standard deviation of the muscle force at rest
  double tremor_mm = 0.03;       ///< RMS of physiological tremor, 8 to 12 Hz, per axis
  double arm_kg = 0.1;           ///< mass that moves with the hand, in addition to that of the grip
  double arm_n_per_m = 250.0;    ///< stiffness between the arm and its planned position
  double arm_n_s_per_m = 6.0;    ///< damping between them
  double reflex_n_per_m = 60.0;  ///< additional stiffness after arm_delay_s
  double load_share = 0.8;  ///< share of a constant load that the person learns to compensate for
  bool knows_friction = false;  ///< compensates for it from the start, and in every direction
  double rest = 1.0;    ///< factor of the stiffness of the arm while the hand rests on a surface
  double grip_n = 2.0;  ///< force of the fingers on the stylus, 1 to 3 N

  /// Returns the fingers as the stylus feels them: stiffness and damping grow with the grip.
  [[nodiscard]] SimulatedHand grip() const noexcept;
};

/// Models of people (docs/design/simulation.md#models). A result about simulated people counts only
/// if it has the same sign in all of them.
enum class PersonModel : std::uint8_t {
  kProportional,  ///< noise in proportion to force; exact depth and pressure; learns loads anew
  kPractised,     ///< small noise with a constant part; noise of depth and pressure; knows friction
  kResting,       ///< the same, and the hand rests on the surface
  kUnsteady,      ///< as kResting, with twice the constant noise and less knowledge of the friction
};
inline constexpr PersonModel kPersonModels[] = {PersonModel::kProportional, PersonModel::kPractised,
                                                PersonModel::kResting, PersonModel::kUnsteady};
/// Returns "proportional", "practised", "resting" or "unsteady".
std::string_view person_model_name(PersonModel model) noexcept;
/// Returns the model with this name.
std::optional<PersonModel> find_person_model(std::string_view name) noexcept;
/// Returns the same person in another model. Requires a person of kProportional.
Person in_model(Person person, PersonModel model) noexcept;
/// Returns the person at the pace at which this person draws in the air, or on a plane against a
/// friction in N. Without `caution`, that is the usual pace.
Person in_the_air(Person person) noexcept;
Person on_a_plane(Person person, double friction_n) noexcept;

/// Returns a person drawn from the distributions of the population. The same seed gives the same
/// person.
Person person_of(std::uint64_t seed);
/// Returns the same person while a guide leads the pen: this person does not compensate for the
/// guide's force as for a load, and gives up a share of the stiffness of arm and reflex. That
/// people can resist, relax or give way, and that this changes how far a force moves them, was
/// measured at a pedal (Abbink and others, IEEE SMC-B 41(5), 2011); the share is an estimate.
Person led_by_a_guide(Person person, double gives_way = 0.5) noexcept;
/// Returns `count` different persons of a model.
std::vector<Person> population(std::size_t count, std::uint64_t seed = 1,
                               PersonModel model = PersonModel::kProportional);

/// Returns the movement that a person plans along a path through `via`: points with times, 1 ms
/// apart. A point given twice in a row is a corner. The person slows down in curves and corners,
/// and for a tunnel of width `tunnel_mm` around the path (0 for none), and varies the speed at
/// random. `trial` selects the random numbers. Points that are not finite are left out; without
/// points, the movement is empty.
RecordedPath plan_movement(const Person& person, std::span<const Point> via,
                           std::uint64_t trial = 0, double tunnel_mm = 0.0);

}  // namespace felt
