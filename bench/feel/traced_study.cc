#include "traced_study.h"

#include <cstddef>
#include <utility>

namespace felt::bench {

Result<StudyFiles> read_traced_study(const std::string& path) {
  Result<StudyFiles> files = read_study_files(path);
  if (!files) return files;
  std::vector<StudyShape> shapes;
  std::vector<StudyPath> paths;
  for (std::size_t i = 0; i < files->paths.size(); ++i) {
    if (files->study.shapes[i].task != StudyTask::kTrace) continue;
    shapes.push_back(std::move(files->study.shapes[i]));
    paths.push_back(std::move(files->paths[i]));
  }
  files->study.shapes = std::move(shapes);
  files->paths = std::move(paths);
  return files;
}

}  // namespace felt::bench
