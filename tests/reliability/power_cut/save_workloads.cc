// Workloads that save a .felt file over itself, correctly and with deliberately bad savers.
#include <fcntl.h>
#include <unistd.h>

#include <filesystem>

#include "felt/store/felt_file.h"
#include "tests/reliability/faults/drawings.h"
#include "tests/reliability/power_cut/workload.h"

namespace felt::power_cut {
namespace {

namespace fs = std::filesystem;

// The drawings of the fault tests: each generation differs, and every process computes the same.
using faults::drawing_of;

constexpr std::uint32_t kSaves = 30;
constexpr unsigned kSavePauseUs = 20'000;

std::string saved_document_in(const std::string& folder) {
  return folder + "/drawing.felt";
}

int find_document(const std::string& folder, std::uint32_t largest, std::string& why) {
  const std::string path = saved_document_in(folder);
  if (!fs::exists(path)) return 0;
  const int found = faults::generation_at(path, largest, why);
  return found < 0 ? -1 : found;
}

using Saver = std::function<std::string(const std::string& path, const Drawing& drawing)>;

Workload save_loop(std::string name, Saver saver) {
  return {std::move(name),
          [saver](const std::string& folder, std::uint32_t from, Diary& diary) {
            for (std::uint32_t i = from + 1; i <= from + kSaves; ++i) {
              diary.start(i);
              const std::string problem = saver(saved_document_in(folder), drawing_of(i));
              if (!problem.empty()) return diary.fail(problem);
              diary.acknowledge(i);
              ::usleep(kSavePauseUs);
            }
          },
          find_document};
}

std::string save_well(const std::string& path, const Drawing& drawing) {
  const auto saved = write_felt(path, drawing);
  return saved ? "" : saved.error().message;
}

std::string put(const std::string& path, const std::string& bytes, int more) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | more, 0644);
  const bool ok =
      fd >= 0 && ::write(fd, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  if (fd >= 0) ::close(fd);
  return ok ? "" : "cannot write " + path;
}

std::string truncate_and_write(const std::string& path, const Drawing& drawing) {
  return put(path, felt_bytes(drawing).value(), 0);
}

std::string rename_without_sync(const std::string& path, const Drawing& drawing) {
  const std::string problem = put(path + ".new", felt_bytes(drawing).value(), 0);
  if (!problem.empty()) return problem;
  return ::rename((path + ".new").c_str(), path.c_str()) == 0 ? "" : "cannot rename";
}

}  // namespace

void add_save_workloads(std::vector<Workload>& to) {
  to.push_back(save_loop("save", save_well));
  for (auto&& [name, saver] : {std::pair<const char*, Saver>{"plant_truncate", truncate_and_write},
                               {"plant_rename", rename_without_sync}}) {
    to.push_back(save_loop(name, saver));
    to.back().is_plant = true;
  }
}

}  // namespace felt::power_cut
