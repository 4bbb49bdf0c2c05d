#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "felt/devices/pantograph/board.h"
#include "felt/driver/byte_stream.h"
#include "felt/driver/plane_calibration.h"
#include "tests/devices/drivers/fake_world.h"

namespace felt::pantograph {

/// Haply's board with the arms of a 2DIY, moved by the simulated pen: its frames, its encoders
/// (which count whole counts from the position at set-up), its motors. Stores the first broken rule
/// of the protocol. Use it from one thread only. Never allocates within a tick.
class FakeBoard {
 public:
  FakeBoard(FakeWorld& world, std::vector<FaultWindow> faults, const BoardModel& model,
            const PlaneCalibration& plane);
  ~FakeBoard();

  void tick(std::int64_t now_ns);
  /// Opens the port. For PantographOptions::open.
  Result<std::unique_ptr<ByteStream>> open(const std::string& path);

  /// Accepts bytes from the computer. Answers are appended to `out`.
  void take(std::span<const std::byte> bytes, std::vector<std::byte>& out);
  [[nodiscard]] bool is_plugged() const noexcept { return is_plugged_; }

  // Faults that only a board has.
  void be_silent(bool is_silent) noexcept { is_silent_ = is_silent; }
  /// Removes the last bytes of each answer.
  void cut_answers(std::size_t bytes) noexcept { cut_ = bytes; }
  void answer_as(std::uint8_t id) noexcept { id_ = id; }
  /// Puts noise on the line before the next answer.
  void babble(std::vector<std::byte> bytes) { noise_ = std::move(bytes); }
  void unplug() noexcept;
  /// Makes the board hang, or continue. While it hangs, motors keep their torques, up to `room`
  /// bytes wait, and further bytes fail (kTimedOut).
  void hang(std::size_t room) noexcept;
  void go_on(std::vector<std::byte>& out);
  /// Makes this number of frames time out; later frames are sent.
  void refuse_frames(int count) noexcept { refusals_ = count; }

  [[nodiscard]] double largest_asked_n() const noexcept { return largest_n_; }
  [[nodiscard]] std::string_view broken_rule() const noexcept { return rule_; }
  [[nodiscard]] const std::array<double, 2>& torques_nm() const noexcept { return torques_; }
  /// Returns the force that the newest frame requested, for the arm position that the computer
  /// assumes; in the board's axes, N.
  [[nodiscard]] Force newest_force() const noexcept;
  [[nodiscard]] int resets() const noexcept { return resets_; }
  /// Returns the bytes that a guard would send when the program cannot; empty if no guard was
  /// requested.
  [[nodiscard]] const std::vector<std::byte>& last_words() const noexcept { return last_words_; }
  [[nodiscard]] bool is_set_up() const noexcept { return is_set_up_; }
  /// Makes it impossible to start a guard process, and ends a running one.
  void refuse_guards(bool refuses) noexcept { refuses_guards_ = refuses; }
  void kill_guard() noexcept { is_guarded_ = false; }

 private:
  friend class BoardPort;
  std::size_t take_frame(std::span<const std::byte> bytes, std::vector<std::byte>& out);
  std::size_t take_setup(std::span<const std::byte> bytes);
  void take_torques(std::span<const std::byte> bytes, std::vector<std::byte>& out);
  void measure(const PenSample& pen);
  void answer(std::vector<std::byte>& out);
  void apply();
  void release() noexcept;
  bool takes(std::span<const std::byte> bytes) noexcept;
  [[nodiscard]] bool is_active(InjectedFault fault) const noexcept;
  void break_rule(std::string_view rule) {
    if (rule_.empty()) rule_ = rule;
  }

  FakeWorld& world_;
  std::vector<FaultWindow> faults_;
  const BoardModel& model_;
  PlaneCalibration plane_;
  std::vector<std::byte> in_;
  std::int64_t now_ns_ = 0;
  std::array<float, 2> degrees_{};            // by motor, as the encoders measure them
  std::array<double, 2> answered_rad_{};      // in the newest answer
  std::array<double, 2> reported_rad_{};      // in the newest answer that the computer has read
  std::array<float, 2> offset_{}, counts_{};  // by motor, as they were set up
  std::array<double, 2> torques_{};
  double largest_n_ = 0.0;
  std::string rule_;
  std::vector<std::byte> noise_, last_words_;
  std::size_t cut_ = 0;
  std::uint8_t id_ = kDeviceId;
  int resets_ = 0;
  bool is_set_up_ = false;
  bool is_silent_ = false;
  bool is_plugged_ = true;
  bool hangs_ = false;
  std::size_t room_ = 0;  // for bytes that wait in in_ while it hangs
  int refusals_ = 0;
  bool refused_last_ = false;
  bool refuses_guards_ = false;
  bool is_guarded_ = true;
};

}  // namespace felt::pantograph
