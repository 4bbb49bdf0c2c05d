#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "felt/base/result.h"

namespace felt {

/// A program that reads bytes from its stdin and writes a file: an encoder of films. It is started
/// directly, without a shell, in a process group of its own, so that Ctrl-C at a terminal ends it
/// only through this class. If this process is killed, the program reads the end of its input and
/// ends, too. Not thread-safe.
class EncoderProcess {
 public:
  /// The descriptor under which the program finds the file that it writes.
  static constexpr int kOutputFd = 3;

  /// Starts the program `words[0]`, found in PATH, with these arguments; `output_fd` becomes its
  /// descriptor kOutputFd. Fails with kNotFound if there is no such program, and with kIo if the
  /// system cannot start it; the message is the reason of the system.
  ///
  /// `is_cancelled` may be null. It is called while send() and finish() wait, several times a
  /// second and after each signal; if it returns true, they fail with the message "cancelled".
  static Result<EncoderProcess> start(const std::vector<std::string>& words, int output_fd,
                                      std::function<bool()> is_cancelled);

  EncoderProcess(EncoderProcess&& other) noexcept;
  EncoderProcess& operator=(EncoderProcess&&) = delete;
  /// Kills the program if it still runs.
  ~EncoderProcess();

  /// Sends bytes to the program. Waits while the program is slower. Fails if the program has ended
  /// or reads no more; finish() then has the reason.
  Result<void> send(std::span<const std::uint8_t> bytes);
  /// Ends the input and waits for the program. Fails if it ends with another exit code than 0; the
  /// message is the last line that it printed to stderr, or how it ended. Call it once.
  Result<void> finish();

 private:
  EncoderProcess(int input_fd, int errors_fd) noexcept : input_(input_fd), errors_(errors_fd) {}
  void close_input() noexcept;
  [[nodiscard]] bool is_cancelled() const { return is_cancelled_ && is_cancelled_(); }
  [[nodiscard]] std::string last_line() const;

  int input_ = -1;   // socket to the program's stdin
  int errors_ = -1;  // file in memory: its stderr
  pid_t pid_ = -1;   // -1 if it was waited for
  std::function<bool()> is_cancelled_;
};

}  // namespace felt
