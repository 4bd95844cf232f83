// SPDX-License-Identifier: Apache-2.0
#include "io/commands/new_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "io/commands/starting_scenes.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/scene/read_scene.hpp"
#include "io/text/command_error.hpp"

namespace fs = std::filesystem;

namespace thaw {
namespace {

constexpr const char* schemaName = "scene.schema.json";

/// Writes a file that does not exist yet. Throws IoError.
void writeNew(const fs::path& path, const std::string& text) {
  std::FILE* file = std::fopen(path.c_str(), "wx");
  if (!file) throw IoError(path.string(), std::strerror(errno));
  const bool whole = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const int error = errno;
  if (std::fclose(file) != 0 || !whole) {
    fs::remove(path);
    throw IoError(path.string(), std::strerror(whole ? errno : error));
  }
}

/// Returns the scene with its title. Quotes and control characters of a name would end the title.
std::string sceneText(const NewOptions& o, const std::string& name) {
  const auto scenes = startingScenes();
  const auto found = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const StartingScene& s) { return o.kind == s.kind; });
  std::string title;
  for (const char c : name)
    if (static_cast<unsigned char>(c) >= ' ' && c != '"' && c != '\\' && c != 127) title += c;
  const std::string schema = o.schema ? fmt::format("#:schema ./{}\n", schemaName) : "";
  return fmt::format(
      "{}# {}: {}. `thaw check {}.toml` describes the run, `thaw run` starts it.\n"
      "# All keys: `thaw docs`. Numbers are in SI units; a text has a number and a unit.\n"
      "title   = \"{}\"{}",
      schema, title, found->about, title, title, found->text);
}

}  // namespace

CLI::App* addNewCommand(CLI::App& app, NewOptions& o) {
  CLI::App* c = app.add_subcommand("new", "write a commented scene to start from");
  c->add_option("name", o.name, "file of the scene; .toml is added if it is missing")->required();
  std::string kinds;
  for (const StartingScene& s : startingScenes())
    kinds += fmt::format("{}{}: {}", kinds.empty() ? "" : "; ", s.kind, s.about);
  c->add_option("--kind", o.kind, "kind of the scene. " + kinds)
      ->check(CLI::IsMember(startingKinds()))
      ->capture_default_str();
  c->add_flag("--schema", o.schema, fmt::format("also write {} next to it, for editors", schemaName));
  return c;
}

int newCommand(const NewOptions& o) {
  fs::path path = o.name;
  try {
    if (path.filename().empty() || path.filename() == "." || path.filename() == "..")
      throw IoError(path.string(), "expected the name of a file");
    if (path.extension() != ".toml") path += ".toml";
    if (fs::exists(path))
      throw IoError(path.string(), "already exists, and is not overwritten: choose another name");
    const fs::path schema = path.parent_path() / schemaName;
    if (o.schema && !fs::exists(schema)) writeNew(schema, sceneSchema());
    writeNew(path, sceneText(o, path.stem().string()));
  } catch (const std::exception& e) {
    printCommandError("new", e.what());
    return exitInputOutput;
  }
  fmt::print("written: {}\nnext:    thaw run {}\n", path.string(), path.string());
  return 0;
}

}  // namespace thaw
