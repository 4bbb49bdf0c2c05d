#include "tests/devices/drivers/pantograph/fake_board.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "felt/base/constants.h"

namespace felt::pantograph {
namespace {

float get_float(std::span<const std::byte> bytes) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i) bits |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * i);
  return std::bit_cast<float>(bits);
}

unsigned number(std::byte byte) {
  return std::to_integer<unsigned>(byte);
}

// Returns the angles for a position, or for the reachable position nearest to it towards the middle
// of the reach.
std::array<double, 2> nearest_angles(const BoardModel& model, const Vec3& place) {
  const Vec3 middle = 0.5 * (model.reach_min + model.reach_max);
  const auto at = [&](double share) {
    const auto angles = angles_for(model.size, middle + share * (place - middle));
    return angles && FiveBar::at(model.size, *angles) ? angles : std::nullopt;
  };
  if (const auto angles = at(1.0)) return *angles;
  double good = 0.0, bad = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double share = 0.5 * (good + bad);
    (at(share) ? good : bad) = share;
  }
  return *at(good);
}

}  // namespace

// The driver's end of the port.
class BoardPort final : public ByteStream {
 public:
  explicit BoardPort(FakeBoard& board) : board_(board) { out_.reserve(4096); }
  ~BoardPort() override = default;

  tl::expected<void, StreamFault> send(std::span<const std::byte> bytes,
                                       std::int64_t) noexcept override {
    if (!board_.is_plugged()) is_over_ = true;
    if (is_over_) return tl::unexpected(StreamFault::kClosed);
    if (!board_.takes(bytes)) return tl::unexpected(StreamFault::kTimedOut);
    board_.take(bytes, out_);
    if (!board_.is_plugged()) is_over_ = true;
    if (is_over_) return tl::unexpected(StreamFault::kClosed);
    return {};
  }
  tl::expected<std::size_t, StreamFault> receive(std::span<std::byte> room,
                                                 std::int64_t) noexcept override {
    if (!board_.is_plugged()) is_over_ = true;
    if (is_over_) return tl::unexpected(StreamFault::kClosed);
    if (out_.empty()) return tl::unexpected(StreamFault::kTimedOut);
    const std::size_t count = std::min(room.size(), out_.size());
    std::copy_n(out_.begin(), count, room.begin());
    out_.erase(out_.begin(), out_.begin() + static_cast<std::ptrdiff_t>(count));
    if (out_.empty()) board_.reported_rad_ = board_.answered_rad_;
    return count;
  }
  bool keep_guard(std::span<const std::byte> last_words, std::int64_t) override {
    board_.last_words_.assign(last_words.begin(), last_words.end());
    board_.is_guarded_ = true;
    return !board_.refuses_guards_;
  }
  [[nodiscard]] bool is_guarded() const noexcept override { return board_.is_guarded_; }

 private:
  FakeBoard& board_;
  std::vector<std::byte> out_;
  bool is_over_ = false;  // a port that was unplugged stays closed, even if the board returns
};

FakeBoard::FakeBoard(FakeWorld& world, std::vector<FaultWindow> faults, const BoardModel& model,
                     const PlaneCalibration& plane)
    : world_(world), faults_(std::move(faults)), model_(model), plane_(plane) {
  in_.reserve(4096);
  tick(0);
}

FakeBoard::~FakeBoard() = default;

Result<std::unique_ptr<ByteStream>> FakeBoard::open(const std::string& path) {
  if (!is_plugged_) return fail(ErrorCode::kNotFound, path + ": No such file or directory");
  return std::make_unique<BoardPort>(*this);
}

bool FakeBoard::is_active(InjectedFault fault) const noexcept {
  return std::any_of(faults_.begin(), faults_.end(), [&](const FaultWindow& window) {
    return window.fault == fault && now_ns_ >= window.from_ns && now_ns_ < window.until_ns;
  });
}

