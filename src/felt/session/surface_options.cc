#include "felt/session/surface_options.h"

#include <array>
#include <vector>

namespace felt {
namespace {

/// In the order of LawForm.
constexpr std::array<std::string_view, 2> kLaws = {"felt", "paper"};

std::vector<std::string_view> material_ids() {
  std::vector<std::string_view> ids;
  for (const SurfaceMaterial& material : surface_materials()) ids.push_back(material.id);
  return ids;
}

}  // namespace

std::span<const OptionSpec> SurfaceOptions::table() {
  static const std::vector<std::string_view> materials = material_ids();
  static const std::array<OptionSpec, 3> rows = {{
      {
          .id = "material",
          .label = "Surface",
          .unit = "",
          .kind = OptionKind::kChoice,
          .choices = materials,
          .help = "The material of the surface: its hardness and its friction.",
          .open = OpenChoice::kSurfaces,
      },
      {
          .id = "plane_only",
          .label = "Only the plane",
          .unit = "",
          .kind = OptionKind::kSwitch,
          .help = "On the page, the plane of the surface is the only force: no friction, grain, "
                  "attraction or guide. To compare other forces with.",
      },
      {
          .id = "law",
          .label = "Law of the forces",
          .unit = "",
          .kind = OptionKind::kChoice,
          .choices = kLaws,
          .help = "How pull, transform and the attraction of ends resist: without jumps (felt), or "
                  "by equations 8 to 11 of the paper as printed, which vibrate. For study.",
      },
  }};
  return rows;
}

Result<void> SurfaceOptions::set(std::string_view id, const OptionValue& value,
                                 const Materials& known) {
  if (id == "material") {
    if (Result<void> is_known = check_choice(table()[0], value, known); !is_known) return is_known;
  }
  Result<void> set = values_.set(id, value);
  if (set) follow(known);
  return set;
}

Result<OptionValue> SurfaceOptions::get(std::string_view id) const {
  return values_.get(id);
}

void SurfaceOptions::follow(const Materials& known) {
  if (const SurfaceMaterial* surface = known.find_surface(values_.open_choice(0)))
    material_ = *surface;
}

}  // namespace felt
