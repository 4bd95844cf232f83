// SPDX-License-Identifier: Apache-2.0
#include "io/commands/export/formats.hpp"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>
#include <vector>

#include "io/commands/export/export_frames.hpp"
#include "io/commands/export/export_page.hpp"
#include "io/export/export_surface.hpp"
#include "io/export/write_bgeo.hpp"
#include "io/export/write_vdb.hpp"

namespace thaw {

namespace fs = std::filesystem;

namespace {

void plyDiscs(const fs::path& file, const ExportScene& scene) {
  writePlyDiscs(file, *scene.surfels, scene.surfelColours);
}

void pov(const fs::path& file, const ExportScene& scene) {
  writePov(file, *scene.surfels, scene.surfelColours, scene.style);
}

void vtp(const fs::path& file, const ExportScene& scene) {
  if (scene.table) writeTrianglesVtp(file, scene.table->frame, scene.table->lines);
  else if (!scene.objects.empty() || !scene.surfels) writeMeshVtp(file, scene.time, placedParts(scene));
  else writeVtp(file, *scene.surfels, scene.surfelColours);
}

void ply(const fs::path& file, const ExportScene& scene) { writeMeshPly(file, placedParts(scene)); }
void obj(const fs::path& file, const ExportScene& scene) { writeMeshObj(file, placedParts(scene)); }

constexpr unsigned meshContents = surfaceContent | sheetContent | orientedContent | obstacleContent;

// The order is that of --help.
const ExportFormat formats[] = {
    {"ply-discs", ".discs.ply", "a polygon for each surfel (Blender)", surfaceContent, true, false, false,
     UvPlace::none, plyDiscs, nullptr},
    {"pov", ".pov", "a scene of POV-Ray", surfaceContent, true, false, false, UvPlace::none, pov, nullptr},
    {"vtp", ".vtp",
     "points with all fields, and the triangles of sheets, oriented particles and obstacles; with --mesh "
     "of surfaces (ParaView)",
     meshContents, true, true, false, UvPlace::vertices, vtp, nullptr},
    {"ply", ".ply",
     "a closed triangle mesh of each component, or the triangles of each sheet, oriented surface or "
     "obstacle, "
     "and the lines of a curve",
     meshContents, false, false, false, UvPlace::vertices, ply, nullptr},
    {"obj", ".obj", "the same as text", meshContents, false, false, false, UvPlace::corners, obj, nullptr},
    {"usd", ".usdc",
     "one USD layer of all frames with meshes, particles, obstacles and camera (Houdini, Blender, "
     "Maya, Omniverse)",
     allContent, false, false, true, UvPlace::corners, nullptr, exportUsd},
    {"usda", ".usda", "the same layer as text", allContent, false, false, true, UvPlace::corners, nullptr,
     exportUsd},
    {"vtkhdf", ".vtkhdf", "one VTKHDF file of all frames with meshes or particles (ParaView 5.12 and newer)",
     allContent, false, false, false, UvPlace::vertices, nullptr, exportVtkHdf},
    {"bgeo", ".bgeo", "Houdini geometry, classic version: points and triangles", allContent, false, false,
     false, UvPlace::corners, writeBgeo, nullptr},
    {"vdb", ".vdb",
     "OpenVDB: the level set of a surface, fog volumes of the particles, and the particles as points",
     surfaceContent | particleContent, false, false, true, UvPlace::none, writeVdb, nullptr},
    {"html", ".html", "the run as one page for any browser, without a server", allContent, true, true, true,
     UvPlace::none, nullptr, exportRunPage},
};

struct NamedContent {
  const char* name;
  unsigned content;
};
constexpr NamedContent contents[] = {{"surface", surfaceContent},    {"sheet", sheetContent},
                                     {"oriented", orientedContent},  {"obstacles", obstacleContent},
                                     {"particles", particleContent}, {"all", allContent}};

}  // namespace

std::span<const ExportFormat> exportFormats() { return formats; }

const ExportFormat& exportFormatNamed(const std::string& name) {
  for (const ExportFormat& f : formats)
    if (f.name == name) return f;
  throw std::invalid_argument("unknown format '" + name + "'");
}

unsigned contentsNamed(const std::string& list) {
  unsigned sum = 0;
  std::istringstream names(list);
  for (std::string name; std::getline(names, name, ',');) {
    unsigned found = 0;
    for (const NamedContent& c : contents)
      if (name == c.name) found = c.content;
    if (found == 0)
      throw std::invalid_argument(
          fmt::format("--what: expected surface, sheet, oriented, obstacles, particles or all, separated by "
                      "commas, got '{}'",
                      name));
    sum |= found;
  }
  return sum;
}

const char* contentText(unsigned content) {
  return content == surfaceContent    ? "surfaces"
         : content == sheetContent    ? "sheets"
         : content == orientedContent ? "oriented particles"
         : content == obstacleContent ? "obstacles"
                                      : "particles";
}

std::string formatsHolding(unsigned content) {
  std::vector<std::string> names;
  for (const ExportFormat& f : formats)
    if (f.holds & content) names.push_back(f.name);
  std::string text;
  for (std::size_t k = 0; k < names.size(); k++)
    text += (k == 0 ? "" : k + 1 < names.size() ? ", " : " or ") + names[k];
  return text;
}

}  // namespace thaw
