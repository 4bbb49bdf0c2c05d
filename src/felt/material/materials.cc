#include "felt/material/materials.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace felt {
namespace {

template <class Table>
auto find(Table& table, std::string_view id) noexcept -> decltype(table.data()) {
  const auto at =
      std::find_if(table.begin(), table.end(), [&](const auto& m) { return m.id == id; });
  return at == table.end() ? nullptr : &*at;
}

template <class Item>
void put_into(std::vector<Item>& table, Item item) {
  if (Item* known = find(table, item.id)) {
    *known = std::move(item);
  } else {
    table.push_back(std::move(item));
  }
}

}  // namespace

const SurfaceMaterial* Materials::find_surface(std::string_view id) const noexcept {
  return find(surfaces_, id);
}

const Medium* Materials::find_medium(std::string_view id) const noexcept {
  return find(media_, id);
}

void Materials::put(SurfaceMaterial surface) {
  put_into(surfaces_, std::move(surface));
}

void Materials::put(Medium medium) {
  put_into(media_, std::move(medium));
}

std::span<const SurfaceMaterial> surface_materials() noexcept {
  return Materials::built_in().surfaces();
}

std::span<const Medium> media() noexcept {
  const std::span<const Medium> all = Materials::built_in().media();
  const auto is_plain = [](const Medium& medium) { return medium.style == MediumStyle{}; };
  const auto plain = std::find_if_not(all.begin(), all.end(), is_plain) - all.begin();
  return all.first(static_cast<std::size_t>(plain));
}

const SurfaceMaterial* find_surface(std::string_view id) noexcept {
  return Materials::built_in().find_surface(id);
}

const Medium* find_medium(std::string_view id) noexcept {
  return Materials::built_in().find_medium(id);
}

std::uint32_t ink_color_on(std::uint32_t ink_rgb, std::uint32_t surface_rgb) noexcept {
  constexpr int kVisible = 80;  // distance in RGB
  constexpr std::uint32_t kOnLight = 0x3C66A0, kOnDark = 0xD6D4CC;
  const auto part = [](std::uint32_t rgb, unsigned shift) {
    return static_cast<int>(rgb >> shift & 0xFFU);
  };
  int squares = 0;
  for (const unsigned shift : {0U, 8U, 16U}) {
    const int difference = part(ink_rgb, shift) - part(surface_rgb, shift);
    squares += difference * difference;
  }
  if (squares > kVisible * kVisible) return ink_rgb;
  return part(surface_rgb, 8U) < 128 ? kOnDark : kOnLight;
}

double friction_of(const Medium& medium, const SurfaceMaterial& surface) noexcept {
  double whole = std::min(medium.friction * surface.friction / surface_materials().front().friction,
                          kMaxFriction);
  for (const PairFriction& pair : medium.pairs) {
    if (pair.surface == surface.id) whole = pair.coefficient;
  }
  return std::max(medium.strength * whole, std::min(whole, medium.kept_friction));
}

}  // namespace felt
