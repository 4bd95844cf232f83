// SPDX-License-Identifier: Apache-2.0
// Cursor over the words and numbers of a text file, with line numbers for messages.
#pragma once
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/meshes/read_mesh.hpp"

namespace thaw {

/// Iterates over the words of a text, independently of the locale.
class TextCursor {
 public:
  TextCursor(std::string_view text, std::string file, std::int64_t firstLine = 1)
      : text_(text), file_(std::move(file)), line_(firstLine) {}

  /// Returns the next word on any line; empty at the end of the text.
  std::string_view word() {
    while (at_ < text_.size() && isSpace(text_[at_])) step();
    return wordHere();
  }
  /// Returns the next word of this line; empty at its end.
  std::string_view wordOnLine() {
    while (at_ < text_.size() && isSpace(text_[at_]) && text_[at_] != '\n') step();
    return wordHere();
  }
  /// Returns the rest of this line without its end, and moves to the next line.
  std::string_view restOfLine() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != '\n') at_++;
    std::string_view rest = text_.substr(begin, at_ - begin);
    if (at_ < text_.size()) step();
    while (!rest.empty() && isSpace(rest.back())) rest.remove_suffix(1);
    return rest;
  }
  bool atEnd() const { return at_ >= text_.size(); }
  std::size_t offset() const { return at_; }
  std::int64_t line() const { return line_; }

  /// Converts a word to a finite number; what: "a coordinate", for the message.
  double number(std::string_view word, const char* what) const {
    double x = 0;
    std::string_view digits = word;
    if (digits.size() > 1 && digits[0] == '+') digits.remove_prefix(1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), x);
    if (error == std::errc::result_out_of_range && end == digits.data() + digits.size())
      return outOfRange(digits, what);
    if (error != std::errc() || end != digits.data() + digits.size())
      fail("expected " + std::string(what) + ", got " + shown(word));
    if (!std::isfinite(x))
      fail("expected " + std::string(what) + ", got " + shown(word) + ", which is not a finite number");
    return x;
  }
  std::int64_t integer(std::string_view word, const char* what) const {
    std::int64_t n = 0;
    if (word.size() > 1 && word[0] == '+') word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), n);
    if (error != std::errc() || end != word.data() + word.size())
      fail("expected " + std::string(what) + ", got " + shown(word));
    return n;
  }
  [[noreturn]] void fail(const std::string& message) const { failAt(line_, message); }
  [[noreturn]] void failAt(std::int64_t line, const std::string& message) const {
    throw MeshError(file_ + ":" + std::to_string(line) + ": " + message);
  }

  /// Formats a word for a message: quoted, shortened, with unprintable bytes replaced.
  static std::string shown(std::string_view word) {
    if (word.empty()) return "the end";
    std::string s = "'";
    for (const char c : word.substr(0, 40)) s += c >= 32 && c < 127 ? c : '?';
    return s + (word.size() > 40 ? "...'" : "'");
  }

 private:
  static bool isSpace(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
  }
  void step() { line_ += text_[at_++] == '\n'; }
  std::string_view wordHere() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && !isSpace(text_[at_])) at_++;
    return text_.substr(begin, at_ - begin);
  }
  /// Underflow such as 1e-400 is 0; overflow such as 1e400 is an error.
  double outOfRange(std::string_view digits, const char* what) const {
    const std::size_t e = digits.find_first_of("eE");
    if (e != std::string_view::npos && e + 1 < digits.size() && digits[e + 1] == '-') return 0;
    fail("expected " + std::string(what) + ", got " + shown(digits) + ", which is too large");
  }

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  std::int64_t line_;
};

}  // namespace thaw
