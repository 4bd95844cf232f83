#include "io/run/kind_run.hpp"

#include "io/hdf5/agree.hpp"
#include "io/hdf5/parallel_file.hpp"
#include "io/output/kind_frame.hpp"

namespace thaw {

void writeKindFrames(Run& r) {
  World& w = r.world;
  eachKind(w, [&](std::size_t kind, const KindRows&, const CellTable&) {
    const std::string name = kindFrameName(r.name, kind), file = frameName(name, w.clock.frame);
    Frame f = kindFrameOf(w, kind);
    if (kind == sheetKind) addSheetTriangles(w, *r.edges, spreadRows(r.comm.handle(), f.count).mine.first, f);
    writeFrame(frameFolder(r.options.out) + "/" + file, r.comm.handle(), f, r.stamp());
    onFirstRank(r.comm.handle(), [&] {
      r.kindSeries[kind].push_back({file, w.clock.time});
      writeSeries(seriesPath(r.options.out, name), r.kindSeries[kind]);
    });
  });
}

void resumeKindFrames(Run& r) {
  onFirstRank(r.comm.handle(), [&] {
    eachKind(r.world, [&](std::size_t kind, const KindRows&, const CellTable&) {
      r.kindSeries[kind] = framesPresent(r.options.out, kindFrameName(r.name, kind), r.world.clock.time);
    });
  });
}

void forgetKindFrames(Run& r) {
  eachKind(r.world, [&](std::size_t kind, const KindRows&, const CellTable&) {
    forgetSeries(r.options.out, kindFrameName(r.name, kind), r.kindSeries[kind], r.world.clock.time);
  });
}

}  // namespace thaw
