#include "question.h"

#include <poll.h>
#include <unistd.h>

#include <cstdio>

#include "print.h"

namespace felt::cli {

bool somebody_is_there() {
  return isatty(STDIN_FILENO) != 0;
}

bool ask(const std::string& question) {
  if (!somebody_is_there()) return false;
  say("{} [y/N] ", question);
  std::fflush(stderr);
  std::string answer;
  for (char c = 0; read(STDIN_FILENO, &c, 1) == 1 && c != '\n' && answer.size() < 16;) answer += c;
  return answer == "y" || answer == "Y" || answer == "yes" || answer == "Yes";
}

bool enter_pressed() {
  if (!somebody_is_there()) return false;
  pollfd keys{STDIN_FILENO, POLLIN, 0};
  if (poll(&keys, 1, 0) <= 0 || (keys.revents & POLLIN) == 0) return false;
  char line[256];
  return read(STDIN_FILENO, line, sizeof line) > 0;
}

}  // namespace felt::cli
