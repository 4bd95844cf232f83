// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "core/domain/emit.hpp"
#include "core/geometry/trees/point_tree.hpp"
#include "io/commands/export/gather_scene.hpp"
#include "io/export/export_surface.hpp"
#include "io/export/texture_seams.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/image/parallel_for.hpp"
#include "io/surface_mesh/mesh_detail.hpp"

namespace thaw {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t neighbours = 4;

/// Weights of the points nearest to a position: inverse squared distances.
struct NearWeights {
  std::vector<std::uint32_t> rows;
  std::vector<double> shares;
  NearWeights(const PointTree& tree, const Vec3d& x) : rows(tree.nearest(x, neighbours)) {
    double sum = 0;
    for (const std::uint32_t i : rows) {
      const Vec3d d = tree.points()[i] - x;
      shares.push_back(1 / (dot(d, d) + 1e-30));
      sum += shares.back();
    }
    for (double& s : shares) s /= sum;
  }
};

/// Adds fields of particles that surfels lack, from the nearest particles below the surface.
void addFieldsOfParticles(SurfaceFrame& surfels, const FrameData& particles) {
  std::vector<const FrameColumn*> missing;
  for (const char* name : {"velocity", "temperature", "liquid"})
    if (const FrameColumn* c = particles.find(name); c && !surfels.find(name)) missing.push_back(c);
  if (missing.empty() || particles.positions.empty()) return;
  const PointTree tree(particles.positions);
  std::vector<NearWeights> weights;
  weights.reserve(surfels.positions.size());
  for (std::size_t i = 0; i < surfels.positions.size(); i++) {
    const Vec3f& n = surfels.normals[i];
    weights.emplace_back(tree,
                         surfels.positions[i] - static_cast<double>(surfels.radii[i]) * Vec3d{n.x, n.y, n.z});
  }
  for (const FrameColumn* c : missing) {
    FrameColumn column{c->name, c->unit, Element::F32, c->components, {}};
    std::vector<float> values;
    values.reserve(weights.size() * static_cast<std::size_t>(c->components));
    for (const NearWeights& w : weights)
      for (int k = 0; k < c->components; k++) {
        double sum = 0;
        for (std::size_t m = 0; m < w.rows.size(); m++) sum += w.shares[m] * c->value(w.rows[m], k);
        values.push_back(static_cast<float>(sum));
      }
    column.bytes.resize(values.size() * sizeof(float));
    if (!values.empty()) std::memcpy(column.bytes.data(), values.data(), column.bytes.size());
    surfels.columns.push_back(std::move(column));
  }
}

/// Returns one colour per surfel. Throws IoError for an unknown field.
std::vector<Rgb> coloursOf(const SurfaceFrame& frame, const ExportOptions& options, const fs::path& file) {
  if (options.field == "surface") return frame.colours;
  const FrameColumn* column = frame.find(options.field);
  if (column && column->components == 1) return coloursOfColumn(*column, frame.positions.size(), options);
  std::string names = "surface";
  for (const FrameColumn& c : frame.columns)
    if (c.components == 1) names += ", " + c.name;
  throw IoError(file.string(), "has no field '" + options.field + "' for the colours; there are: " + names);
}

/// Fields of surfels for the vertices of meshes.
struct SurfelFields {
  std::vector<Vec3f> velocities;
  std::vector<float> temperatures, liquid;
  std::vector<Uv> uvs;
};

/// Returns texture coordinates at weights of surfels: the mean of those on one chart with the nearest one
/// that has coordinates.
Uv uvAt(const NearWeights& near, const ComponentRows& component, const std::vector<Uv>& uvs) {
  constexpr float chart = 0.1f;
  const Uv* nearest = nullptr;
  Uv sum{0, 0};
  float weight = 0;
  for (std::size_t k = 0; k < near.rows.size(); k++) {
    const Uv& uv = uvs[component.rows[near.rows[k]]];
    if (std::isnan(uv[0])) continue;
    if (!nearest) nearest = &uv;
    if (std::hypot(uv[0] - (*nearest)[0], uv[1] - (*nearest)[1]) > chart) continue;
    const auto share = static_cast<float>(near.shares[k]);
    weight += share;
    for (std::size_t c = 0; c < 2; c++) sum[c] += share * uv[c];
  }
  return weight > 0 ? Uv{sum[0] / weight, sum[1] / weight} : Uv{0, 0};
}

/// Returns a column of the frame's texture coordinates.
FrameColumn uvColumn(const std::vector<Uv>& uvs) {
  FrameColumn column{"uv", "1", Element::F32, 2, {}};
  column.bytes.resize(uvs.size() * sizeof(Uv));
  if (!uvs.empty()) std::memcpy(column.bytes.data(), uvs.data(), column.bytes.size());
  return column;
}

std::vector<Uv> uvsOf(const FrameColumn* column, std::size_t rows) {
  std::vector<Uv> uvs;
  for (std::size_t i = 0; column && i < rows; i++)
    uvs.push_back({static_cast<float>(column->value(i, 0)), static_cast<float>(column->value(i, 1))});
  return uvs;
}

/// Interpolates fields to the vertices of a mesh, from the nearest surfels of its component.
void addFieldsOfSurfels(ComponentMesh& mesh, const SurfaceFrame& frame, const ComponentRows& component,
                        const SurfelFields& fields, const PeriodicSides& sides) {
  if (fields.velocities.empty() && fields.temperatures.empty() && fields.liquid.empty() && fields.uvs.empty())
    return;
  const UnwrappedComponent whole = unwrapComponent(frame, component.rows, sides);
  const PointTree tree(whole.positions);
  for (const Vec3d& x : mesh.mesh.vertices) {
    const NearWeights near(tree, x);
    Vec3f velocity{};
    float temperature = 0, liquid = 0;
    for (std::size_t k = 0; k < near.rows.size(); k++) {
      const std::uint32_t row = component.rows[near.rows[k]];
      const auto share = static_cast<float>(near.shares[k]);
      if (!fields.velocities.empty()) velocity += share * fields.velocities[row];
      if (!fields.temperatures.empty()) temperature += share * fields.temperatures[row];
      if (!fields.liquid.empty()) liquid += share * fields.liquid[row];
    }
    if (!fields.velocities.empty()) mesh.velocities.push_back(velocity);
    if (!fields.temperatures.empty()) mesh.temperatures.push_back(temperature);
    if (!fields.liquid.empty()) mesh.liquid.push_back(liquid);
    if (!fields.uvs.empty()) mesh.uvs.push_back(uvAt(near, component, fields.uvs));
  }
}

std::vector<ComponentMesh> meshesOf(const SurfaceFrame& frame, const std::vector<Rgb>& colours,
                                    const GatherJob& job, const PeriodicSides& sides, const Walls& walls) {
  const std::vector<ComponentRows> components = rowsByComponent(frame);
  const std::size_t rows = frame.positions.size();
  const SurfelFields fields{vectorsOf(frame.find("velocity"), rows),
                            numbersOf(frame.find("temperature"), rows), numbersOf(frame.find("liquid"), rows),
                            uvsOf(frame.find("uv"), rows)};
  std::vector<ComponentMesh> meshes(components.size());
  parallelFor(components.size(), job.threads, [&](std::size_t c) {
    meshes[c] = detailedMeshOfComponent(frame, components[c], colours, sides,
                                        {.cell = job.options->cell, .walls = &walls});
    if (!meshes[c].mesh.triangles.empty()) addFieldsOfSurfels(meshes[c], frame, components[c], fields, sides);
  });
  return meshes;
}

/// Names meshes after the body or emitter of their label, which is the id of a particle. The first mesh of a
/// body has its name, the others the number of that particle behind it.
void nameMeshes(const std::vector<std::string>& sources, std::vector<ComponentMesh>& meshes) {
  std::set<std::uint64_t> named;
  for (ComponentMesh& m : meshes) {
    const std::uint64_t source = sourceOf(m.component);
    if (source >= sources.size()) continue;
    const std::string& name = sources[source];
    m.body = named.insert(source).second ? name : fmt::format("{}_{}", name, numberOf(m.component));
  }
}

void addNotes(const std::vector<ComponentMesh>& meshes, std::size_t empty, const fs::path& file, double cell,
              GatherNotes& notes) {
  std::size_t finer = 0, triangles = 0;
  for (const ComponentMesh& m : meshes) {
    triangles += m.mesh.triangles.size();
    finer += m.edge < m.asked;
    if (const std::string note = cutNote(m); !note.empty())
      notes.notes.push_back(fmt::format("component {}{}", m.component, note));
  }
  if (cell > 1 && finer > 0)
    notes.warnings.push_back(
        fmt::format("warning: {}: --cell {:g}: cubes of {:.3g} m are too wide for {} of {} components, which "
                    "use finer ones; 0.5 to 2 is recommended",
                    file.string(), cell, meshes[0].asked, finer, meshes.size()));
  notes.summary = fmt::format("{} component{}, {} triangles", meshes.size(), meshes.size() == 1 ? "" : "s",
                              triangles);
  if (empty > 0) notes.summary += fmt::format("; {} components enclose nothing and are left out", empty);
}

}  // namespace