void FakeBoard::release() noexcept {
  torques_ = {};
  world_.device().stop();
}

void FakeBoard::unplug() noexcept {
  is_plugged_ = false;
  is_set_up_ = false;
  hangs_ = false;
  release();  // the board powers the motors
}

void FakeBoard::tick(std::int64_t now_ns) {
  now_ns_ = now_ns;
  const auto pen = world_.device().read(now_ns);
  if (!pen) {
    if (is_plugged_) unplug();
    return;
  }
  is_plugged_ = true;
  measure(*pen);
}

void FakeBoard::measure(const PenSample& pen) {
  const Vec3 place = plane_.to_device(pen.position);
  if (!std::isfinite(place.x) || !std::isfinite(place.y)) {
    degrees_.fill(std::numeric_limits<float>::quiet_NaN());
    return;
  }
  const auto angles = nearest_angles(model_, {place.x, place.y, 0.0});
  for (std::size_t k = 0; k < 2; ++k) {
    const auto per_turn = static_cast<double>(model_.motors[k].counts_per_turn);
    const auto rest = static_cast<double>(model_.motors[k].rest_deg);
    // If the encoder was set up with the arms at rest, it counts from there.
    const double counts = std::round((kDegPerRad * angles[k] - rest) * per_turn / 360.0);
    const double scale = is_set_up_ ? static_cast<double>(counts_[k]) : per_turn;
    degrees_[k] = static_cast<float>((is_set_up_ ? static_cast<double>(offset_[k]) : rest) +
                                     counts * 360.0 / scale);
  }
}

void FakeBoard::hang(std::size_t room) noexcept {
  hangs_ = true;
  room_ = room;
}

void FakeBoard::go_on(std::vector<std::byte>& out) {
  hangs_ = false;
  take({}, out);
}

// Returns true if these bytes are sent. While writing fails (kWriteError), no torque is sent, and
// only every other frame without a torque.
bool FakeBoard::takes(std::span<const std::byte> bytes) noexcept {
  if (hangs_ && in_.size() + bytes.size() > room_) return false;
  if (refusals_ > 0) {
    --refusals_;
    return false;
  }
  if (!is_active(InjectedFault::kWriteError)) return true;
  const bool is_torque =
      bytes.size() == std::tuple_size_v<TorqueFrame> && number(bytes[0]) == 2 &&
      std::any_of(bytes.begin() + 2, bytes.end(), [](std::byte b) { return b != std::byte{0}; });
  refused_last_ = is_torque || !refused_last_;
  return !refused_last_;
}

void FakeBoard::take(std::span<const std::byte> bytes, std::vector<std::byte>& out) {
  in_.insert(in_.end(), bytes.begin(), bytes.end());
  while (is_plugged_ && !hangs_) {
    const std::size_t used = take_frame(in_, out);
    if (used == 0) return;
    in_.erase(in_.begin(), in_.begin() + static_cast<std::ptrdiff_t>(used));
  }
}

// Returns the length of the first frame in bytes, or 0 if it is incomplete.
std::size_t FakeBoard::take_frame(std::span<const std::byte> bytes, std::vector<std::byte>& out) {
  if (bytes.size() < 2) return 0;
  const unsigned type = number(bytes[0]);
  if (type == 0) {
    if (number(bytes[1]) != 0) break_rule("a reset of a device");
    ++resets_;
    is_set_up_ = false;
    release();
    return 2;
  }
  if (type > 2) {
    break_rule("a frame of no known type");
    return bytes.size();
  }
  if (number(bytes[1]) != kDeviceId) break_rule("a frame for another device");
  if (type == 1) return take_setup(bytes);
  constexpr std::size_t kTorqueBytes = 2 + 2 * 4;
  if (bytes.size() < kTorqueBytes) return 0;
  take_torques(bytes.subspan(2, 8), out);
  return kTorqueBytes;
}

