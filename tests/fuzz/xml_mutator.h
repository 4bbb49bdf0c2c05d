#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace felt::fuzz {

/// Makes random changes to XML after which most texts are still well-formed: changes numbers and
/// values, replaces names by others of a list, and copies, moves, nests and removes elements. The
/// same seed gives the same changes.
class XmlMutator {
 public:
  XmlMutator(unsigned seed, std::span<const std::string_view> words)
      : random_(seed), words_(words) {}

  std::string mutated(std::string text) {
    for (int n = pick(1, 4); n > 0; --n) change(text);
    return text;
  }

 private:
  struct Piece {
    std::size_t begin = 0, size = 0;
  };

  int pick(int smallest, int largest) {
    return std::uniform_int_distribution<int>(smallest, largest)(random_);
  }

  void change(std::string& text) {
    switch (pick(0, 7)) {
      case 0:
      case 1:
        return replace(text, numbers(text), number());
      case 2:
        return replace(text, values(text), word());
      case 3:
        return duplicate(text);
      case 4:
        return replace(text, lines(text), "");
      case 5:
        return wrap(text);
      case 6:
        return move(text);
      default:
        return insert(text, word());
    }
  }

  std::string number() {
    static constexpr std::array<std::string_view, 22> kNumbers = {"0",
                                                                  "-0",
                                                                  "1",
                                                                  "-1",
                                                                  "0.05",
                                                                  "1e-9",
                                                                  "1e9",
                                                                  "1000000001",
                                                                  "-1e9",
                                                                  "1e308",
                                                                  "1e-308",
                                                                  "9e12",
                                                                  "2147483648",
                                                                  "nan",
                                                                  "inf",
                                                                  "#ff",
                                                                  "*",
                                                                  "?",
                                                                  "T",
                                                                  "F",
                                                                  "100.5.5-3'2\"1",
                                                                  "0.0000000000000000000001"};
    if (pick(0, 2) == 0) return std::to_string(pick(-1000, 1000));
    return std::string(kNumbers[static_cast<std::size_t>(pick(0, kNumbers.size() - 1))]);
  }
  std::string word() {
    if (pick(0, 3) == 0) return number();
    return std::string(
        words_[static_cast<std::size_t>(pick(0, static_cast<int>(words_.size()) - 1))]);
  }

  static std::vector<Piece> numbers(const std::string& text) {
    std::vector<Piece> found;
    constexpr std::string_view kDigits = "0123456789.-+e";
    for (std::size_t at = text.find_first_of("0123456789"); at != std::string::npos;
         at = text.find_first_of("0123456789", at)) {
      const std::size_t end = std::min(text.find_first_not_of(kDigits, at), text.size());
      found.push_back({at, end - at});
      at = end;
    }
    return found;
  }
  // Returns the texts between quotes.
  static std::vector<Piece> values(const std::string& text) {
    std::vector<Piece> found;
    for (std::size_t at = text.find("=\""); at != std::string::npos; at = text.find("=\"", at)) {
      const std::size_t end = text.find('"', at + 2);
      if (end == std::string::npos) break;
      found.push_back({at + 2, end - at - 2});
      at = end;
    }
    return found;
  }
  static std::vector<Piece> lines(const std::string& text) {
    std::vector<Piece> found;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
      found.push_back({at, end - at});
      at = end;
    }
    return found;
  }

  Piece any(const std::vector<Piece>& pieces) {
    return pieces[static_cast<std::size_t>(pick(0, static_cast<int>(pieces.size()) - 1))];
  }
  void replace(std::string& text, const std::vector<Piece>& pieces, const std::string& with) {
    if (pieces.empty()) return;
    const Piece piece = any(pieces);
    text.replace(piece.begin, piece.size, with);
  }
  void insert(std::string& text, const std::string& what) {
    text.insert(static_cast<std::size_t>(pick(0, static_cast<int>(text.size()))), what);
  }
  void duplicate(std::string& text) {
    const std::vector<Piece> all = lines(text);
    if (all.empty()) return;
    const Piece piece = any(all);
    std::string copies;
    for (int n = pick(1, 5); n > 0; --n) copies += text.substr(piece.begin, piece.size);
    text.insert(any(all).begin, copies);
  }
  void wrap(std::string& text) {
    const std::vector<Piece> all = lines(text);
    if (all.empty()) return;
    const Piece piece = any(all);
    const std::string name = word();
    text.insert(piece.begin + piece.size, "</" + name + ">\n");
    text.insert(piece.begin, "<" + name + ">\n");
  }
  void move(std::string& text) {
    const std::vector<Piece> all = lines(text);
    if (all.size() < 2) return;
    const Piece piece = any(all);
    const std::string line = text.substr(piece.begin, piece.size);
    text.erase(piece.begin, piece.size);
    text.insert(any(lines(text)).begin, line);
  }

  std::minstd_rand random_;
  std::span<const std::string_view> words_;
};

}  // namespace felt::fuzz
