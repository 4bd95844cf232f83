// SPDX-License-Identifier: Apache-2.0
#include "io/run/body_type_run.hpp"

#include "io/frames/body_type_frame.hpp"
#include "io/hdf5/collective_error.hpp"
#include "io/hdf5/parallel_file.hpp"

namespace thaw {

void writeBodyTypeFrames(Run& r) {
  World& w = r.world;
  forEachBodyType(w, [&](std::size_t kind, const BodyTypeRows&, const CellTable&) {
    const std::string name = bodyTypeFrameName(r.name, kind), file = frameName(name, w.clock.frame);
    Frame f = bodyTypeFrameOf(w, kind);
    if (kind == sheetType)
      addSheetTriangles(w.sheets, *r.tables.edges, spreadRows(r.comm.handle(), f.count).mine.first, f);
    writeFrame(frameFolder(r.options.out) + "/" + file, r.comm.handle(), f, r.stamp());
    onDisk(r, [&] {
      r.bodyTypeSeries[kind].push_back({file, w.clock.time});
      writeSeries(seriesPath(r.options.out, name), r.bodyTypeSeries[kind]);
    });
  });
}

void resumeBodyTypeFrames(Run& r) {
  onDisk(r, [&] {
    forEachBodyType(r.world, [&](std::size_t kind, const BodyTypeRows&, const CellTable&) {
      r.bodyTypeSeries[kind] = framesPresent(r.options.out, bodyTypeFrameName(r.name, kind),
                                             r.world.clock.time);
    });
  });
}

void removeBodyTypeFrames(Run& r) {
  forEachBodyType(r.world, [&](std::size_t kind, const BodyTypeRows&, const CellTable&) {
    removeFramesAfter(r.options.out, bodyTypeFrameName(r.name, kind), r.bodyTypeSeries[kind],
                      r.world.clock.time);
  });
}

}  // namespace thaw