std::size_t FakeBoard::take_setup(std::span<const std::byte> bytes) {
  constexpr std::size_t kBytes = 26;
  if (bytes.size() < kBytes) return 0;
  const auto mask = [&](std::size_t at) { return number(bytes[at]); };
  if (mask(2) != 3 || mask(5) != 3) break_rule("motors and encoders are on ports 1 and 2");
  if (mask(8) != 0 || mask(9) != 0) break_rule("there are no sensors and no pwm");
  for (std::size_t port = 1; port <= 2; ++port) {
    const std::size_t k = model_.motors[0].port == port ? 0 : 1;
    if (mask(2 + port) != unsigned{model_.motors[k].turns_ccw} ||
        mask(5 + port) != unsigned{model_.motors[k].counts_ccw}) {
      break_rule("a motor or encoder turns the wrong way");
    }
    offset_[k] = get_float(bytes.subspan(10 + 8 * (port - 1), 4));
    counts_[k] = get_float(bytes.subspan(14 + 8 * (port - 1), 4));
  }
  is_set_up_ = true;
  return kBytes;
}

void FakeBoard::take_torques(std::span<const std::byte> bytes, std::vector<std::byte>& out) {
  if (!is_set_up_) break_rule("torques before the board is set up");
  for (std::size_t port = 1; port <= 2; ++port) {
    const std::size_t k = model_.motors[0].port == port ? 0 : 1;
    torques_[k] = static_cast<double>(get_float(bytes.subspan(4 * (port - 1), 4))) / model_.gain;
  }
  const bool is_nothing = torques_[0] == 0.0 && torques_[1] == 0.0;
  if (is_active(InjectedFault::kNoAnswer)) {
    if (is_nothing) release();  // as in FaultyDevice: a release is never lost
    return;
  }
  apply();
  if (is_nothing) release();
  if (is_plugged_ && !is_silent_) answer(out);
}

// Returns the force of these torques at the position where the computer assumes the handle.
Force FakeBoard::newest_force() const noexcept {
  const auto bar = FiveBar::at(model_.size, reported_rad_);
  if (!bar) return {};
  const auto& j = bar->jacobian();
  const double det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
  const double t1 = 1e3 * torques_[0], t2 = 1e3 * torques_[1];  // N mm
  if (!(std::abs(det) > 1e-9)) return {};
  return {(j[1][1] * t1 - j[1][0] * t2) / det, (j[0][0] * t2 - j[0][1] * t1) / det, 0.0};
}

void FakeBoard::apply() {
  const Force force = newest_force();
  const bool is_number = std::isfinite(torques_[0]) && std::isfinite(torques_[1]);
  largest_n_ =
      std::max(largest_n_, is_number ? norm(force) : std::numeric_limits<double>::infinity());
  const Vec3 turned = plane_.turn_to_page(Vec3{force.x, force.y, 0.0});
  const bool went = world_.device().write({turned.x, turned.y, turned.z}).has_value();
  if (!went && !is_active(InjectedFault::kWriteError)) unplug();
}

void FakeBoard::answer(std::vector<std::byte>& out) {
  out.insert(out.end(), noise_.begin(), noise_.end());
  noise_.clear();
  std::array<std::byte, kReplyBytes> reply{static_cast<std::byte>(id_)};
  for (std::size_t port = 1; port <= 2; ++port) {
    const std::size_t k = model_.motors[0].port == port ? 0 : 1;
    answered_rad_[k] = static_cast<double>(degrees_[k]) / kDegPerRad;
    const auto bits = std::bit_cast<std::uint32_t>(degrees_[k]);
    for (std::size_t i = 0; i < 4; ++i) {
      reply[1 + 4 * (port - 1) + i] = static_cast<std::byte>(bits >> (8 * i));
    }
  }
  out.insert(out.end(), reply.begin(), reply.end() - static_cast<std::ptrdiff_t>(cut_));
}

}  // namespace felt::pantograph
