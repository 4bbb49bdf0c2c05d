#include "felt/devices/hapticmaster/controller_link.h"

#include <algorithm>
#include <cstring>

namespace felt::hapticmaster {
namespace {

// True for printable ASCII and the white space that may end an answer.
bool is_text(std::byte byte) noexcept {
  const auto c = std::to_integer<unsigned char>(byte);
  return (c >= 0x20 && c < 0x7F) || c == '\t' || c == '\n' || c == '\r';
}

std::string_view trimmed(std::string_view text) noexcept {
  constexpr std::string_view kAround = " \t\r\n\";";
  const std::size_t first = text.find_first_not_of(kAround);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kAround) - first + 1);
}

}  // namespace

std::size_t write_request(std::string_view text, std::span<std::byte> room) noexcept {
  if (text.size() > kMaxRequest || room.size() < kHeaderBytes + text.size()) return 0;
  std::fill_n(room.begin(), kHeaderBytes, std::byte{0});
  room[3] = static_cast<std::byte>(text.size());
  const auto bytes = std::as_bytes(std::span(text));
  std::copy(bytes.begin(), bytes.end(), room.begin() + kHeaderBytes);
  return kHeaderBytes + text.size();
}

tl::unexpected<LinkFault> ControllerLink::end(LinkFault fault) noexcept {
  is_over_ = true;
  fault_ = fault;
  return tl::unexpected(fault);
}

tl::expected<void, LinkFault> ControllerLink::send(std::string_view text,
                                                   std::int64_t within_ns) noexcept {
  if (is_over_) return tl::unexpected(fault_);
  std::array<std::byte, kHeaderBytes + kMaxRequest> room{};
  const std::size_t size = write_request(text, room);
  const auto sent = stream_->send(std::span(room).first(size), within_ns);
  if (sent) return {};
  if (sent.error() == StreamFault::kTimedOut) return tl::unexpected(LinkFault::kTimedOut);
  return end(LinkFault::kClosed);
}

// Examines the first answer among the unread bytes.
ControllerLink::Look ControllerLink::look() noexcept {
  if (end_ - begin_ < kHeaderBytes) return Look::kMore;
  std::size_t size = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    size = (size << 8) | std::to_integer<std::size_t>(in_[begin_ + i]);
  }
  if (size == 0 || size > kMaxAnswer) return Look::kBad;
  const auto text = std::span(in_).subspan(begin_ + kHeaderBytes);
  const std::size_t here = std::min(size, end_ - begin_ - kHeaderBytes);
  if (!std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(here), is_text)) {
    return Look::kBad;
  }
  size_ = size;
  return here == size ? Look::kWhole : Look::kMore;
}

tl::expected<std::string_view, LinkFault> ControllerLink::receive(std::int64_t within_ns) noexcept {
  const StreamDeadline deadline(within_ns);
  for (int pieces = 0; pieces < kMaxPieces && !is_over_; ++pieces) {
    const Look found = look();
    if (found == Look::kBad) return end(LinkFault::kBadData);
    if (found == Look::kWhole) {
      const auto* const text = reinterpret_cast<const char*>(in_.data() + begin_ + kHeaderBytes);
      begin_ += kHeaderBytes + size_;
      return trimmed({text, size_});
    }
    std::memmove(in_.data(), in_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    const auto count = stream_->receive(std::span(in_).subspan(end_), deadline.left_ns());
    if (count) {
      end_ += *count;
    } else if (count.error() == StreamFault::kTimedOut) {
      return tl::unexpected(LinkFault::kTimedOut);
    } else {
      return end(LinkFault::kClosed);
    }
  }
  return tl::unexpected(is_over_ ? fault_ : LinkFault::kTimedOut);
}

}  // namespace felt::hapticmaster
