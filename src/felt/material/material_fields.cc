#include "felt/material/material_fields.h"

#include <algorithm>

#include "felt/material/number_text.h"

namespace felt {
namespace {

using Kind = MaterialFieldKind;

template <auto Part, auto... Rest>
constexpr auto& part_of(auto& whole) noexcept {
  if constexpr (sizeof...(Rest) == 0) {
    return whole.*Part;
  } else {
    return part_of<Rest...>(whole.*Part);
  }
}

/// Returns the field for the member that `Path`, a chain of member pointers, leads to.
template <class Material, auto... Path>
constexpr MaterialField<Material> row(std::string_view id, std::string_view label,
                                      std::string_view unit, Kind kind, double min, double max,
                                      std::string_view help,
                                      std::span<const std::string_view> choices = {}) {
  return {
      .id = id,
      .label = label,
      .unit = unit,
      .kind = kind,
      .min = min,
      .max = max,
      .choices = choices,
      .help = help,
      .get = [](const Material& m) noexcept { return static_cast<double>(part_of<Path...>(m)); },
      .set =
          [](Material& m, double value) noexcept {
            auto& part = part_of<Path...>(m);
            part = static_cast<std::remove_reference_t<decltype(part)>>(value);
          }};
}

template <auto... Path>
constexpr SurfaceField surface(std::string_view id, std::string_view label, std::string_view unit,
                               double min, double max, std::string_view help) {
  return row<SurfaceMaterial, Path...>(id, label, unit, Kind::kNumber, min, max, help);
}

template <auto... Path>
constexpr MediumField medium(std::string_view id, std::string_view label, std::string_view unit,
                             double min, double max, std::string_view help) {
  return row<Medium, Path...>(id, label, unit, Kind::kNumber, min, max, help);
}

using Surface = SurfaceMaterial;

constexpr std::array<SurfaceField, 10> kSurfaceFields = {{
    row<Surface, &Surface::color_rgb>(
        "color", "Colour", "", Kind::kColor, 0, 0,
        "Colour of the surface. A page whose colour you changed keeps that colour."),
    surface<&Surface::stiffness_n_per_m>(
        "feel.stiffness_n_per_m", "Hardness", "N/m", 50, 2000,
        "How hard the surface pushes back, if the device allows it."),
    surface<&Surface::damping_n_s_per_m>(
        "feel.damping_n_s_per_m", "Damping", "N s/m", 0, 10,
        "How much of the pen's motion into the surface is damped."),
    surface<&Surface::friction>("feel.friction", "Friction", "", 0, kMaxFriction,
                                "Coefficient of friction of a pencil on this surface."),
    row<Surface, &Surface::grain_character>("grain.character", "Character of the grain", "",
                                            Kind::kChoice, 0, 0, "Shape of the relief.",
                                            kGrainCharacters),
    surface<&Surface::grain_um>("grain.height_um", "Height of the grain", "um", 0, 200,
                                "Root mean square of the heights; 0 is smooth."),
    surface<&Surface::grain_mm>("grain.wavelength_mm", "Width of the grain", "mm", 0.3, 20,
                                "Grain wavelength. A custom relief spans 32 wavelengths."),
    row<Surface, &Surface::grain_seed>(
        "grain.seed", "Seed of the grain", "", Kind::kWhole, 0, 4294967295.0,
        "Another number gives another relief of the same character."),
    surface<&Surface::sound, &SurfaceSound::loudness>(
        "sound.loudness", "Loudness", "", 0, 1, "How loud a pen is on this surface; 0 is silent."),
    surface<&Surface::sound, &SurfaceSound::brightness>(
        "sound.brightness", "Brightness of the sound", "", 0, 1, "From dull to bright."),
}};

constexpr std::array<MediumField, 37> kMediumFields = {{
    row<Medium, &Medium::color_rgb>("color", "Colour", "", Kind::kColor, 0, 0,
                                    "Default colour of this medium."),
    row<Medium, &Medium::draws>("draws", "Draws", "", Kind::kSwitch, 0, 1,
                                "Can be chosen for drawing (off for erasers)."),
    medium<&Medium::friction>("feel.friction", "Friction", "", 0, kMaxFriction,
                              "Coefficient of friction on paper, unless a pair sets another."),
    medium<&Medium::bristle_n_per_m>("feel.bristle_n_per_m", "Hold", "N/m", 50, 2000,
                                     "How stiffly the tip sticks before it slides."),
    medium<&Medium::bristle_n_s_per_m>("feel.bristle_n_s_per_m", "Damping of the hold", "N s/m", 0,
                                       10, "Damping while the tip sticks."),
    medium<&Medium::grain>("feel.grain", "Grain in the hand", "", 0, 2,
                           "How much of the surface's relief the hand feels through it."),
    medium<&Medium::wear>(
        "feel.wear", "Wear of the grain", "", 0, 1,
        "Share of the relief that firm pressure flattens, for the hand and for the eye."),
    medium<&Medium::line, &MediumLine::min_mm>("line.min_mm", "Thinnest line", "mm", 0.05, 20,
                                               "Width of a line without pressure."),
    medium<&Medium::line, &MediumLine::max_mm>("line.max_mm", "Broadest line", "mm", 0.05, 50,
                                               "Width of a line at full pressure."),
    medium<&Medium::line, &MediumLine::gamma>(
        "line.gamma", "Pressure curve of the width", "", 0.2, 5,
        "Above 1, light pressure stays thin for longer; below 1, lines broaden sooner."),
    medium<&Medium::line, &MediumLine::tilt_width>(
        "line.tilt_width", "Width when tilted", "", 1, 20,
        "Width of a line at full tilt, as a multiple of the width with an upright pen."),
    medium<&Medium::line, &MediumLine::tone_light>(
        "line.tone_light", "Tone at light pressure", "", 0, 1,
        "How much of the medium is laid on without pressure."),
    medium<&Medium::line, &MediumLine::tone_heavy>(
        "line.tone_heavy", "Tone at full pressure", "", 0, 1,
        "How much of the medium is laid on at full pressure."),
    medium<&Medium::line, &MediumLine::tone_gamma>(
        "line.tone_gamma", "Pressure curve of the tone", "", 0.2, 5,
        "Above 1, light pressure stays pale for longer; below 1, lines darken sooner."),
    medium<&Medium::line, &MediumLine::tilt_tone>(
        "line.tilt_tone", "Tone when tilted", "", 0, 1,
        "Tone at full tilt, as a share of the tone with an upright pen."),
    medium<&Medium::look, &MediumLook::opacity_light>("look.opacity_light", "Opacity, light", "", 0,
                                                      1, "Opacity of the inked parts at tone 0."),
    medium<&Medium::look, &MediumLook::opacity_heavy>("look.opacity_heavy", "Opacity, heavy", "", 0,
                                                      1, "Opacity of the inked parts at tone 1."),
    medium<&Medium::look, &MediumLook::grain>(
        "look.grain", "Grain in the eye", "",
        0, 1, "How much of the surface's relief shows in the ink; 0 for wet ink."),
    medium<&Medium::look, &MediumLook::cut_light>(
        "look.cut_light", "Depth, light", "RMS", -6, 6,
        "Parts of the relief below this height stay bare at tone 0."),
    medium<&Medium::look, &MediumLook::cut_heavy>(
        "look.cut_heavy", "Depth, heavy", "RMS", -6, 6,
        "Parts of the relief below this height stay bare at tone 1."),
    medium<&Medium::look, &MediumLook::soft>(
        "look.soft", "Softness of the grain", "RMS", 0.05, 6,
        "Ink fades in from this far below the depth to this far above it."),
    medium<&Medium::look, &MediumLook::crumb>(
        "look.crumb", "Crumbs", "", 0, 1,
        "How much grain the medium adds by itself: dust and crumbs."),
    medium<&Medium::look, &MediumLook::crumb_mm>("look.crumb_mm", "Size of the crumbs", "mm", 0.05,
                                                 5, "Wavelength of the crumbs."),
    medium<&Medium::look, &MediumLook::edge>(
        "look.edge", "Soft edge", "", 0, 1,
        "Width of the soft edge of a line, as a share of its radius."),
    medium<&Medium::look, &MediumLook::rim>("look.rim", "Dark rim", "", 0, 1,
                                            "How much darker a wet line dries at its edge."),
    medium<&Medium::look, &MediumLook::streaks>("look.streaks", "Streaks", "", 0, 1,
                                                "Amount of dry-brush streaking."),
    medium<&Medium::sound, &MediumSound::loudness>("sound.loudness", "Loudness", "", 0, 1,
                                                   "How loud the medium rubs; 0 is silent."),
    medium<&Medium::sound, &MediumSound::brightness>("sound.brightness", "Brightness of the sound",
                                                     "", 0, 1, "From dull to bright."),
    medium<&Medium::sound, &MediumSound::squeak>(
        "sound.squeak", "Squeak", "", 0, 1, "How easily the tip squeaks by sticking and slipping."),
    row<Medium, &Medium::style, &MediumStyle::kind>(
        "style.kind", "Style", "", Kind::kChoice, 0, 0,
        "What is drawn in place of a solid line. Repeat and stretch use the shape.", kStyleKinds),
    medium<&Medium::style, &MediumStyle::length>(
        "style.length", "Length of a dash", "widths", 0.2, 50,
        "Length of a dash or of one repeat, in widths of the line; 1 makes dots."),
    medium<&Medium::style, &MediumStyle::gap>(
        "style.gap", "Gap", "widths", 0, 50,
        "Gap between dashes or repeats, in widths of the line."),
    medium<&Medium::style, &MediumStyle::thin>(
        "style.thin", "Thinness", "", 0.05, 1,
        "Width of dashes, rails, shafts and hatching lines, as a share of the width of the line."),
    row<Medium, &Medium::style, &MediumStyle::arrows>(
        "style.arrows", "Arrow heads", "", Kind::kChoice, 0, 0,
        "The ends of an open line that have arrow heads.", kStyleArrows),
    medium<&Medium::style, &MediumStyle::arrow_length>(
        "style.arrow_length", "Length of an arrow head", "widths", 0.5, 10,
        "Length of an arrow head, in widths of the line."),
    medium<&Medium::style, &MediumStyle::angle_deg>(
        "style.angle_deg", "Angle of the hatching",
        "deg", -90, 90, "Direction of the hatching on the page, clockwise from the x axis."),
    medium<&Medium::style, &MediumStyle::spacing_mm>("style.spacing_mm", "Spacing of the hatching",
                                                     "mm", 0.3, 50,
                                                     "Distance between the lines of the hatching."),
}};

template <class Table>
auto find(const Table& table, std::string_view id) noexcept -> decltype(table.data()) {
  const auto at =
      std::find_if(table.begin(), table.end(), [&](const auto& field) { return field.id == id; });
  return at == table.end() ? nullptr : &*at;
}

template <class Field>
std::string allowed_of(const Field& field) {
  const std::string range = number_text(field.min) + " to " + number_text(field.max);
  switch (field.kind) {
    case Kind::kSwitch:
      return "true or false";
    case Kind::kColor:
      return "a colour like \"#1f2933\"";
    case Kind::kWhole:
      return "a whole number from " + range;
    case Kind::kChoice: {
      std::string words = "one of";
      for (const std::string_view choice : field.choices) {
        words += choice == field.choices.front() ? " " : ", ";
        words += choice;
      }
      return words;
    }
    case Kind::kNumber:
      break;
  }
  return range + (field.unit.empty() ? "" : " " + std::string(field.unit));
}

}  // namespace

std::string allowed_text(const SurfaceField& field) {
  return allowed_of(field);
}

std::string allowed_text(const MediumField& field) {
  return allowed_of(field);
}

std::span<const SurfaceField> surface_fields() noexcept {
  return kSurfaceFields;
}

std::span<const MediumField> medium_fields() noexcept {
  return kMediumFields;
}

const SurfaceField* find_surface_field(std::string_view id) noexcept {
  return find(kSurfaceFields, id);
}

const MediumField* find_medium_field(std::string_view id) noexcept {
  return find(kMediumFields, id);
}

}  // namespace felt
