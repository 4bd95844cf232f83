// SPDX-License-Identifier: Apache-2.0
#include "io/export/write_vdb.hpp"

#include <algorithm>
#include <cmath>

#include <openvdb/openvdb.h>
#include <openvdb/points/PointConversion.h>
#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/PointIndexGrid.h>

#include "io/hdf5/io_error.hpp"

namespace thaw {

namespace {

using openvdb::FloatGrid;
using openvdb::Vec3SGrid;

/// Support radius of a particle, in voxels.
constexpr double reach = 1.5;

double weightAt(double squaredVoxels) {
  const double q = 1 - squaredVoxels / (reach * reach);
  return q > 0 ? q * q : 0;
}

/// Returns the sum of weights inside a cubic lattice of particles.
double bulkWeight() {
  double sum = 0;
  for (int x = -2; x <= 2; x++)
    for (int y = -2; y <= 2; y++)
      for (int z = -2; z <= 2; z++) sum += weightAt(x * x + y * y + z * z);
  return sum;
}

template<class Grid> typename Grid::Ptr newGrid(const char* name, double voxel, openvdb::GridClass kind) {
  auto grid = Grid::create();
  grid->setName(name);
  grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel));
  grid->setGridClass(kind);
  return grid;
}

openvdb::GridBase::Ptr levelSetOf(const ExportScene& scene, double voxel) {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  for (const ExportObject& object : scene.objects) {
    if (object.kind != ExportKind::Surface) continue;
    for (const ComponentMesh& part : object.parts) {
      const auto first = static_cast<std::uint32_t>(points.size());
      for (const Vec3d& x : part.mesh.vertices) points.emplace_back(x.x, x.y, x.z);
      for (const auto& t : part.mesh.triangles)
        triangles.emplace_back(first + t[0], first + t[1], first + t[2]);
    }
  }
  constexpr float halfWidth = 3;  // voxels
  const auto transform = openvdb::math::Transform::createLinearTransform(voxel);
  auto grid = openvdb::tools::meshToLevelSet<FloatGrid>(*transform, points, triangles, halfWidth);
  grid->setName("surface");
  return grid;
}

/// Calls visit(voxel, weight) for the voxels near a particle.
template<class Visit> void forVoxelsNear(const Vec3f& x, double voxel, Visit visit) {
  const double at[3] = {x.x / voxel, x.y / voxel, x.z / voxel};
  int low[3], high[3];
  for (int a = 0; a < 3; a++)
    low[a] = static_cast<int>(std::ceil(at[a] - reach)),
    high[a] = static_cast<int>(std::floor(at[a] + reach));
  for (int i = low[0]; i <= high[0]; i++)
    for (int j = low[1]; j <= high[1]; j++)
      for (int k = low[2]; k <= high[2]; k++) {
        const double dx = i - at[0], dy = j - at[1], dz = k - at[2],
                     weight = weightAt(dx * dx + dy * dy + dz * dz);
        if (weight > 0) visit(openvdb::Coord(i, j, k), static_cast<float>(weight));
      }
}

/// Returns the weighted mean of a particle field near each voxel. weights: sums of the weights.
template<class Grid, class Value>
typename Grid::Ptr meanGrid(const char* name, const ExportPoints& points, const FloatGrid& weights,
                            Value value) {
  const double voxel = weights.voxelSize()[0];
  auto grid = newGrid<Grid>(name, voxel, openvdb::GRID_FOG_VOLUME);
  auto to = grid->getAccessor();
  auto sums = weights.getConstAccessor();
  for (std::size_t i = 0; i < points.positions.size(); i++) {
    const auto v = value(i);
    forVoxelsNear(points.positions[i], voxel, [&](const openvdb::Coord& c, float weight) {
      to.setValue(c, to.getValue(c) + v * (weight / sums.getValue(c)));
    });
  }
  return grid;
}

FloatGrid::Ptr weightsOf(const ExportPoints& points, double voxel) {
  auto grid = newGrid<FloatGrid>("density", voxel, openvdb::GRID_FOG_VOLUME);
  auto to = grid->getAccessor();
  for (const Vec3f& x : points.positions)
    forVoxelsNear(x, voxel,
                  [&](const openvdb::Coord& c, float weight) { to.setValue(c, to.getValue(c) + weight); });
  return grid;
}

