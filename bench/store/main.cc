// Measures a .felt file: its size, and the time to open and save it. Also times a commit to the
// autosave (README.md).
#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "felt/autosave/autosave_database.h"
#include "felt/base/check.h"
#include "felt/document/visible_strokes.h"
#include "felt/io/svg/svg_writer.h"
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

double wall_ms() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double at_share(std::vector<double> all, double share) {
  std::sort(all.begin(), all.end());
  return all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
}

/// Times commits of one stroke each to the autosave of a large drawing.
void run_commits(const Arguments& args, const Drawing& drawing) {
  constexpr int kCommits = 500;
  const std::filesystem::path root =
      std::filesystem::temp_directory_path() / "feltline-bench-working";
  std::filesystem::create_directories(root);
  Result<AutosaveDatabase> store = AutosaveDatabase::create(root.string(), "bench");
  FELT_CHECK(store);
  const double start = wall_ms();
  FELT_CHECK(store->write_base(drawing) && store->commit());
  row(args, "autosave, first base", wall_ms() - start, "ms wall");
  Document document = drawing.document;
  const Layer& layer = document.layers().back();
  const Stroke ink = *document.find(layer.strokes.front());
  std::vector<double> wall, cpu;
  for (int i = 0; i < kCommits; ++i) {
    Edit edit{"Draw",
              {{document.new_id(),
                nullptr,
                std::make_shared<const Stroke>(ink),
                {},
                {layer.id, layer.strokes.size()}}}};
    FELT_CHECK(document.apply(edit));
    const double wall_start = wall_ms(), cpu_start = cpu_ms();
    FELT_CHECK(store->add_edit(edit) && store->commit());
    wall.push_back(wall_ms() - wall_start);
    cpu.push_back(cpu_ms() - cpu_start);
  }
  row(args, "commit one more stroke, p50", at_share(wall, 0.5), "ms wall");
  row(args, "commit one more stroke, p99", at_share(wall, 0.99), "ms wall");
  row(args, "commit one more stroke, CPU p50", 1e3 * at_share(cpu, 0.5), "us CPU");
  FELT_CHECK(std::move(*store).remove());
  std::filesystem::remove_all(root);
}

void run(const Arguments& args) {
  Drawing drawing;
  drawing.document = Ink(args.strokes).document();
  const std::string bytes = felt_bytes(drawing).value();
  FELT_CHECK(parse_felt(bytes).value() == drawing);
  const auto strokes = static_cast<double>(args.strokes);
  row(args, "size", static_cast<double>(bytes.size()) / strokes, "bytes a stroke");
  const auto svg = svg_ink_text(drawing, {}).value();
  const auto packed = static_cast<double>(gzip_bytes(svg));
  row(args, "the same as SVG, gzip -9", packed / strokes, "bytes a stroke");
  row(args, "size of .felt relative to that", 100.0 * static_cast<double>(bytes.size()) / packed,
      "%");
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
  run_commits(args, drawing);
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
