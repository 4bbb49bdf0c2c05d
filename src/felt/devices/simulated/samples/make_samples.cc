// Writes the project's sample strokes: make_samples FOLDER (share/samples).

#include <cstdio>
#include <fstream>

#include "felt/devices/simulated/samples/sample_sets.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 2;
  }
  for (const felt::SampleSet& set : felt::make_sample_sets()) {
    const std::string path = std::string(argv[1]) + "/" + set.file_name;
    std::ofstream out(path, std::ios::binary);
    out << felt::to_ndjson(set);
    if (!out.flush()) {
      std::fprintf(stderr, "%s: cannot write\n", path.c_str());
      return 1;
    }
  }
  return 0;
}
