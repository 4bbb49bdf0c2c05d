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

/// Maximum size of a force functor in bytes. It is enough for three cubics, some wells, tethers and
/// a pointer to a texture.
inline constexpr std::size_t kForceFunctorBytes = 2048;

/// A force that may run on the haptic thread. It has constant size, is copied as bytes and never
/// throws. `slopes()` returns the stiffness that the force needs from the stiffness budget (R56).
/// Objects that the functor points to must outlive the loop.
template <class F>
concept ForceFunctor = std::is_trivially_copyable_v<F> && sizeof(F) <= kForceFunctorBytes &&
                       alignof(F) <= alignof(std::max_align_t) &&
                       requires(const F& f, const PenSample& sample, ForceMemory& memory) {
  { f(sample, memory) }
  noexcept->std::same_as<Force>;
  { f.slopes() }
  noexcept->std::same_as<Slopes>;
};

/// A force that uses ForceMemory::guide. Only one such force can act at a time.
template <class F>
concept GuideForce = requires {
  requires F::kIsGuide;
};

/// Holds any force functor in one trivially copyable type. A tool publishes a ForceModel and the
/// haptic loop evaluates it at each tick. A default ForceModel has no force.
///
///   ForceModel model(Compose(Plane(...), Friction(...)));   // edit thread
///   servo.publish(model);                                   // wait-free
///
/// operator() and slopes() are real-time safe and may be called on the haptic thread. Term names
/// that the functor adds must be string literals.
class ForceModel {
 public:
  ForceModel() noexcept = default;

  template <ForceFunctor F>
  requires(!std::same_as<F, ForceModel>) explicit ForceModel(const F& functor) noexcept
      : call_(call_of<F>()), slopes_(functor.slopes()), size_(sizeof(F)), is_guide_(GuideForce<F>) {
    ::new (static_cast<void*>(storage_.data())) F(functor);
  }

  /// Adds a force, which is evaluated after the others, for code that does not know the type of the
  /// functor. Returns false and changes nothing if there is not enough space, if a force was added
  /// before, or if both this model and the force are guides.
  template <ForceFunctor F>
  [[nodiscard]] bool add(const F& functor) noexcept {
    constexpr std::size_t kAlign = alignof(std::max_align_t);
    const std::size_t at = (size_ + kAlign - 1) / kAlign * kAlign;
    if (added_call_ || at + sizeof(F) > kForceFunctorBytes) return false;
    if (is_guide_ && GuideForce<F>) return false;
    ::new (static_cast<void*>(storage_.data() + at)) F(functor);
    added_call_ = call_of<F>();
    added_at_ = at;
    slopes_ = slopes_ + functor.slopes();
    return true;
  }

  /// Returns the force on the pen, in N, and adds its parts to memory.terms.
  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
    const Force force = call_ ? call_(storage_.data(), sample, memory) : Force{};
    return added_call_ ? force + added_call_(storage_.data() + added_at_, sample, memory) : force;
  }
  /// Returns the stiffness that the functor needs from the budget.
  [[nodiscard]] const Slopes& slopes() const noexcept { return slopes_; }
  /// Returns true if the model holds a functor.
  [[nodiscard]] explicit operator bool() const noexcept { return call_ != nullptr; }

  /// Returns the id that controls cross-fading. When the id changes (another tool, material or
  /// target), the loop cross-fades between the two models over 20 ms. A model with the same id
  /// replaces the previous one immediately; use that for the same forces with parameters that
  /// change smoothly.
  [[nodiscard]] std::uint32_t fade_id() const noexcept { return fade_id_; }
  void set_fade_id(std::uint32_t id) noexcept { fade_id_ = id; }

 private:
  using Call = Force (*)(const void*, const PenSample&, ForceMemory&) noexcept;

  template <ForceFunctor F>
  static constexpr Call call_of() noexcept {
    return [](const void* object, const PenSample& sample, ForceMemory& memory) noexcept {
      return (*static_cast<const F*>(object))(sample, memory);
    };
  }

  alignas(std::max_align_t) std::array<std::byte, kForceFunctorBytes> storage_{};
  Call call_ = nullptr;
  Call added_call_ = nullptr;
  Slopes slopes_;
  std::size_t size_ = 0;      // of the functor, bytes
  std::size_t added_at_ = 0;  // position of the added functor
  std::uint32_t fade_id_ = 0;
  bool is_guide_ = false;  // GuideForce
};

static_assert(std::is_trivially_copyable_v<ForceModel>);

/// The sum of several force functors, called bricks, evaluated in the order given: a brick that
/// reads the push of the plane must come after the plane. A Compose is itself a brick; slopes add.
///
///   ForceModel model(Compose(Plane(plane), Texture(grain), Friction(friction), SnapWells(...)));
///
/// It is not a std::tuple, because a std::tuple is not trivially copyable.
template <ForceFunctor... Bricks>
class Compose;

template <>
class Compose<> {
 public:
  static constexpr bool kIsGuide = false;

  Force operator()(const PenSample&, ForceMemory&) const noexcept { return {}; }
  [[nodiscard]] Slopes slopes() const noexcept { return {}; }
};

template <ForceFunctor First, ForceFunctor... Rest>
class Compose<First, Rest...> {
 public:
  static constexpr bool kIsGuide = GuideForce<First> || Compose<Rest...>::kIsGuide;

  explicit Compose(const First& first, const Rest&... rest) noexcept
      : first_(first), rest_(rest...) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
    // A separate statement, so that this brick is evaluated before the others.
    const Force force = first_(sample, memory);
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
