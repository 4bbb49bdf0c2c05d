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

/// Events that nobody has read yet, in memory of its own: a tick takes them out.
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

/// A joystick with force feedback as the kernel shows it: a node in sysfs, events, effects in slots
/// that it renders by itself, a thousand times a second. Behind it, a stick of the simulation: in
/// the sheet's frame, of which the stick's middle is kMiddle.
///
/// Its rules: an upload of what it has not got is EINVAL, of more than it has room for ENOSPC; all
/// is ENODEV once it was unplugged, for those who had it open; effects must end by themselves; its
/// own spring must be off before one plays; 125 uploads a second are the most that its transfer
/// bears. The haptic thread may ask for the next event and for nothing else, since all else waits
/// for the kernel's lock of the device.
class FakeStick {
 public:
  static constexpr Point kMiddle{55.0, 45.0};
  static constexpr double kHalfWayMm = 45.0;
  static constexpr double kFullN = 8.0;
  static constexpr int kSlots = 16;
  static constexpr double kDepthMm = 6.0;  ///< of the pen, at which its lever is at its end
  static constexpr std::int32_t kCounts = 32767, kLeverCounts = 1023;
  static constexpr std::int64_t kPollNs = 8'000'000;
  static constexpr std::int64_t kUploadNs = 8'000'000;

  explicit FakeStick(std::vector<FaultWindow> faults, std::vector<std::uint16_t> effects = {});

  static StylusPreset preset();
  [[nodiscard]] FakeWorld& world() noexcept { return world_; }
  /// The machine that it is plugged into: its node is there while it is.
  [[nodiscard]] const SystemView& system() const noexcept { return system_; }
  /// Another look at the same, to forbid things.
  [[nodiscard]] FakeSystem& fake_system() noexcept { return system_; }
  Result<std::unique_ptr<EvdevPort>> open(const std::string& path);

  /// Time goes on: the world moves, effects push, each kPollNs it reports.
  void tick(std::int64_t now_ns) noexcept;
  /// Whether what comes now is of the haptic thread, or of one that may wait (as at first).
  void set_haptic_thread(bool is_haptic) noexcept { is_haptic_ = is_haptic; }
  /// Its events are lost, as when nobody reads them for long.
  void drop_events() noexcept;
  /// Uploads say this errno; 0: no longer.
  void refuse_uploads(int error) noexcept { must_refuse_ = error; }
  void set_slots(int slots) noexcept { slots_ = slots; }

  /// What this stick says of a pen: pressure in steps of its lever, no height.
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
    std::int64_t until_ns = 0;  // plays up to then
    bool plays = false;
    std::int64_t uploaded_ns = 0;
  };

  void plug(bool in) noexcept;
  void report(const PenSample& pen) noexcept;
  void push(const PenSample& pen) noexcept;
  [[nodiscard]] Force force_at(const PenSample& pen) const noexcept;
  void note_asked() noexcept;
  void let_go_if_quiet() noexcept;
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
  int refused_ = 0;      // by the world behind it
  int must_refuse_ = 0;  // by a test
  int uploads_ = 0;
  bool is_haptic_ = false;
  double largest_n_ = 0.0;
  std::string rule_;
};

}  // namespace felt
