// SPDX-License-Identifier: Apache-2.0
#include "io/view/page/page_file.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/view/page/byte_planes.hpp"
#include "io/view/server/page.hpp"

namespace thaw {
namespace {

/// Blocks all requests, so the page is the same with and without a network.
constexpr const char* policy =
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; "
    "style-src 'unsafe-inline'; img-src data: blob:\">";

std::string fileOf(std::string_view name) {
  for (const PageFile& file : pageFiles())
    if (file.name == name) return std::string(file.bytes);
  throw std::logic_error("the page has no file " + std::string(name));
}

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

void replaceOnce(std::string& text, std::string_view from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the page has no " + std::string(from));
  text.replace(at, from.size(), to);
}

std::string escaped(std::string text) {
  replaceAll(text, "&", "&amp;");
  replaceAll(text, "<", "&lt;");
  return text;
}

/// Returns a script without texts that would end its element or begin a comment in it.
std::string inElement(std::string script) {
  replaceAll(script, "</script", "<\\/script");
  replaceAll(script, "<!--", "<\\!--");
  return script;
}

}  // namespace

void PageData::addJson(const std::string& name, const nlohmann::ordered_json& json) {
  add(name, deflated(json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)));
}

std::uint64_t bytesInPage(const std::string& stream) { return (stream.size() + 2) / 3 * 4 + 64; }

std::string pageProblem() {
  if (!pageFiles().empty()) return {};
  return "this program is built without its page: scripts/view installs what is missing "
         "(Debian: nodejs, npm) and builds it";
}

std::string pageText(const std::string& title, const PageData& data) {
  std::string page = fileOf("index.html"), body;
  replaceOnce(page, "<meta charset=\"utf-8\">", "<meta charset=\"utf-8\">\n    " + std::string(policy));
  replaceOnce(page, "<title>thaw view</title>", "<title>" + escaped(title) + "</title>");
  replaceOnce(page, "<link rel=\"stylesheet\" href=\"viewer.css\">",
              "<style>" + fileOf("viewer.css") + "</style>");
  replaceOnce(page, "<script type=\"module\" src=\"viewer.js\"></script>", "");
  for (const auto& [name, stream] : data.blocks)
    body += fmt::format("<script type=\"text/plain\" id=\"data-{}\">{}</script>\n", name, base64(stream));
  body += "<script type=\"text/plain\" id=\"licences\">" + escaped(fileOf("licences.txt")) + "</script>\n";
  body += "<script type=\"module\">" + inElement(fileOf("viewer.js")) + "</script>\n";
  replaceOnce(page, "</body>", body + "</body>");
  return page;
}

}  // namespace thaw
