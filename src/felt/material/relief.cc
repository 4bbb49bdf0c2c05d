#include "felt/material/relief.h"

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>

namespace felt {
namespace {

/// The key of a tile: reliefs of the same shape differ only in size.
using Shape = std::tuple<HeightCharacter, std::uint32_t, const HeightField*>;

/// All reliefs requested so far. They are never deleted, because force models point to them.
/// Reliefs of the same shape share a tile, and each then takes only a hundred bytes. A tile is made
/// outside the lock, so that threads that need another relief do not wait for it.
class Reliefs {
 public:
  const HeightField* of(const SurfaceMaterial& surface) {
    const bool is_picture = surface.grain_character == HeightCharacter::kPicture && surface.picture;
    const Shape shape{surface.grain_character, is_picture ? 0u : surface.grain_seed,
                      is_picture ? surface.picture.get() : nullptr};
    const View view{shape, surface.grain_mm, surface.grain_um};
    Tile* tile = nullptr;
    {
      const std::lock_guard lock(mutex_);
      if (const auto known = views_.find(view); known != views_.end()) return known->second.get();
      auto& slot = tiles_[shape];
      if (!slot) slot = std::make_unique<Tile>();
      tile = slot.get();
    }
    std::call_once(tile->once, [&] {
      if (is_picture) tile->picture = surface.picture;
      tile->field.emplace(is_picture ? *surface.picture : HeightField(surface.grain()));
    });
    auto scaled = std::make_unique<const HeightField>(
        tile->field->scaled(surface.grain_mm, surface.grain_um));
    const std::lock_guard lock(mutex_);
    return views_.try_emplace(view, std::move(scaled)).first->second.get();
  }

 private:
  using View = std::tuple<Shape, double, double>;
  struct Tile {
    std::once_flag once;
    std::optional<HeightField> field;
    std::shared_ptr<const HeightField> picture;  // kept, because Shape has its address
  };

  std::mutex mutex_;
  std::map<Shape, std::unique_ptr<Tile>> tiles_;
  std::map<View, std::unique_ptr<const HeightField>> views_;
};

}  // namespace

const HeightField* surface_grain(const SurfaceMaterial& surface) {
  if (!(surface.grain_um > 0.0) || !(surface.grain_mm > 0.0)) return nullptr;
  static Reliefs& reliefs = *new Reliefs;  // never deleted: outlives every thread that uses it
  return reliefs.of(surface);
}

}  // namespace felt
