#include "felt/render/grain.h"

#include <cmath>
#include <mutex>
#include <string>
#include <vector>

#include "felt/render/dust.h"
#include "felt/render/ink_look.h"
#include "felt/render/relief_texture.h"

namespace felt {
namespace {

/// A surface of this RMS height shows half as much grain as the coarsest.
constexpr double kHalfDepthUm = 12.0;

/// The cache of looks is emptied when it has this many: ten media at six scales.
constexpr std::size_t kMaxLooks = 64;

double crumb_mm_of(const MediumLook& look) noexcept {
  return look.crumb_mm > 1e-3 ? look.crumb_mm : 1e-3;
}

/// Returns true if the medium is solid at any tone and anywhere in the line.
bool is_solid(const MediumLook& look) noexcept {
  return relief_weights(look).all == 0.0 && look.opacity_light == 1.0 &&
         look.opacity_heavy == 1.0 && look.edge == 0.0 && look.rim == 0.0;
}

struct LookOf {
  std::string id;
  MediumLook look;
  double wear = 0.0;

  friend bool operator==(const LookOf&, const LookOf&) = default;
};

}  // namespace

struct Grain::State {
  State(const HeightField* relief, const Materials& materials)
      : field(relief && relief->spec().rms_um > 0.0 ? relief : nullptr), texture(field) {
    for (const Medium& medium : materials.media()) {
      looks.push_back({medium.id, medium.look, medium.wear});
    }
    if (looks.empty()) looks.push_back({"pencil", {}, 0.0});
    for (std::size_t i = 0; i < looks.size(); ++i) {
      if (looks[i].id == "pencil") fallback = i;
    }
    if (field) depth = field->spec().rms_um / (field->spec().rms_um + kHalfDepthUm);
  }
  [[nodiscard]] std::size_t index_of(std::string_view medium) const noexcept {
    for (std::size_t i = 0; i < looks.size(); ++i) {
      if (looks[i].id == medium) return i;
    }
    return fallback;
  }

  const HeightField* field;
  double depth = 0.0;
  std::vector<LookOf> looks;
  std::size_t fallback = 0;
  mutable ReliefTexture texture;

  struct Made {
    std::size_t medium = 0;
    const ReliefLevel* surface = nullptr;
    const ReliefLevel* crumb = nullptr;
    std::shared_ptr<const InkLook> look;
  };
  mutable std::mutex mutex;
  mutable std::vector<Made> made;
};

Grain::Grain(const HeightField* field, const Materials& materials)
    : state_(std::make_shared<const State>(field, materials)), styles_(materials) {}

Grain Grain::solid(const Materials& materials) {
  Grain grain;
  grain.styles_ = StrokeStyles(materials);
  return grain;
}

bool operator==(const Grain& a, const Grain& b) noexcept {
  if (!(a.styles_ == b.styles_)) return false;
  if (a.state_ == b.state_) return true;
  return a.state_ && b.state_ && a.state_->field == b.state_->field &&
         a.state_->looks == b.state_->looks;
}

bool Grain::is_smooth() const noexcept {
  return !state_ || !state_->field;
}

HeightField::Sample Grain::at(Point place) const noexcept {
  return is_smooth() ? HeightField::Sample{} : state_->field->at(place);
}

double Grain::relief(Point place) const noexcept {
  return is_smooth() ? 0.0 : seen_relief(*state_->field, place);
}

double Grain::alpha(Point place, double tone, std::string_view medium) const noexcept {
  if (!state_) return 1.0;
  const LookOf& of = state_->looks[state_->index_of(medium)];
  const ReliefWeights weights = relief_weights(of.look);
  double r = 0.0;
  if (weights.surface > 0.0) r += weights.surface * state_->depth * relief(place);
  if (weights.crumb > 0.0) {
    const double crumb_mm = crumb_mm_of(of.look);
    r += weights.crumb * dust::height({place.x / crumb_mm, place.y / crumb_mm});
  }
  return ink_alpha(of.look, of.wear, tone, r, 0.0);
}

std::shared_ptr<const InkLook> Grain::look(std::string_view medium, double px_per_mm) const {
  if (!state_) return nullptr;
  const std::size_t medium_index = state_->index_of(medium);
  const LookOf& of = state_->looks[medium_index];
  if (is_solid(of.look)) return nullptr;
  const ReliefWeights weights = relief_weights(of.look);
  const double crumb_mm = crumb_mm_of(of.look);
  const auto surface = state_->field && weights.surface > 0.0
                           ? state_->texture.level(px_per_mm * state_->field->spec().wavelength_mm)
                           : nullptr;
  const auto crumb =
      weights.crumb > 0.0 ? dust::level(px_per_mm * dust::kWavesPerTile * crumb_mm) : nullptr;
  const std::lock_guard lock(state_->mutex);
  for (const State::Made& m : state_->made) {
    if (m.medium == medium_index && m.surface == surface.get() && m.crumb == crumb.get())
      return m.look;
  }
  const auto made = std::make_shared<InkLook>(
      of.look, of.wear,
      SeenRelief{state_->depth, surface ? surface->kept : 0.0, crumb ? crumb->kept : 0.0});
  made->surface = surface;
  made->crumb = crumb;
  if (state_->field) made->surface_tile_mm = state_->field->tile_mm();
  made->crumb_tile_mm = dust::kWavesPerTile * crumb_mm;
  if (state_->made.size() >= kMaxLooks) state_->made.clear();
  state_->made.push_back({medium_index, surface.get(), crumb.get(), made});
  return made;
}

}  // namespace felt
