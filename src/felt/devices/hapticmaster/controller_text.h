#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "felt/geometry/vec3.h"
#include "felt/haptics/force.h"

namespace felt::hapticmaster {

/// The name of the only effect that the driver enables, a bias force: "felt" and letters.
using EffectName = std::array<char, 16>;
/// Returns a name that no other effect has, also not one of another program, of another computer or
/// of an earlier session. So a command of a program that has lost the machine to another one is an
/// error, and cannot change the force of the other. Used on the edit thread.
EffectName new_effect_name();
std::string_view text_of(const EffectName& name) noexcept;

/// What the text of an answer looks like.
enum class AnswerKind : std::uint8_t {
  kVector,    ///< "[0.1,-0.02,0.3]"; the numbers may be invalid (read_vector)
  kWord,      ///< "force", "true": letters only
  kSentence,  ///< "Bias force's force set"
  kError,     ///< contains "--- ERROR:"
  kOther,     ///< anything else, for example an empty text
};
AnswerKind kind_of(std::string_view answer) noexcept;

/// Reads three finite numbers in brackets. Returns nullopt for any other text.
std::optional<Vec3> read_vector(std::string_view answer) noexcept;

/// Room for "set NAME force [x,y,z]".
using ForceText = std::array<char, 96>;
/// Writes the request that sets the bias force of this effect, N, in the machine's axes. Numbers
/// have six decimals, and a vector has no blanks, as in the public clients. Real-time safe.
std::string_view write_force(const EffectName& effect, const Force& force,
                             ForceText& room) noexcept;

/// A sector around the machine's vertical axis, as `get workspace_r|phi|z` report it: low and high
/// stop of the arm and its distance from the axis, m; angle, rad; height, m.
struct Sector {
  Vec3 r_m;           ///< low stop, distance of the axis from the origin, high stop
  Vec3 phi_rad, z_m;  ///< low stop, an unused number, high stop
};
struct Box {
  Vec3 min_mm, max_mm;
};
/// Returns a box in which every point can be reached: from the low to the high stop of the arm, and
/// as wide as the sector is at its narrow end. Returns nullopt if the numbers are implausible
/// (stops in the wrong order, or a size below 20 mm or above 2 m).
std::optional<Box> inner_box(const Sector& sector) noexcept;
/// Returns the smallest box that contains the whole sector. Requires that inner_box() has a value.
Box outer_box(const Sector& sector) noexcept;

}  // namespace felt::hapticmaster
