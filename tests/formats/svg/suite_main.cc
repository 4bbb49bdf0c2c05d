// svg_suite FOLDER [--list] [--drawings] [--all] [--pictures OUT]: compares our pictures of the
// files of a suite (NAME.svg) with those of the suite (NAME.png), and prints for each folder how
// many agree.
// --list prints the names of the files that agree. --drawings compares the imported drawings
// instead of the shapes that the reader finds. --all fails (exit code 1) unless all agree.
// --pictures writes both pictures of the others to OUT.
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>

#include "tests/formats/svg/suite.h"

namespace fs = std::filesystem;

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::string root = argv[1];
  bool list = false, must_agree = false;
  std::string out;
  auto what = felt::testing::SuitePicture::kShapes;
  for (int i = 2; i < argc; ++i) {
    if (std::strcmp(argv[i], "--list") == 0) list = true;
    if (std::strcmp(argv[i], "--all") == 0) must_agree = true;
    if (std::strcmp(argv[i], "--drawings") == 0) what = felt::testing::SuitePicture::kDrawing;
    if (std::strcmp(argv[i], "--pictures") == 0 && i + 1 < argc) out = argv[++i];
  }
  struct Row {
    int agree = 0, all = 0, agree_plain = 0, plain = 0;
  };
  std::map<std::string, Row> table;
  Row sum;
  for (const std::string& name : felt::testing::suite_names(root)) {
    const felt::testing::SuiteResult result =
        felt::testing::compare_with_suite(root, name, out, what);
    for (Row* row : {&table[fs::path(name).parent_path().string()], &sum}) {
      row->all += 1;
      row->agree += result.agrees ? 1 : 0;
      row->plain += result.needs_more ? 0 : 1;
      row->agree_plain += result.agrees && !result.needs_more ? 1 : 0;
    }
    if (list && result.agrees) std::printf("%s\n", name.c_str());
    if (!list && !result.agrees) std::printf("%s: %s\n", name.c_str(), result.why.c_str());
  }
  if (list) return 0;
  std::printf(
      "\n| folder | agree | of | agree, of those that need only lines and fillings | of |\n");
  std::printf("|---|---|---|---|---|\n");
  const auto print = [](const std::string& name, const Row& row) {
    std::printf("| %s | %d | %d | %d | %d |\n", name.c_str(), row.agree, row.all, row.agree_plain,
                row.plain);
  };
  for (const auto& [folder, row] : table) print(folder, row);
  print("all", sum);
  return must_agree && (sum.all == 0 || sum.agree < sum.all) ? 1 : 0;
}
