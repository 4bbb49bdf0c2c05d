#include "console.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace felt::cli {
namespace {

constexpr int kBarCells = 24;

bool can_redraw_stderr() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

/// The bar uses characters only, no colour, so there is nothing that NO_COLOR would switch off.
std::string bar(double fraction) {
  const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kBarCells);
  return "[" + std::string(static_cast<std::size_t>(filled), '#') +
         std::string(static_cast<std::size_t>(kBarCells - filled), '.') + "]";
}

}  // namespace

Console::Console()
    : shows_progress_(can_redraw_stderr()),
      next_draw_(Clock::now() + std::chrono::milliseconds(500)) {}

Console::~Console() {
  end_progress();
}

void Console::error(const std::string& message) {
  end_progress();
  failed_ = true;
  fmt::print(stderr, "feltline: {}\n", message);
}

void Console::notice(const std::string& message) {
  if (strict_) return error(message);
  if (!shows_notices_) return;
  end_progress();
  fmt::print(stderr, "feltline: {}\n", message);
}

void Console::progress(const char* what, std::int64_t done, std::int64_t total,
                       std::int64_t strokes) {
  if (!shows_progress_ || Clock::now() < next_draw_) return;
  next_draw_ = Clock::now() + std::chrono::milliseconds(100);
  std::string line = fmt::format("\r{} ", what);
  if (total > 0) {
    const double fraction = static_cast<double>(done) / static_cast<double>(total);
    line += fmt::format("{} {:3.0f} %  ", bar(fraction), std::min(100.0, 100.0 * fraction));
  }
  fmt::print(stderr, "{}{} strokes\x1b[K", line, strokes);
  std::fflush(stderr);
  drawn_ = true;
}

void Console::status(const std::string& line) {
  if (!shows_progress_ || Clock::now() < next_draw_) return;
  next_draw_ = Clock::now() + std::chrono::milliseconds(100);
  fmt::print(stderr, "\r{}\x1b[K", line);
  std::fflush(stderr);
  drawn_ = true;
}

void Console::end_progress() {
  if (!drawn_) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace felt::cli
