// SPDX-License-Identifier: Apache-2.0
#include "io/scene/text/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <cctype>
#include <memory>
#include <numbers>

#include "io/scene/text/units.hpp"
#include "io/scene/text/value_text.hpp"

namespace thaw {
namespace {

constexpr std::size_t longest = 1000;  // characters

/// muParser reads variables through their addresses.
struct Formula {
  mu::Parser parser;
  Vec3d at{};
};

/// Returns the position of the first '=' that is not part of a comparison, or npos.
std::size_t assignmentIn(const std::string& text) {
  for (std::size_t k = 0; k < text.size(); k++) {
    if (text[k] != '=') continue;
    const bool behind = k > 0 && (text[k - 1] == '<' || text[k - 1] == '>' || text[k - 1] == '!' ||
                                  text[k - 1] == '=');
    const bool before = k + 1 < text.size() && text[k + 1] == '=';
    if (!behind && !before) return k;
  }
  return std::string::npos;
}

bool isWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Returns whether a text contains x, y or z as a word.
bool namesPlace(const std::string& text) {
  for (std::size_t k = 0; k < text.size(); k++)
    if (text[k] >= 'x' && text[k] <= 'z' && (k == 0 || !isWordCharacter(text[k - 1])) &&
        (k + 1 == text.size() || !isWordCharacter(text[k + 1])))
      return true;
  return false;
}

/// Returns whether a text is an expression of numbers alone, as "1/3".
bool isArithmetic(const std::string& text) {
  return text.find_first_of("0123456789") != std::string::npos &&
         text.find_first_of("+-*/") != std::string::npos &&
         text.find_first_not_of("0123456789.eE+-*/() \t") == std::string::npos;
}

std::string messageOf(const mu::ParserError& e) {
  const int code = e.GetCode();
  const std::string where = fmt::format(" at character {}", e.GetPos() + 1);
  if (code == mu::ecUNASSIGNABLE_TOKEN) {
    std::string name = e.GetToken();  // with a blank that muParser appends
    name.erase(name.find_last_not_of(' ') + 1);
    return "unknown name " + thaw::quoted(name) + where;
  }
  if (code == mu::ecUNEXPECTED_EOF) return "it ends too early";
  std::string text = e.GetMsg();
  if (const std::size_t at = text.find(" found at position"); at != std::string::npos)
    text.erase(at);  // the position there counts from 0
  while (!text.empty() && (text.back() == '.' || text.back() == '!' || text.back() == ' ')) text.pop_back();
  if (!text.empty()) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return e.GetPos() >= 0 ? text + where : text;
}

}  // namespace

const char* const expressionWords =
    "`+ - * / ^`, `< <= > >= == !=`, `&& ||`, `a ? b : c`, `sin cos tan asin acos atan atan2 sinh cosh "
    "tanh`, `exp ln log10 sqrt abs sign rint min max`, `pi`";

Expression parseExpression(const std::string& text) {
  if (text.size() > longest) return {{}, fmt::format("it is longer than {} characters", longest)};
  if (const std::size_t k = text.find('\0'); k != std::string::npos)  // muParser would end there
    return {{}, fmt::format("character {} is a zero byte", k + 1)};
  if (const std::size_t k = assignmentIn(text); k != std::string::npos)
    return {{}, fmt::format("'=' at character {}: nothing can be assigned here (equality is '==')", k + 1)};
  const auto formula = std::make_shared<Formula>();
  try {
    mu::Parser& p = formula->parser;
    p.ResetLocale();  // decimal points in every locale
    p.DefineVar("x", &formula->at.x);
    p.DefineVar("y", &formula->at.y);
    p.DefineVar("z", &formula->at.z);
    p.DefineConst("pi", std::numbers::pi);
    p.SetExpr(text);
    p.Eval();  // compiles the expression
    if (p.GetNumResults() != 1) return {{}, "it has several values, separated by commas"};
  } catch (const mu::ParserError& e) { return {{}, messageOf(e)}; } catch (const std::exception& e) {
    return {{}, e.what()};
  }
  return {[formula](const Vec3d& x) {
            formula->at = x;
            return static_cast<double>(formula->parser.Eval());
          },
          ""};
}

bool looksLikeExpression(const std::string& text) {
  if (parseQuantity(text).error.empty()) return false;
  return namesPlace(text) || isArithmetic(text) || text.find_first_of("+*^(?<>=&|") != std::string::npos;
}

}  // namespace thaw
