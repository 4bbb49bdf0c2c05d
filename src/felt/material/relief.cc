#include "felt/material/relief.h"

#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>

namespace felt {
namespace {

/// What makes a tile: two reliefs of one shape differ in size alone.
using Shape = std::tuple<HeightCharacter, std::uint32_t, const HeightField*>;

/// All reliefs that were asked for. Nothing is taken away again: force models point at them, and a
/// view of a tile is a hundred bytes.
class Reliefs {
 public:
  const HeightField* of(const SurfaceMaterial& surface) {
    const bool is_picture = surface.grain_character == HeightCharacter::kPicture && surface.picture;
    const Shape shape{surface.grain_character, is_picture ? 0u : surface.grain_seed,
                      is_picture ? surface.picture.get() : nullptr};
    const std::lock_guard lock(mutex_);
    auto& view = views_[{shape, surface.grain_mm, surface.grain_um}];
    if (view) return view.get();
    if (is_picture) pictures_[surface.picture.get()] = surface.picture;
    auto tile = tiles_.find(shape);
    if (tile == tiles_.end()) {
      tile =
          tiles_.emplace(shape, is_picture ? *surface.picture : HeightField(surface.grain())).first;
    }
    view = std::make_unique<const HeightField>(
        tile->second.scaled(surface.grain_mm, surface.grain_um));
    return view.get();
  }

 private:
  std::mutex mutex_;
  std::map<Shape, HeightField> tiles_;
  std::map<std::tuple<Shape, double, double>, std::unique_ptr<const HeightField>> views_;
  std::map<const HeightField*, std::shared_ptr<const HeightField>>
      pictures_;  // their names are kept
};

}  // namespace

const HeightField* surface_grain(const SurfaceMaterial& surface) {
  if (!(surface.grain_um > 0.0) || !(surface.grain_mm > 0.0)) return nullptr;
  static Reliefs& reliefs = *new Reliefs;  // outlives every thread that may still feel one
  return reliefs.of(surface);
}

}  // namespace felt
