// Runs `feltline convert` for every format with an existing output file and the interposer
// preloaded. Afterwards the output must hold either the old bytes or the new bytes, as the exit
// code reports.
#include <filesystem>

#include "felt/base/atomic_file.h"
#include "felt/base/read_file.h"
#include "tests/reliability/faults/scenario.h"

namespace felt::faults {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{64} << 20;
constexpr const char* kOld = "what was there before\n";

std::string bytes_of(const std::string& path) {
  return read_file(path, kMaxBytes).value_or(std::string());
}

Scenario convert_to(const std::string& program, const std::string& extension) {
  const std::string name = "out." + extension;
  Scenario scenario{
      "convert_" + extension,
      [=](const std::string& folder) {
        if (!write_felt(folder + "/in.felt", drawing_of(0))) std::abort();
        // The output of a run without faults, to compare with. The writers are deterministic.
        const std::string output = folder + "/wanted." + extension;
        const std::string line =
            program + " convert " + folder + "/in.felt -o " + output + " >/dev/null";
        if (std::system(line.c_str()) != 0) return;  // check() says so
        static_cast<void>(write_file(folder + "/" + name, kOld));
      },
      nullptr,
      [=](const std::string& folder, const FaultState& after) -> std::string {
        const std::string wanted = bytes_of(folder + "/wanted." + extension);
        if (wanted.empty()) return "there is nothing to compare with";
        const std::string bytes = bytes_of(folder + "/" + name);
        if (bytes != kOld && bytes != wanted) return "DAMAGED: neither old nor new";
        if (after.outcome == Outcome::kOk && bytes != wanted) return "LOST: the exit code was 0";
        if (after.outcome == Outcome::kError &&
            std::string(after.message).find(folder) == std::string::npos) {
          return std::string("an error without the file: ") + after.message;
        }
        const bool lived = after.outcome != Outcome::kRunning;
        const std::string left = others_in(folder, {"in.felt", name, "wanted." + extension});
        const bool could_remove =
            !after.persistent && std::string(after.hit_name).rfind("unlink", 0) != 0;
        // If a save fails late, the previous document remains as a hidden file.
        const bool is_kept = after.outcome == Outcome::kError && left.ends_with(".old");
        return lived && could_remove && !left.empty() && !is_kept ? "left behind: " + left : "";
      }};
  scenario.command = {program, "convert", "@/in.felt", "-o", "@/" + name};
  scenario.stride = 5;
  return scenario;
}

}  // namespace

void add_program_scenarios(std::vector<Scenario>& to, const std::string& program) {
  for (const char* extension : {"felt", "ndjson", "svg", "pdf", "png"}) {
    to.push_back(convert_to(program, extension));
  }
}

}  // namespace felt::faults
