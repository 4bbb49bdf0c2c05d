#include "tests/reliability/faults/driver.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>

namespace felt::faults {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kHangSeconds = 60;
constexpr std::size_t kAnswerBytes = 2048;

[[noreturn]] void die(const std::string& what) {
  std::fprintf(stderr, "faults: %s: %s\n", what.c_str(), std::strerror(errno));
  std::_Exit(2);
}

void* map_shared(const std::string& path, std::size_t size) {
  const int fd = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (fd < 0 || ::ftruncate(fd, static_cast<off_t>(size)) != 0) die(path);
  void* memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
  ::close(fd);
  if (memory == MAP_FAILED) die(path);
  return memory;
}

/// Runs `work` in a child process, waits until it ends and returns its waitpid() status.
template <class Work>
int in_child(Work work) {
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child < 0) die("fork");
  if (child == 0) {
    ::alarm(kHangSeconds);
    work();
    std::_Exit(0);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) die("waitpid");
  }
  return status;
}

/// Terminate handler: records that an exception left a noexcept function (usually std::bad_alloc),
/// and ends the process.
[[noreturn]] void on_terminate() {
  state->armed = false;
  state->outcome = Outcome::kTerminated;
  std::_Exit(0);
}

}  // namespace

void Tally::add(const RunResult& run) {
  ++runs;
  hits += run.hits > 0;
  killed += run.killed;
  errors += run.outcome == Outcome::kError;
  completed += run.outcome == Outcome::kOk;
  out_of_memory += run.outcome == Outcome::kOutOfMemory;
  terminated += run.outcome == Outcome::kTerminated;
  problems += !run.problem.empty();
  damaged += run.problem.rfind("DAMAGED", 0) == 0 || run.problem.rfind("LOST", 0) == 0;
}

Driver::Driver(std::string base, std::string preload)
    : base_(std::move(base)),
      template_(base_ + "/before"),
      folder_(base_ + "/run"),
      preload_(std::move(preload)),
      shared_path_(base_ + "/state") {
  fs::create_directories(base_);
  state_ = static_cast<FaultState*>(map_shared(shared_path_, sizeof(FaultState)));
  answer_ = static_cast<char*>(map_shared(base_ + "/answer", kAnswerBytes));
}

Driver::~Driver() {
  state = nullptr;
  ::munmap(state_, sizeof(FaultState));
  ::munmap(answer_, kAnswerBytes);
  fs::remove_all(base_);
}

void Driver::prepare(const Scenario& scenario) {
  for (std::uint32_t generation = 0; generation < 10; ++generation) drawing_of(generation);
  reset_state(scenario, {});
  fs::remove_all(template_);
  fs::remove_all(folder_);
  // Prepared in the folder of the runs, because autosaves contain absolute paths.
  fs::create_directory(folder_);
  const int status = in_child([&] { scenario.prepare(folder_); });
  if (status != 0) die(scenario.name + " cannot be prepared");
  fs::rename(folder_, template_);
}

void Driver::reset_state(const Scenario& scenario, const Fault& fault) {
  state = new (state_) FaultState;
  std::snprintf(state->folder, sizeof state->folder, "%s", folder_.c_str());
  state->mode = fault.mode;
  state->at = fault.at;
  state->persistent = fault.persistent;
  state->memory = fault.memory;
  state->no_unnamed = scenario.no_unnamed;
  state->read_only = scenario.read_only;
}

void Driver::play(const Scenario& scenario) {
  std::set_terminate(on_terminate);
  state->armed = true;
  try {
    scenario.act(folder_);
  } catch (const std::bad_alloc&) {
    state->armed = false;
    state->outcome = Outcome::kOutOfMemory;
    return;
  }
  state->armed = false;
  if (state->outcome == Outcome::kRunning) state->outcome = Outcome::kOk;
}

/// Runs the command. Its exit code becomes the outcome and its stderr the message.
void Driver::exec(const Scenario& scenario) {
  const std::string log = base_ + "/stderr";
  const int status = in_child([&] {
    std::vector<std::string> words = scenario.command;
    std::vector<char*> arguments;
    for (std::string& word : words) {
      if (word.rfind('@', 0) == 0) word = folder_ + word.substr(1);
      arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    ::setenv("LD_PRELOAD", preload_.c_str(), 1);
    ::setenv("FELT_FAULTS", shared_path_.c_str(), 1);
    const int fd = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(fd, STDERR_FILENO);
    ::dup2(fd, STDOUT_FILENO);
    ::execv(arguments[0], arguments.data());
    std::_Exit(127);
  });
  state->armed = false;
  if (WIFSIGNALED(status)) ::raise(WTERMSIG(status));  // end this process by the same signal
  if (WEXITSTATUS(status) == 0) {
    state->outcome = Outcome::kOk;
    return;
  }
  std::FILE* file = std::fopen(log.c_str(), "r");
  char text[1000] = {};
  if (file != nullptr) {
    static_cast<void>(std::fread(text, 1, sizeof text - 1, file));
    std::fclose(file);
  }
  state->say_error(text);
}

RunResult Driver::run(const Scenario& scenario, const Fault& fault) {
  reset_state(scenario, fault);
  fs::remove_all(folder_);
  fs::copy(template_, folder_, fs::copy_options::recursive | fs::copy_options::copy_symlinks);
  const int status = in_child([&] {
    if (scenario.command.empty()) {
      play(scenario);
    } else {
      exec(scenario);
    }
  });
  state->armed = false;
  state->read_only = false;
  RunResult result;
  result.seen = state->seen;
  result.hits = state->hits;
  result.outcome = state->outcome;
  result.hit_name = state->hit_name;
  result.message = state->message;
  const bool may_die = fault.mode == Mode::kKill || fault.mode == Mode::kHalfKill;
  result.killed = WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL && may_die;
  if (WIFSIGNALED(status) && !result.killed) {
    result.problem = "CRASH: signal " + std::to_string(WTERMSIG(status));
    return result;
  }
  std::memset(answer_, 0, kAnswerBytes);
  const int checked = in_child([&] {
    const std::string problem = scenario.check(folder_, *state);
    std::snprintf(answer_, kAnswerBytes, "%s", problem.c_str());
  });
  result.problem = checked == 0 ? answer_ : "CRASH: of the checking process";
  return result;
}

}  // namespace felt::faults
