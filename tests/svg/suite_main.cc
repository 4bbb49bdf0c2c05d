// svg_suite FOLDER [--list] [--pictures OUT]: compares the pictures of our scenes with those beside
// the files of a suite (NAME.svg, NAME.png), and prints a table of what agrees, by folder; --list
// prints the names of those that agree; --pictures leaves ours and theirs where they do not.
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>

#include "tests/svg/suite.h"

namespace fs = std::filesystem;

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::string root = argv[1];
  bool list = false;
  std::string out;
  for (int i = 2; i < argc; ++i) {
    if (std::strcmp(argv[i], "--list") == 0) list = true;
    if (std::strcmp(argv[i], "--pictures") == 0 && i + 1 < argc) out = argv[++i];
  }
  std::map<std::string, std::pair<int, int>> table;
  int agree = 0, all = 0;
  for (const std::string& name : felt::testing::suite_names(root)) {
    const felt::testing::SuiteResult result = felt::testing::compare_with_suite(root, name, out);
    auto& row = table[fs::path(name).parent_path().string()];
    row.second += 1;
    all += 1;
    if (result.agrees) {
      row.first += 1;
      agree += 1;
      if (list) std::printf("%s\n", name.c_str());
    } else if (!list) {
      std::printf("%s: %s\n", name.c_str(), result.why.c_str());
    }
  }
  if (list) return 0;
  std::printf("\n| folder | agree | of |\n|---|---|---|\n");
  for (const auto& [folder, counts] : table) {
    std::printf("| %s | %d | %d |\n", folder.c_str(), counts.first, counts.second);
  }
  std::printf("| all | %d | %d |\n", agree, all);
  return 0;
}
