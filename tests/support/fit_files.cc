#include "tests/support/fit_files.h"

#include <istream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace fit_check {
namespace {

using Json = nlohmann::json;

std::string text_of(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) return {};
  return found->is_string() ? found->get<std::string>() : found->dump();
}

/// Parses each line that is not blank and calls take() with the object.
template <class Take>
void for_each_line(std::istream& in, Take&& take) {
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      take(Json::parse(line));
    } catch (const Json::exception& error) {
      throw std::runtime_error("line " + std::to_string(number) + ": " + error.what());
    }
  }
}

Segment segment_of(const Json& numbers) {
  Segment segment;
  for (std::size_t i = 0; i < 4; ++i) {
    segment[i] = {numbers.at(2 * i).get<double>(), numbers.at(2 * i + 1).get<double>()};
  }
  return segment;
}

}  // namespace

std::vector<Ink> read_inks(std::istream& in, double mm_per_unit) {
  std::vector<Ink> inks;
  for_each_line(in, [&](const Json& object) {
    Ink ink{text_of(object, "id"), text_of(object, "source"), {}};
    for (const Json& point : object.at("points")) {
      ink.samples.push_back(
          {point.at(0).get<double>() * mm_per_unit, point.at(1).get<double>() * mm_per_unit});
    }
    inks.push_back(std::move(ink));
  });
  return inks;
}

std::vector<FitCurve> read_curves(std::istream& in) {
  std::vector<FitCurve> curves;
  for_each_line(in, [&](const Json& object) {
    if (!object.is_object() || !object.contains("segments")) return;
    FitCurve curve{text_of(object, "id"), object.value("closed", false), {}, {}};
    for (const Json& numbers : object.at("segments")) {
      curve.segments.push_back(segment_of(numbers));
    }
    for (const Json& kind : object.value("joints", Json::array())) {
      curve.corners.push_back(kind == "corner");
    }
    curves.push_back(std::move(curve));
  });
  return curves;
}

}  // namespace fit_check