void addFogs(const ExportPoints& points, double voxel, openvdb::GridPtrVec& grids) {
  const FloatGrid::Ptr weights = weightsOf(points, voxel);
  if (!points.temperatures.empty())
    grids.push_back(meanGrid<FloatGrid>("temperature", points, *weights,
                                        [&](std::size_t i) { return points.temperatures[i]; }));
  if (!points.liquid.empty())
    grids.push_back(
        meanGrid<FloatGrid>("liquid", points, *weights, [&](std::size_t i) { return points.liquid[i]; }));
  if (!points.velocities.empty()) {
    auto grid = meanGrid<Vec3SGrid>("velocity", points, *weights, [&](std::size_t i) {
      const Vec3f& v = points.velocities[i];
      return openvdb::Vec3s(v.x, v.y, v.z);
    });
    grid->setVectorType(openvdb::VEC_CONTRAVARIANT_RELATIVE);
    grids.push_back(grid);
  }
  const auto bulk = static_cast<float>(bulkWeight());
  for (auto it = weights->beginValueOn(); it; ++it) it.setValue(std::min(1.0f, it.getValue() / bulk));
  grids.insert(grids.begin(), weights);
}

/// Adds an attribute with a value per particle, in the order of `index`.
template<class T, class Value>
void addAttribute(openvdb::points::PointDataGrid& grid, const openvdb::tools::PointIndexGrid& index,
                  const char* name, std::size_t count, Value value) {
  namespace points = openvdb::points;
  std::vector<T> values;
  values.reserve(count);
  for (std::size_t i = 0; i < count; i++) values.push_back(value(i));
  points::appendAttribute<T>(grid.tree(), name);
  const points::PointAttributeVector<T> wrapped(values);
  points::populateAttribute<openvdb::points::PointDataTree, openvdb::tools::PointIndexTree,
                            points::PointAttributeVector<T>>(grid.tree(), index.tree(), name, wrapped);
}

/// Returns the particles with their fields, for programs that read points.
openvdb::GridBase::Ptr pointGridOf(const ExportPoints& particles, double spacing) {
  namespace points = openvdb::points;
  constexpr double spacingsOfVoxel = 2;  // about eight points in a voxel
  std::vector<openvdb::Vec3s> positions;
  positions.reserve(particles.positions.size());
  for (const Vec3f& x : particles.positions) positions.emplace_back(x.x, x.y, x.z);
  const auto transform = openvdb::math::Transform::createLinearTransform(spacingsOfVoxel * spacing);
  const points::PointAttributeVector<openvdb::Vec3s> wrapped(positions);
  const auto index = openvdb::tools::createPointIndexGrid<openvdb::tools::PointIndexGrid>(wrapped,
                                                                                          *transform);
  auto grid = points::createPointDataGrid<points::NullCodec, points::PointDataGrid>(*index, wrapped,
                                                                                    *transform);
  grid->setName("points");
  const std::size_t n = positions.size();
  const auto scalar = [&](const char* name, const std::vector<float>& field) {
    if (n > 0 && field.size() == n)
      addAttribute<float>(*grid, *index, name, n, [&](std::size_t i) { return field[i]; });
  };
  if (n > 0 && particles.velocities.size() == n)
    addAttribute<openvdb::Vec3s>(*grid, *index, "v", n, [&](std::size_t i) {
      const Vec3f& v = particles.velocities[i];
      return openvdb::Vec3s(v.x, v.y, v.z);
    });
  scalar("temperature", particles.temperatures);
  scalar("liquid", particles.liquid);
  if (n > 0 && particles.ids.size() == n)
    addAttribute<std::int64_t>(*grid, *index, "id", n,
                               [&](std::size_t i) { return static_cast<std::int64_t>(particles.ids[i]); });
  if (particles.widths && particles.widths->size() == n)
    addAttribute<float>(*grid, *index, "pscale", n,
                        [&](std::size_t i) { return 0.5f * (*particles.widths)[i]; });
  return grid;
}

}  // namespace

void writeVdb(const std::filesystem::path& file, const ExportScene& scene) {
  openvdb::initialize();
  const double spacing = scene.spacing > 0 ? scene.spacing
                         : scene.points    ? static_cast<double>(scene.points->width)
                         : scene.surfels && !scene.surfels->radii.empty()
                             ? 2.0 * static_cast<double>(scene.surfels->radii[0])
                             : 0.01;
  openvdb::GridPtrVec grids;
  std::filesystem::path part = file;
  part += ".part";
  try {
    if (scene.surfels) grids.push_back(levelSetOf(scene, 0.5 * spacing));
    if (scene.points) {
      addFogs(*scene.points, spacing, grids);
      grids.push_back(pointGridOf(*scene.points, spacing));
    }
    openvdb::io::File out(part.string());
    out.write(grids);
    out.close();
    std::filesystem::rename(part, file);
  } catch (const std::exception& error) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw IoError(file.string(), std::string("cannot be written: ") + error.what());
  }
}

}  // namespace thaw
