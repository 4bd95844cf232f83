// SPDX-License-Identifier: Apache-2.0
#include "io/commands/export/frame_group.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "io/frames/read_oriented_frame.hpp"
#include "io/render/frame_source.hpp"

namespace thaw {

namespace fs = std::filesystem;

namespace {

constexpr unsigned frameContents[] = {surfaceContent, orientedContent, sheetContent, particleContent};

const char* suffixOf(unsigned content) {
  return content == surfaceContent    ? "_surface"
         : content == sheetContent    ? "_sheet"
         : content == orientedContent ? "_oriented"
                                      : "";
}

FrameKind kindOf(unsigned content) {
  return content == surfaceContent    ? FrameKind::Surface
         : content == sheetContent    ? FrameKind::Sheet
         : content == orientedContent ? FrameKind::Oriented
                                      : FrameKind::Particles;
}

fs::path& fileOf(FrameGroup& group, unsigned content) {
  return content == surfaceContent    ? group.surface
         : content == sheetContent    ? group.sheets
         : content == orientedContent ? group.oriented
                                      : group.particles;
}

/// Returns the frame of another content at the same time, or nothing.
fs::path companionOf(const fs::path& frame, unsigned own, unsigned other) {
  std::string stem = frame.stem().string();
  const std::size_t number = stem.find_last_of('_');
  if (number == std::string::npos) return {};
  std::string name = stem.substr(0, number);
  const std::string suffix = suffixOf(own);
  if (!name.ends_with(suffix)) return {};
  name.resize(name.size() - suffix.size());
  const fs::path path = frame.parent_path() / (name + suffixOf(other) + stem.substr(number) + ".hdf");
  return fs::exists(path) ? path : fs::path();
}

/// Returns the frames of a content, or none.
std::vector<fs::path> framesOf(const fs::path& input, unsigned content) {
  try {
    return findFrames(input, kindOf(content));
  } catch (const IoError&) { return {}; }
}

/// Returns the first requested content of a run, and its frames. Throws IoError if there is none.
std::vector<fs::path> firstFrames(const ExportOptions& options, unsigned wanted, unsigned& content) {
  if (!fs::exists(options.input)) findFrames(options.input);  // throws the error
  if (!fs::is_directory(options.input)) {
    std::vector<fs::path> frames = findFrames(options.input);
    if (frames.empty()) throw IoError(options.input.string(), "the index names no frames");
    content = contentOfFrame(frames.front());
    return frames;
  }
  for (const unsigned c : frameContents) {
    if (!(wanted & c)) continue;
    std::vector<fs::path> frames = framesOf(options.input, c);
    if (frames.empty()) continue;
    // without a surface, findFrames may return frames of sheets
    content = contentOfFrame(frames.front());
    return frames;
  }
  for (const unsigned c : frameContents)
    if (wanted & c) findFrames(options.input, kindOf(c));  // throws the error of the first kind
  throw IoError(options.input.string(), "there are no frames to export in this folder");
}

}  // namespace

fs::path FrameGroup::first() const {
  for (const fs::path* p : {&surface, &oriented, &sheets, &particles})
    if (!p->empty()) return *p;
  return {};
}

std::string outputName(const FrameGroup& group, unsigned contents) {
  FrameGroup files = group;
  for (const unsigned c : frameContents)
    if (contents == c) return fileOf(files, c).stem().string();
  const std::string stem = group.first().stem().string(),
                    suffix = suffixOf(group.first() == group.surface    ? surfaceContent
                                      : group.first() == group.oriented ? orientedContent
                                      : group.first() == group.sheets   ? sheetContent
                                                                        : particleContent);
  const std::size_t number = stem.find_last_of('_');
  const char* kind = contents == obstacleContent ? "_obstacles" : "_all";
  if (number == std::string::npos) return stem + kind;
  std::string name = stem.substr(0, number);
  if (name.ends_with(suffix)) name.resize(name.size() - suffix.size());
  return name + kind + stem.substr(number);
}

unsigned contentOfFrame(const fs::path& frame) {
  const FrameInfo info = readFrameInfo(frame.string());
  if (isOrientedFrame(info)) return orientedContent;
  for (const FrameInfo::Field& f : info.fields)
    if (f.name == "sheet_body") return sheetContent;
  return isSurfaceFrame(info) ? surfaceContent : particleContent;
}

std::vector<FrameGroup> findFrameGroups(const ExportOptions& options, const ExportFormat& format,
                                        unsigned& contents) {
  const unsigned named = contentsNamed(options.what);
  for (unsigned c = 1; c <= named; c <<= 1)
    if (named != allContent && (named & c) && !(format.holds & c))
      throw std::invalid_argument(
          fmt::format("{} are exported as {}, not as {}", contentText(c), formatsHolding(c), format.name));
  unsigned wanted = named == 0 ? format.holds : named & format.holds;
  const unsigned ofFrames = wanted & ~obstacleContent;
  unsigned main = 0;
  const std::vector<fs::path> frames = firstFrames(
      options, ofFrames != 0 ? ofFrames : static_cast<unsigned>(allContent), main);
  if (named == 0) {
    if (main == particleContent && !(format.holds & main))
      throw IoError(frames.front().string(), noSurfaceFrame);
    if (!(format.holds & main))
      throw std::invalid_argument(fmt::format("{} are exported as {}, not as {}", contentText(main),
                                              formatsHolding(main), format.name));
    if (!format.holdsAllByDefault) wanted = main;
    else if (main == surfaceContent) wanted &= ~static_cast<unsigned>(particleContent);
  }
  std::vector<FrameGroup> groups;
  contents = wanted & obstacleContent;
  for (const fs::path& frame : frames) {
    FrameGroup group;
    fileOf(group, main) = frame;
    for (const unsigned c : frameContents) {
      // surfels take fields from particles, so frames of particles are always read
      if (c == main || !((wanted | particleContent) & c)) continue;
      fileOf(group, c) = companionOf(frame, main, c);
    }
    for (const unsigned c : frameContents)
      if ((wanted & c) && !fileOf(group, c).empty()) contents |= c;
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace thaw
