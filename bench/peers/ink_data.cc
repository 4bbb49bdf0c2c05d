#include "bench/peers/ink_data.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "tests/support/fit_files.h"

namespace felt::bench {
namespace {

constexpr std::size_t kMinPoints = 4;

std::vector<fit_check::Ink> deduplicated(const std::vector<fit_check::Ink>& raw) {
  std::vector<fit_check::Ink> result;
  for (const fit_check::Ink& ink : raw) {
    fit_check::Ink kept{ink.id, ink.source, ink.samples};
    kept.samples.erase(std::unique(kept.samples.begin(), kept.samples.end()), kept.samples.end());
    if (kept.samples.size() >= kMinPoints) result.push_back(std::move(kept));
  }
  return result;
}

/// Reads a file of raw strokes. The source of a stroke that does not name one is `file`.
std::vector<fit_check::Ink> read_file(const std::string& path, const std::string& file,
                                      double mm_per_unit) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path + ": cannot open");
  try {
    std::vector<fit_check::Ink> inks = fit_check::read_inks(in, mm_per_unit);
    for (fit_check::Ink& ink : inks) {
      if (ink.source.empty()) ink.source = file;
    }
    return inks;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace

std::int64_t sample_count(const std::vector<fit_check::Ink>& inks) {
  std::size_t count = 0;
  for (const fit_check::Ink& ink : inks) count += ink.samples.size();
  return static_cast<std::int64_t>(count);
}

InkData read_ink_data(const std::vector<std::string>& paths, double mm_per_unit) {
  InkData data;
  for (const std::string& path : paths) {
    const std::string file = std::filesystem::path(path).filename();
    std::vector<fit_check::Ink> inks = read_file(path, file, mm_per_unit);
    std::move(inks.begin(), inks.end(), std::back_inserter(data.raw));
    data.name += (data.name.empty() ? "" : ", ") + file;
  }
  data.deduplicated = deduplicated(data.raw);
  return data;
}

}  // namespace felt::bench
