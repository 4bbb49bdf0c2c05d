#include "tests/reliability/faults/fault_state.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

namespace felt::faults {

FaultState* state = nullptr;

const char* mode_name(Mode mode) noexcept {
  switch (mode) {
    case Mode::kNone:
      return "none";
    case Mode::kEio:
      return "eio";
    case Mode::kEnospc:
      return "enospc";
    case Mode::kEdquot:
      return "edquot";
    case Mode::kEintr:
      return "eintr";
    case Mode::kShort:
      return "short";
    case Mode::kHalfKill:
      return "half_kill";
    case Mode::kKill:
      return "kill";
  }
  return "?";
}

void FaultState::say_error(const std::string& text) noexcept {
  outcome = Outcome::kError;
  if (message[0] == '\0') strncpy(message, text.c_str(), sizeof message - 1);
}

namespace {

/// Returns true if a kernel can let the call fail in this way. For example, a full disk does not
/// prevent the removal of a file, and a signal never interrupts a rename.
bool can_befall(Mode mode, Call call) noexcept {
  switch (mode) {
    case Mode::kNone:
      return false;
    case Mode::kEio:
    case Mode::kKill:
      return true;
    case Mode::kEnospc:
    case Mode::kEdquot:
      return call != Call::kOpen && call != Call::kRead && call != Call::kLook &&
             call != Call::kUnlink;
    case Mode::kEintr:
      return call == Call::kOpen || call == Call::kCreate || call == Call::kRead ||
             call == Call::kWrite || call == Call::kTruncate || call == Call::kAllocate;
    case Mode::kShort:
      return call == Call::kRead || call == Call::kWrite;
    case Mode::kHalfKill:
      return call == Call::kWrite;
  }
  return false;
}

int error_number(Mode mode) noexcept {
  return mode == Mode::kEnospc   ? ENOSPC
         : mode == Mode::kEdquot ? EDQUOT
         : mode == Mode::kEintr  ? EINTR
                                 : EIO;
}

/// Counts the call. Returns true if it is the chosen call, or a later call of a persistent fault.
bool is_chosen() noexcept {
  const std::uint32_t number = state->seen.fetch_add(1) + 1;
  if (state->at == 0) return false;
  return number == state->at || (state->persistent && number > state->at);
}

}  // namespace

bool fails(Call call, const char* name, const char* path) noexcept {
  if (!state->armed || !is_chosen() || !can_befall(state->mode, call)) return false;
  if (state->hits.fetch_add(1) == 0) {
    snprintf(state->hit_name, sizeof state->hit_name, "%s %s", name, path);
  }
  if (state->mode == Mode::kKill) kill(getpid(), SIGKILL);
  errno = error_number(state->mode);
  return true;
}

bool allocation_fails() noexcept {
  if (state == nullptr || !state->memory || !state->armed || !is_chosen()) return false;
  ++state->hits;
  errno = ENOMEM;
  return true;
}

}  // namespace felt::faults
