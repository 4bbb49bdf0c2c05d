#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/peers/measure.h"
#include "tests/support/fit_files.h"

namespace felt::bench {
namespace {

using Json = nlohmann::json;

/// A node process that runs longer than this is unresponsive.
constexpr int kTimeoutSeconds = 600;

void write_inks(const std::vector<fit_check::Ink>& inks, const std::string& path) {
  std::ofstream out(path);
  for (const fit_check::Ink& ink : inks) {
    Json points = Json::array();
    for (const fit_check::Point& p : ink.samples) points.push_back({p.x, p.y});
    out << Json{{"id", ink.id}, {"points", std::move(points)}}.dump() << '\n';
  }
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// Runs fit_peers.mjs. Returns "", or the reason why it failed.
std::string run_node(const std::string& package, double tolerance, int repeats,
                     const NpmFolders& folders) {
  if (std::system("command -v node > /dev/null") != 0) return "node is not installed";
  if (!std::filesystem::exists(folders.modules + "/node_modules/" + package)) {
    return "the npm package is not installed";
  }
  const std::string log = folders.scratch + "/node.log";
  std::string command = "timeout " + std::to_string(kTimeoutSeconds) + " node";
  for (const std::string& argument :
       {FELT_BENCH_PEERS_DIR + std::string("/fit_peers.mjs"), package, std::to_string(tolerance),
        std::to_string(repeats), folders.modules, folders.scratch}) {
    command += " " + quoted(argument);
  }
  command += " 2> " + quoted(log);
  return std::system(command.c_str()) == 0 ? "" : "node failed: see " + log;
}

Cost read_cost(const std::string& path) {
  std::ifstream in(path);
  const Json stats = Json::parse(in);
  return {"cpu, process",
          "stroke",
          stats.at("ns_per_sample").get<double>(),
          stats.at("call_p999_ns").get<double>(),
          stats.at("call_max_ns").get<double>(),
          std::nullopt};
}

}  // namespace

Row measure_npm(const std::string& package, const InkData& data, double tolerance, int repeats,
                const NpmFolders& folders) {
  Row row{package + " (npm)", tolerance, "", {}, {}, {}};
  try {
    std::filesystem::create_directories(folders.scratch);
    write_inks(data.deduplicated, folders.scratch + "/inks.ndjson");
    row.skipped = run_node(package, tolerance, repeats, folders);
    if (!row.skipped.empty()) return row;
    std::ifstream curves(folders.scratch + "/curves.ndjson");
    judge(data.deduplicated, fit_check::read_curves(curves), row);
    row.cost = read_cost(folders.scratch + "/cost.json");
  } catch (const std::exception& error) {
    row.skipped = error.what();
  }
  return row;
}

}  // namespace felt::bench
