#pragma once

#include <cstdint>
#include <string_view>

#include "felt/base/hash.h"
#include "felt/haptics/force_law.h"
#include "felt/material/materials.h"

namespace felt {

/// Computes the fade_id of a force model. When this id changes, the haptic loop cross-fades from
/// the old model to the new one. The id is a hash of the tool's name and of all values added by
/// with(). Different values give different ids (except for a chance of 1 in 2^32), equal values the
/// same id.
///
///   model.set_fade_id(FeelId("pencil").with(material).with(target.stroke.value).value());
class FeelId {
 public:
  explicit FeelId(std::string_view tool) noexcept { add(tool); }

  FeelId& with(std::string_view text) noexcept {
    add(text);
    return *this;
  }
  FeelId& with(std::uint64_t number) noexcept {
    hash_.add_value(number);
    return *this;
  }
  /// Numbers that compare equal (0 and -0) give the same id.
  FeelId& with(double number) noexcept {
    hash_.add_value(number == 0.0 ? 0.0 : number);
    return *this;
  }

  /// Adds all properties of a medium and a surface that affect forces, because materials may change
  /// while they keep their ids.
  FeelId& with_surface(const SurfaceMaterial& surface, const Medium& medium) noexcept {
    with(surface.id).with(surface.stiffness_n_per_m).with(surface.damping_n_s_per_m);
    with(surface.grain_um).with(surface.grain_mm).with(std::uint64_t{surface.grain_seed});
    with(static_cast<std::uint64_t>(surface.grain_character));
    // Two numbers are enough to identify a user-defined relief.
    if (surface.picture) with(surface.picture->max_slope()).with(surface.picture->max_height_mm());
    with(medium.id).with(friction_of(medium, surface)).with(medium.bristle_n_per_m);
    return with(medium.bristle_n_s_per_m).with(medium.grain).with(medium.wear);
  }

  /// Adds the form of the forces, if it is not the usual one.
  FeelId& with_law(LawForm law) noexcept { return law == LawForm::kPaper ? with("paper") : *this; }

  [[nodiscard]] std::uint32_t value() const noexcept {
    return static_cast<std::uint32_t>(hash_.value() ^ (hash_.value() >> 32));
  }

 private:
  void add(std::string_view text) noexcept {
    hash_.add(std::as_bytes(std::span(text.data(), text.size())));
    hash_.add_value(static_cast<std::uint64_t>(text.size()));
  }

  Fnv1a hash_;
};

}  // namespace felt
