#pragma once

#include "felt/haptics/force_model.h"

namespace felt {

/// The sum of some force bricks, evaluated in the order in which they are written: what reads the
/// push of the plane stands behind the plane. Itself a brick; slopes add.
///
///   ForceModel model(Compose(Plane(plane), Texture(grain), Friction(friction), Wells(...)));
///
/// Not a std::tuple, whose copy is not trivial.
template <ForceFunctor... Bricks>
class Compose;

template <>
class Compose<> {
 public:
  Force operator()(const PenSample&, ForceMemory&) const noexcept { return {}; }
  [[nodiscard]] Slopes slopes() const noexcept { return {}; }
};

template <ForceFunctor First, ForceFunctor... Rest>
class Compose<First, Rest...> {
 public:
  explicit Compose(const First& first, const Rest&... rest) noexcept
      : first_(first), rest_(rest...) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
    const Force force = first_(sample, memory);  // before the rest: order matters
    return force + rest_(sample, memory);
  }
  [[nodiscard]] Slopes slopes() const noexcept { return first_.slopes() + rest_.slopes(); }

 private:
  First first_;
  Compose<Rest...> rest_;
};

template <class... Bricks>
Compose(const Bricks&...) -> Compose<Bricks...>;

}  // namespace felt
