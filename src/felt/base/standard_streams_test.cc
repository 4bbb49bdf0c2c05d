#include "felt/base/standard_streams.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace felt::standard_streams_test {
namespace {

/// Runs `check` in a process with closed standard streams and returns its exit code.
template <typename Check>
int in_process_without_streams(Check check) {
  const pid_t child = fork();
  if (child == 0) {
    for (int fd = 0; fd <= 2; ++fd) close(fd);
    open_standard_streams();
    _exit(check());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(StandardStreams, NoFileGetsTheNumberOfAClosedStream) {
  EXPECT_GE(in_process_without_streams([] { return open("/dev/null", O_WRONLY); }), 3);
}

TEST(StandardStreams, UsingAClosedStreamStillFails) {
  EXPECT_EQ(in_process_without_streams([] {
              char c = 'x';
              return (::read(0, &c, 1) < 0 ? 1 : 0) + (::write(1, &c, 1) < 0 ? 2 : 0) +
                     (::write(2, &c, 1) < 0 ? 4 : 0);
            }),
            7);
}

TEST(StandardStreams, OpenStreamsStay) {
  const int before = fcntl(STDERR_FILENO, F_GETFL);
  open_standard_streams();
  EXPECT_EQ(fcntl(STDERR_FILENO, F_GETFL), before);
}

}  // namespace
}  // namespace felt::standard_streams_test
