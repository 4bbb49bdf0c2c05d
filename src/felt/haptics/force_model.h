#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>

#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// Largest force functor, in bytes: three cubics, a few wells, tethers and a pointer to a texture.
inline constexpr std::size_t kForceFunctorBytes = 2048;

/// What may run on the haptic thread as a force: constant size, copied as bytes, never throwing.
/// `slopes()` is the stiffness budget it claims (R56). Pointers inside must outlive the loop.
template <class F>
concept ForceFunctor = std::is_trivially_copyable_v<F> && sizeof(F) <= kForceFunctorBytes &&
                       alignof(F) <= alignof(std::max_align_t) &&
                       requires(const F& f, const PenSample& sample, ForceMemory& memory) {
  { f(sample, memory) }
  noexcept->std::same_as<Force>;
  { f.slopes() }
  noexcept->std::same_as<Slopes>;
};

/// Any force functor behind one type, itself trivially copyable: what a tool publishes and the
/// haptic loop evaluates at each tick. The default is no force.
///
///   ForceModel model(Compose(Plane(...), Friction(...)));   // edit thread
///   servo.publish(model);                                   // wait-free hand-over
///
/// Haptic thread: operator() and slopes() are real-time safe. The functor's names of terms must be
/// string literals.
class ForceModel {
 public:
  ForceModel() noexcept = default;

  template <ForceFunctor F>
  requires(!std::same_as<F, ForceModel>) explicit ForceModel(const F& functor) noexcept
      : call_([](const void* object, const PenSample& sample, ForceMemory& memory) noexcept {
          return (*static_cast<const F*>(object))(sample, memory);
        }),
        slopes_(functor.slopes()) {
    ::new (static_cast<void*>(storage_.data())) F(functor);
  }

  /// The force on the pen, in N. Adds its parts to memory.terms.
  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
    return call_ ? call_(storage_.data(), sample, memory) : Force{};
  }
  /// The stiffness it claims.
  [[nodiscard]] const Slopes& slopes() const noexcept { return slopes_; }
  /// True when there is a functor inside.
  [[nodiscard]] explicit operator bool() const noexcept { return call_ != nullptr; }

  /// Which feel this is. The loop cross-fades over 20 ms between models of different ids (another
  /// tool, material, target); one with the same id replaces the last at once: the same feel with
  /// parameters that moved on smoothly.
  [[nodiscard]] std::uint32_t fade_id() const noexcept { return fade_id_; }
  void set_fade_id(std::uint32_t id) noexcept { fade_id_ = id; }

 private:
  using Call = Force (*)(const void*, const PenSample&, ForceMemory&) noexcept;

  alignas(std::max_align_t) std::array<std::byte, kForceFunctorBytes> storage_{};
  Call call_ = nullptr;
  Slopes slopes_;
  std::uint32_t fade_id_ = 0;
};

static_assert(std::is_trivially_copyable_v<ForceModel>);

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