void gatherSurface(const FrameGroup& group, const GatherJob& job, ExportScene& scene, GatherNotes& notes) {
  SurfaceFrame frame;
  FrameData particles;
  {
    const std::lock_guard lock(job.scenes->hdf5);
    frame = readSurfaceFrame(group.surface.string());
    if (!group.particles.empty())
      particles = readFrame(group.particles.string(), [](const std::string& name) {
        return name == "velocity" || name == "temperature" || name == "liquid";
      });
  }
  addFieldsOfParticles(frame, particles);
  if (job.uv) frame.columns.push_back(uvColumn(job.uv->of(frame)));
  scene.surfelColours = coloursOf(frame, *job.options, group.surface);
  if (job.format->keepsSurfels && job.contents == surfaceContent && !job.options->mesh) {
    notes.summary = fmt::format("{} surfels", frame.positions.size());
  } else {
    Walls walls;
    if (const auto stored = job.scenes->of(group.first(), notes.warnings)) walls = stored->picture.walls;
    moveWalls(walls, scene.time);
    ExportObject surface{"surface", ExportKind::Surface, {}, {}, false};
    surface.parts = meshesOf(frame, scene.surfelColours, job, scene.periodic, walls);
    const auto empty = static_cast<std::size_t>(
        std::erase_if(surface.parts, [](const ComponentMesh& m) { return m.mesh.triangles.empty(); }));
    if (job.format->uv == UvPlace::vertices)
      for (ComponentMesh& part : surface.parts) splitAtSeams(part);
    nameMeshes(scene.sourceNames, surface.parts);
    addNotes(surface.parts, empty, group.surface, job.options->cell, notes);
    scene.objects.push_back(std::move(surface));
  }
  scene.surfels = std::move(frame);
}

}  // namespace thaw
