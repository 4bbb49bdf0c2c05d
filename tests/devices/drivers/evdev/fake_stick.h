#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "felt/driver/evdev_port.h"
#include "felt/driver/testing/fake_system.h"
#include "tests/devices/drivers/fake_world.h"

namespace felt {

/// Events that have not been read yet, in preallocated memory. A tick removes them.
class EventQueue {
 public:
  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  [[nodiscard]] std::size_t size() const noexcept { return count_; }
  [[nodiscard]] const EvdevEvent& front() const noexcept { return events_[first_]; }
  void push_back(const EvdevEvent& event) noexcept {
    if (count_ < events_.size()) events_[(first_ + count_++) % events_.size()] = event;
  }
  void pop_front() noexcept {
    first_ = (first_ + 1) % events_.size();
    --count_;
  }
  void clear() noexcept { count_ = 0; }

 private:
  std::array<EvdevEvent, 128> events_{};
  std::size_t first_ = 0, count_ = 0;
};

/// A joystick with force feedback as the kernel shows it: a node in sysfs, events, and effects in
/// slots, which it renders itself a thousand times a second. Behind it is a simulated stick in
/// the frame of the surface; kMiddle is the middle of the stick.
///
/// Its rules: uploading an unsupported effect gives EINVAL, uploading more effects than it has
/// slots gives ENOSPC. After it was unplugged, every call on an open node gives ENODEV. Effects
/// must have a duration. The stick's own spring must be off before an effect plays. Its transfer
/// allows at most 125 uploads a second. The haptic thread may only read the next event, because
/// every other call waits for the kernel's lock of the device.
class FakeStick {
 public:
  static constexpr Point kMiddle{55.0, 45.0};
  static constexpr double kHalfWayMm = 45.0;
  static constexpr double kFullN = 8.0;
  static constexpr int kSlots = 16;
  static constexpr double kDepthMm = 6.0;  ///< pen depth at which the lever is at its end
  static constexpr std::int32_t kCounts = 32767, kLeverCounts = 1023;
  static constexpr std::int64_t kPollNs = 8'000'000;
  static constexpr std::int64_t kUploadNs = 8'000'000;

  explicit FakeStick(std::vector<FaultWindow> faults, std::vector<std::uint16_t> effects = {});

  static StylusPreset preset();
  [[nodiscard]] FakeWorld& world() noexcept { return world_; }
  /// Returns the machine that it is plugged into. The node exists while the stick is plugged in.
  [[nodiscard]] const SystemView& system() const noexcept { return system_; }
  /// Returns the same machine as system(), for tests that must forbid calls.
  [[nodiscard]] FakeSystem& fake_system() noexcept { return system_; }
  Result<std::unique_ptr<EvdevPort>> open(const std::string& path);

  /// Advances the time: the world moves, effects push, and the stick reports once every kPollNs.
  void tick(std::int64_t now_ns) noexcept;
  /// Sets whether the next calls come from the haptic thread or from a thread that may wait (the
  /// default).
  void set_haptic_thread(bool is_haptic) noexcept { is_haptic_ = is_haptic; }
  /// Drops its unread events, as if nobody had read them for a long time.
  void drop_events() noexcept;
  /// Makes uploads fail with this errno; 0 ends this.
  void refuse_uploads(int error) noexcept { must_refuse_ = error; }
  void set_slots(int slots) noexcept { slots_ = slots; }

  /// Returns the sample that this stick reports for a pen: pressure in steps of its lever, no
  /// height.
  static PenSample as_said(const PenSample& pen) noexcept;

  [[nodiscard]] double largest_asked_n() const noexcept { return largest_n_; }
  [[nodiscard]] std::string_view broken_rule() const noexcept { return rule_; }
  [[nodiscard]] std::size_t effects_kept() const noexcept { return effects_.size(); }
  [[nodiscard]] std::size_t playing() const noexcept;
  [[nodiscard]] int uploads() const noexcept { return uploads_; }
  [[nodiscard]] const std::map<std::int16_t, EvdevEffect>& effects() const noexcept {
    return kept_;
  }

 private:
  class Port;
  struct Slot {
    std::int64_t until_ns = 0;  // plays until this time
    bool plays = false;
    std::int64_t uploaded_ns = 0;
  };

  void plug(bool in) noexcept;
  void report(const PenSample& pen) noexcept;
  void push(const PenSample& pen) noexcept;
  [[nodiscard]] Force force_at(const PenSample& pen) const noexcept;
  void note_asked() noexcept;
  void release_if_quiet() noexcept;
  void forbid(const char* rule) noexcept {
    if (rule_.empty()) rule_ = rule;
  }
  tl::expected<std::int16_t, int> upload(const EvdevEffect& effect) noexcept;
  tl::expected<void, int> erase(std::int16_t id) noexcept;
  tl::expected<void, int> send(const EvdevEvent& event) noexcept;

  FakeWorld world_;
  FakeSystem system_;
  std::set<std::uint16_t> kinds_;
  int slots_ = kSlots;
  bool is_plugged_ = false;
  std::uint32_t pluggings_ = 0;
  std::int64_t now_ns_ = 0, reported_ns_ = 0;
  bool has_reported_ = false;
  std::map<std::uint16_t, std::int32_t> said_axes_;
  std::map<std::uint16_t, bool> said_keys_;
  EventQueue events_;
  std::map<std::int16_t, EvdevEffect> kept_;
  std::map<std::int16_t, Slot> effects_;
  std::int32_t gain_ = 0xFFFF, autocenter_ = 0x8000;
  int refused_ = 0;      // by the simulated world
  int must_refuse_ = 0;  // by a test
  int uploads_ = 0;
  bool is_haptic_ = false;
  double largest_n_ = 0.0;
  std::string rule_;
};

}  // namespace felt
