#include "driver_processes.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <exception>
#include <thread>

#include "packed.h"

namespace felt::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kGlance{2};
constexpr std::size_t kMaxWords = 600;  // length of the text that is kept from a library's stderr

void put(Packer& packer, const DeviceDescriptor& device) {
  for (const std::string* text : {&device.id, &device.driver, &device.label, &device.model,
                                  &device.serial, &device.version}) {
    packer.put(*text);
  }
  packer.put(device.kind);
  packer.put(device.is_connected);
  packer.put(device.has_own_frame);
  packer.put(device.capabilities);
}

DeviceDescriptor take_device(Unpacker& bytes) {
  DeviceDescriptor device;
  for (std::string* text : {&device.id, &device.driver, &device.label, &device.model,
                            &device.serial, &device.version}) {
    *text = bytes.take<std::string>();
  }
  device.kind = bytes.take<DeviceKind>();
  device.is_connected = bytes.take<bool>();
  device.has_own_frame = bytes.take<bool>();
  device.capabilities = bytes.take<Capabilities>();
  return device;
}

void put(Packer& packer, const Finding& finding) {
  packer.put(finding.level);
  packer.put(finding.what);
  packer.put(finding.details);
  packer.put(static_cast<std::uint64_t>(finding.steps.size()));
  for (const std::string& step : finding.steps) packer.put(step);
  packer.put(finding.fix.has_value());
  const SystemFix fix = finding.fix.value_or(SystemFix{});
  for (const std::string* text : {&fix.path, &fix.content, &fix.activate}) packer.put(*text);
}

Finding take_finding(Unpacker& bytes) {
  Finding finding;
  finding.level = bytes.take<FindingLevel>();
  finding.what = bytes.take<std::string>();
  finding.details = bytes.take<std::string>();
  const std::size_t steps = bytes.take_count();
  for (std::size_t i = 0; i < steps; ++i) finding.steps.push_back(bytes.take<std::string>());
  const bool has_fix = bytes.take<bool>();
  SystemFix fix;
  for (std::string* text : {&fix.path, &fix.content, &fix.activate}) {
    *text = bytes.take<std::string>();
  }
  if (has_fix) finding.fix = std::move(fix);
  return finding;
}

std::string look(Driver& driver, const SystemView& system, DriverQuery what) {
  Packer packer;
  const std::vector<DeviceDescriptor> devices = driver.find();
  packer.put(static_cast<std::uint64_t>(devices.size()));
  for (const DeviceDescriptor& device : devices) put(packer, device);
  const std::vector<Finding> findings =
      what == DriverQuery::kFindings ? driver.diagnose(system) : std::vector<Finding>();
  packer.put(static_cast<std::uint64_t>(findings.size()));
  for (const Finding& finding : findings) put(packer, finding);
  return packer.bytes();
}

/// A file in memory that is deleted when all processes have closed it.
class Scratch {
 public:
  explicit Scratch(const char* name) : fd_(memfd_create(name, MFD_CLOEXEC)) {}
  Scratch(Scratch&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    if (fd_ >= 0) close(fd_);
  }
  [[nodiscard]] int fd() const noexcept { return fd_; }
  [[nodiscard]] bool write(std::string_view bytes) const noexcept {
    while (!bytes.empty()) {
      const ssize_t done = ::write(fd_, bytes.data(), bytes.size());
      if (done <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(done));
    }
    return true;
  }
  [[nodiscard]] std::string read() const {
    const off_t size = lseek(fd_, 0, SEEK_END);
    std::string bytes(static_cast<std::size_t>(std::max<off_t>(0, size)), '\0');
    const ssize_t got = pread(fd_, bytes.data(), bytes.size(), 0);
    bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(0, got)));
    return bytes;
  }

 private:
  int fd_;
};

/// A driver that looks for devices in a process of its own.
struct Looker {
  Scratch answer{"feltline-answer"};
  Scratch words{"feltline-words"};
  pid_t pid = -1;
  int status = 0;
  bool has_ended = false;
};

[[noreturn]] void be_child(Driver& driver, const SystemView& system, DriverQuery what,
                           const Looker& looker) {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  dup2(nothing, STDIN_FILENO);
  dup2(nothing, STDOUT_FILENO);
  dup2(looker.words.fd(), STDERR_FILENO);
  int code = 1;
  try {
    if (looker.answer.write(look(driver, system, what))) code = 0;
  } catch (const std::exception& error) {  // from a C++ library, or out of memory
    static_cast<void>(looker.words.write(error.what()));
  }
  _exit(code);
}

Finding trouble(const std::string& what, const Looker& looker) {
  std::string words = looker.words.read();
  if (words.size() > kMaxWords) words.erase(0, words.size() - kMaxWords);
  while (!words.empty() && words.back() == '\n') words.pop_back();
  for (char& c : words) {
    if (static_cast<unsigned char>(c) < ' ' && c != '\n') c = ' ';
  }
  return {.level = FindingLevel::kProblem,
          .what = what,
          .details = words,
          .steps = {"The maker's software on this computer is broken, or Feltline does not support "
                    "its version. Install it again, or report this message to us."}};
}

DriverReport result_of(const Driver& driver, const Looker& looker,
                       std::chrono::milliseconds time_limit) {
  DriverReport look{std::string(driver.name()), std::string(driver.label()), {}, {}};
  if (!looker.has_ended) {
    look.findings = {trouble("The software for these devices does not answer (for " +
                                 std::to_string(time_limit.count() / 1000) + " s).",
                             looker)};
    return look;
  }
  const std::string bytes = looker.answer.read();
  Unpacker answer(bytes);
  const std::size_t devices = answer.take_count();
  for (std::size_t i = 0; i < devices; ++i) look.devices.push_back(take_device(answer));
  const std::size_t findings = answer.take_count();
  for (std::size_t i = 0; i < findings; ++i) look.findings.push_back(take_finding(answer));
  if (WIFEXITED(looker.status) && WEXITSTATUS(looker.status) == 0 && answer.is_good()) return look;
  const std::string how = WIFSIGNALED(looker.status)
                              ? std::string("crashed (") + strsignal(WTERMSIG(looker.status)) + ")"
                              : std::string("ended the program that asked it");
  look.devices.clear();
  look.findings = {trouble("The software for these devices " + how + ".", looker)};
  return look;
}

/// Waits until all processes have ended, at most until `until`, and then kills the others.
void wait_for(std::vector<Looker>& lookers, Clock::time_point until) {
  for (Looker& looker : lookers) {
    if (looker.pid < 0) continue;
    while (waitpid(looker.pid, &looker.status, WNOHANG) == 0) {
      if (Clock::now() < until) {
        std::this_thread::sleep_for(kGlance);
        continue;
      }
      kill(looker.pid, SIGKILL);
      waitpid(looker.pid, &looker.status, 0);
      looker.pid = -1;
      break;
    }
    looker.has_ended = looker.pid >= 0;
  }
}

}  // namespace

std::vector<DriverReport> query_drivers(const std::vector<std::unique_ptr<Driver>>& drivers,
                                        const SystemView& system, DriverQuery what,
                                        std::chrono::milliseconds time_limit) {
  std::vector<Looker> lookers(drivers.size());
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    lookers[i].pid = fork();
    if (lookers[i].pid == 0) be_child(*drivers[i], system, what, lookers[i]);
  }
  wait_for(lookers, Clock::now() + time_limit);
  std::vector<DriverReport> looks;
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    looks.push_back(result_of(*drivers[i], lookers[i], time_limit));
  }
  return looks;
}

}  // namespace felt::cli
