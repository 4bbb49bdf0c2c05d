// What a .felt file costs: bytes, opening, saving (README.md).
#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "felt/base/check.h"
#include "felt/document/visible_strokes.h"
#include "felt/io/svg_writer.h"
#include "felt/store/felt_file.h"
#include "ink.h"

namespace felt::bench {
namespace {

struct Arguments {
  std::size_t strokes = 100'000;
  int rounds = 5;
  bool json = false;
};

double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double median_ms(int rounds, const std::function<void()>& work) {
  std::vector<double> all;
  for (int i = 0; i < rounds; ++i) {
    const double start = cpu_ms();
    work();
    all.push_back(cpu_ms() - start);
  }
  std::sort(all.begin(), all.end());
  return all[all.size() / 2];
}

std::size_t gzip_bytes(const std::string& text) {
  z_stream stream{};
  constexpr int kGzip = 16 + MAX_WBITS, kMemory = 8;
  FELT_CHECK(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kGzip, kMemory,
                          Z_DEFAULT_STRATEGY) == Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  std::vector<Bytef> out(std::size_t{1} << 20);
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = out.data();
    stream.avail_out = static_cast<uInt>(out.size());
    state = deflate(&stream, Z_FINISH);
  }
  FELT_CHECK(state == Z_STREAM_END);
  const std::size_t size = stream.total_out;
  deflateEnd(&stream);
  return size;
}

void row(const Arguments& args, const char* what, double value, const char* unit) {
  std::printf(
      args.json ? "{\"what\":\"%s\",\"value\":%.1f,\"unit\":\"%s\"}\n" : "%-34s %12.1f %s\n", what,
      value, unit);
  std::fflush(stdout);
}

void run(const Arguments& args) {
  StoredDrawing drawing;
  drawing.document = Ink(args.strokes).document();
  const std::string bytes = felt_bytes(drawing).value();
  FELT_CHECK(parse_felt(bytes).value() == drawing);
  const auto strokes = static_cast<double>(args.strokes);
  row(args, "size", static_cast<double>(bytes.size()) / strokes, "bytes a stroke");
  const auto svg = svg_text(visible_strokes(drawing.document), {}).value();
  const auto packed = static_cast<double>(gzip_bytes(svg));
  row(args, "the same as SVG, gzip -9", packed / strokes, "bytes a stroke");
  row(args, "size of .felt to that", 100.0 * static_cast<double>(bytes.size()) / packed, "%");
  row(args, "open, from memory", median_ms(args.rounds, [&] { (void)parse_felt(bytes); }),
      "ms CPU");
  row(args, "save, into memory", median_ms(args.rounds, [&] { (void)felt_bytes(drawing); }),
      "ms CPU");
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const std::string path = (folder / "feltline-bench-store.felt").string();
  row(args, "save, as a file",
      median_ms(args.rounds, [&] { FELT_CHECK(write_felt(path, drawing)); }), "ms CPU");
  row(args, "open, a file", median_ms(args.rounds, [&] { FELT_CHECK(read_felt(path)); }), "ms CPU");
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  felt::bench::Arguments args;
  for (int i = 1; i < argc; ++i) {
    const std::string arg = argv[i];
    if (arg == "--json") {
      args.json = true;
    } else if (arg == "--strokes" && i + 1 < argc) {
      args.strokes = std::strtoul(argv[++i], nullptr, 10);
    } else if (arg == "--rounds" && i + 1 < argc) {
      args.rounds = std::max(1, std::atoi(argv[++i]));
    } else {
      std::fprintf(stderr, "bench_store [--strokes N] [--rounds N] [--json]\n");
      return 2;
    }
  }
  felt::bench::run(args);
  return 0;
}
