#include "felt/driver/hidraw_port.h"

#include <fcntl.h>
#include <linux/hidraw.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace felt {
namespace {

constexpr std::int64_t kNsPerMs = 1'000'000;
constexpr std::int64_t kMaxWaitMs = 10'000;
constexpr std::size_t kMaxReportBytes =
    4096;  // length of one report; an ioctl's length has 12 bits

class HidrawFile final : public HidrawPort {
 public:
  explicit HidrawFile(int descriptor) noexcept : descriptor_(descriptor) {}
  ~HidrawFile() override { close(descriptor_); }

  tl::expected<void, int> write(std::span<const std::uint8_t> report) noexcept override {
    const ssize_t count = ::write(descriptor_, report.data(), report.size());
    if (count < 0) return tl::unexpected(errno);
    if (static_cast<std::size_t>(count) != report.size()) return tl::unexpected(EIO);
    return {};
  }

  tl::expected<std::size_t, int> read(std::span<std::uint8_t> room,
                                      std::int64_t within_ns) noexcept override {
    const std::int64_t ms = std::clamp<std::int64_t>(within_ns / kNsPerMs, 0, kMaxWaitMs);
    pollfd wait{descriptor_, POLLIN, 0};
    const int ready = poll(&wait, 1, static_cast<int>(ms));
    if (ready < 0) return errno == EINTR ? tl::expected<std::size_t, int>(0) : failed(errno);
    if (ready == 0) return 0;
    const ssize_t count = ::read(descriptor_, room.data(), room.size());
    if (count >= 0) return static_cast<std::size_t>(count);
    return errno == EAGAIN ? tl::expected<std::size_t, int>(0) : failed(errno);
  }

  tl::expected<std::size_t, int> feature(std::span<std::uint8_t> room) noexcept override {
    if (room.empty() || room.size() > kMaxReportBytes) return failed(EINVAL);
    const int count = ioctl(descriptor_, HIDIOCGFEATURE(room.size()), room.data());
    if (count < 0) return failed(errno);
    return std::min(static_cast<std::size_t>(count), room.size());
  }

 private:
  static tl::expected<std::size_t, int> failed(int error) noexcept { return tl::unexpected(error); }

  int descriptor_;
};

}  // namespace

Result<std::unique_ptr<HidrawPort>> open_hidraw(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) {
    const int error = errno;
    return fail(error == ENOENT ? ErrorCode::kNotFound : ErrorCode::kIo,
                path + ": " + std::strerror(error));
  }
  return std::make_unique<HidrawFile>(descriptor);
}

}  // namespace felt
