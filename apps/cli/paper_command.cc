#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands.h"
#include "felt/io/picture/png.h"
#include "felt/render/view.h"
#include "output.h"
#include "paper_equations.h"
#include "paper_figures.h"
#include "print.h"

namespace felt::cli {
namespace {

constexpr double kFigureScale = 1.5;  // of the lines and letters of the overlay
constexpr double kFigureWidthPx = 1400.0;

struct PaperArguments {
  std::string folder;
  std::string law = "felt";
};

/// A file of the folder, complete in memory.
struct PaperFile {
  std::string name;
  std::string bytes;
};

Result<void> add_figure(const PaperFigure& figure, std::size_t number,
                        std::vector<PaperFile>& files) {
  PictureOptions picture;
  picture.area = figure.area;
  picture.paper = Rgba{255, 255, 255, 255};
  picture.dpi = kFigureWidthPx / figure.area.width() * kMmPerInch;
  Result<std::string> svg = view_svg(figure.view, picture, kFigureScale);
  if (!svg) return tl::unexpected(svg.error());
  const Result<Image> image = draw_view(figure.view, picture, kFigureScale);
  if (!image) return tl::unexpected(image.error());
  Result<std::string> png = encode_png(*image, picture.dpi);
  if (!png) return tl::unexpected(png.error());
  files.push_back({fmt::format("figure-{}.svg", number), *std::move(svg)});
  files.push_back({fmt::format("figure-{}.png", number), *std::move(png)});
  return {};
}

Result<std::vector<PaperFile>> paper_files(LawForm law, Console& console) {
  console.status("playing the figures");
  const Result<PaperFigures> figures = paper_figures(law);
  if (!figures) return tl::unexpected(figures.error());
  console.status("computing the equations");
  Result<std::string> document = paper_document(law, *figures);
  if (!document) return tl::unexpected(document.error());
  std::vector<PaperFile> files{{"equations.md", *std::move(document)}};
  for (std::size_t i = 0; i < figures->figures.size(); ++i) {
    if (Result<void> added = add_figure(figures->figures[i], i + 1, files); !added)
      return tl::unexpected(added.error());
  }
  return files;
}

/// Creates the folder. Fails if it is there and not empty, because the command overwrites nothing.
Result<void> make_new_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return fail(ErrorCode::kIo, folder + ": " + error.message());
  if (!std::filesystem::is_directory(folder, error))
    return fail(ErrorCode::kIo, folder + ": not a folder");
  const bool is_empty = std::filesystem::is_empty(folder, error);
  if (error) return fail(ErrorCode::kIo, folder + ": " + error.message());
  if (is_empty) return {};
  return fail(ErrorCode::kIo, folder +
                                  ": exists and is not empty; nothing was written. Choose "
                                  "another folder");
}

/// Writes the files. If one of them cannot be written, removes those that were.
Result<void> write_files(const std::string& folder, const std::vector<PaperFile>& files) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto path_of = [&folder](const PaperFile& file) {
      return (std::filesystem::path(folder) / file.name).string();
    };
    Result<void> done = Output::create(path_of(files[i])).and_then([&](Output output) {
      return output.write_all(files[i].bytes);
    });
    if (done) continue;
    std::error_code ignored;
    for (std::size_t k = 0; k < i; ++k) std::filesystem::remove(path_of(files[k]), ignored);
    return done;
  }
  return {};
}

void run_paper(const PaperArguments& args, Console& console) {
  if (Result<void> made = make_new_folder(args.folder); !made)
    return console.error(made.error().message);
  const Result<std::vector<PaperFile>> files =
      paper_files(args.law == "paper" ? LawForm::kPaper : LawForm::kFelt, console);
  console.end_progress();
  if (!files) return console.error(files.error().message);
  if (Result<void> done = write_files(args.folder, *files); !done)
    return console.error(done.error().message);
  print("In {}:", args.folder);
  for (const PaperFile& file : *files) {
    print("{} {}", file.name == files->front().name ? "" : ",", file.name);
  }
  print("\n");
}

}  // namespace

void add_paper_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand(
      "paper", "Make the figures and a table of the equations of the paper behind Feltline");
  const auto args = std::make_shared<PaperArguments>();
  command
      ->add_option(
          "-o,--output", args->folder,
          "A new or empty folder for the figures and the table; created if it does not exist")
      ->required();
  command
      ->add_option(
          "--law", args->law,
          "Forces in the figures: as Feltline reads equations 8 to 11 (felt), or as printed "
          "(paper)")
      ->check(CLI::IsMember({"felt", "paper"}))
      ->capture_default_str();
  command->footer(
      examples("feltline paper -o paper\n"
               "feltline paper -o as-printed --law paper\n"
               "feltline replay events.ndjson --set surface.law=paper --forces forces.csv"));
  command->callback([args, &console] { run_paper(*args, console); });
}

}  // namespace felt::cli
