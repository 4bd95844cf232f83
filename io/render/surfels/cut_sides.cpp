// SPDX-License-Identifier: Apache-2.0
#include "io/render/surfels/cut_sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/render/surfels/surfel_rows.hpp"
#include "io/surface_mesh/plane_field.hpp"
#include "io/surface_mesh/surface_mesh.hpp"

namespace thaw {

namespace {

constexpr double imageReach = 3;  // in radii: images count for the curvature and the clips of discs at a side
constexpr double cellOfRadius = 0.7;  // edge of a cap's cells, in mean radii
constexpr double mostCorners = 4e6;   // largest number in a cap

/// A surfel or an image of it.
struct Place {
  std::uint32_t row;
  Vec3d at;
};

/// Corner of a cap. nearest: row of a surfel.
struct CapCorner {
  Vec3d at;
  Vec3f normal;
  std::uint32_t nearest;
  float radius;
};

struct Additions {
  std::vector<Place> images;
  std::vector<std::uint8_t> imageAxes;
  std::vector<CapCorner> corners;
  std::vector<std::array<std::uint32_t, 3>> faces;  // triangles of corners
};

std::vector<Place> withImages(const SurfaceFrame& frame, const std::vector<std::uint32_t>& rows,
                              std::uint8_t axes, const PeriodicSides& sides) {
  std::vector<Place> all;
  for (const std::uint32_t i : rows) all.push_back({i, frame.positions[i]});
  for (int a = 0; a < 3; a++) {
    if (!(axes >> a & 1)) continue;
    const std::size_t before = all.size();
    for (std::size_t k = 0; k < before; k++)
      for (const double shift : {-sides.period[a], sides.period[a]}) {
        Place image = all[k];
        image.at[a] += shift;
        const double reach = imageReach * frame.radii[image.row], low = sides.min[a] - reach,
                     high = sides.min[a] + sides.period[a] + reach;
        if (image.at[a] > low && image.at[a] < high) all.push_back(image);
      }
  }
  return all;
}

/// Marching squares in a side.
class CapMaker {
 public:
  /// places: of one component, with images. axis: across the upper side.
  CapMaker(const SurfaceFrame& frame, const std::vector<Place>& places, std::uint8_t axes, int axis,
           const PeriodicSides& sides)
      : axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3), side_(sides.min[axis] + sides.period[axis]) {
    double mean = 0, reach = 0;
    for (const Place& p : places) {
      const float r = frame.radii[p.row];
      mean += r / static_cast<double>(places.size());
      reach = std::max(reach, planeReach * r);
    }
    cell_ = cellOfRadius * mean;
    for (const Place& p : places) {
      if (!(std::abs(p.at[axis] - side_) < reach + cell_)) continue;
      near_.push_back(p);
      beside_.positions.push_back(p.at);
      beside_.normals.push_back(frame.normals[p.row]);
      beside_.radii.push_back(frame.radii[p.row]);
      beside_.colours.push_back(frame.colours[p.row]);
    }
    if (near_.empty()) return;
    setGrid(axes, sides, reach);
    const PlaneField field(beside_, cell_);
    findValues(field);
    classifyOthers();
    march(field);
  }

  /// Adds the cap at the upper side, or with `lower` at the opposite one.
  void addTo(Additions& to, bool lower, double period) const {
    const auto first = static_cast<std::uint32_t>(to.corners.size());
    Vec3f normal{};
    normal[axis_] = lower ? -1.0f : 1.0f;
    for (CapCorner c : corners_) {
      if (lower) c.at[axis_] -= period;
      c.normal = normal;
      to.corners.push_back(c);
    }
    for (const auto& [a, b, c] : faces_)
      to.faces.push_back({first + a, first + (lower ? c : b), first + (lower ? b : c)});
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;

  void setGrid(std::uint8_t axes, const PeriodicSides& sides, double reach) {
    for (int k = 0; k < 2; k++) {
      const int a = k == 0 ? u_ : v_;
      cut_[k] = axes >> a & 1;
      if (cut_[k]) {
        low_[k] = sides.min[a], high_[k] = sides.min[a] + sides.period[a];
        continue;
      }
      for (const Place& p : near_)
        low_[k] = std::min(low_[k], p.at[a] - reach - 2 * cell_),
        high_[k] = std::max(high_[k], p.at[a] + reach + 2 * cell_);
    }
    cell_ *= std::max(1.0,
                      std::sqrt((high_[0] - low_[0]) * (high_[1] - low_[1]) / (cell_ * cell_ * mostCorners)));
    for (int k = 0; k < 2; k++) {
      const double cells = std::max(1.0, std::ceil((high_[k] - low_[k]) / cell_));
      count_[k] = static_cast<std::int64_t>(cells) + 1;
      edge_[k] = (high_[k] - low_[k]) / cells;
    }
  }

  std::size_t index(std::int64_t i, std::int64_t j) const {
    return static_cast<std::size_t>(i + count_[0] * j);
  }
  Vec3d place(double i, double j) const {
    Vec3d x;
    x[axis_] = side_, x[u_] = low_[0] + i * edge_[0], x[v_] = low_[1] + j * edge_[1];
    return x;
  }

  /// Sets the values of corners near surfels.
  void findValues(const PlaneField& field) {
    value_.assign(index(0, count_[1]), std::numeric_limits<double>::quiet_NaN());
    std::vector<std::uint8_t> wanted(value_.size(), 0);
    for (const Place& p : near_) {
      std::int64_t from[2], to[2];
      for (int k = 0; k < 2; k++) {
        const double at = (p.at[k == 0 ? u_ : v_] - low_[k]) / edge_[k];
        const double reach = 2.5 * cell_ / (cellOfRadius * edge_[k]);
        from[k] = std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(at - reach)));
        to[k] = std::min<std::int64_t>(count_[k] - 1, static_cast<std::int64_t>(std::floor(at + reach)));
      }
      for (std::int64_t j = from[1]; j <= to[1]; j++)
        for (std::int64_t i = from[0]; i <= to[0]; i++) wanted[index(i, j)] = 1;
    }
    for (std::int64_t j = 0; j < count_[1]; j++)
      for (std::int64_t i = 0; i < count_[0]; i++) {
        if (!wanted[index(i, j)]) continue;
        const PlaneHeight h = field.at(place(static_cast<double>(i), static_cast<double>(j)));
        if (h.known) value_[index(i, j)] = h.value;
      }
  }

  /// Sets the values of other corners by connected region: inside if most adjacent values are.
  void classifyOthers() {
    std::vector<std::uint8_t> seen(value_.size(), 0);
    for (std::size_t start = 0; start < value_.size(); start++) {
      if (seen[start] || !std::isnan(value_[start])) continue;
      std::vector<std::size_t> region{start};
      seen[start] = 1;
      std::int64_t insideExcess = 0;
      bool open = false;
      for (std::size_t k = 0; k < region.size(); k++) {
        const auto at = static_cast<std::int64_t>(region[k]);
        const std::int64_t c[2] = {at % count_[0], at / count_[0]};
        for (int side = 0; side < 4; side++) {
          const int axis = side / 2;
          std::int64_t n[2] = {c[0], c[1]};
          n[axis] += side % 2 ? 1 : -1;
          if (n[axis] < 0 || n[axis] >= count_[axis]) {
            open = open || !cut_[axis];
            continue;
          }
          const std::size_t next = index(n[0], n[1]);
          if (!std::isnan(value_[next]) && !seen[next]) insideExcess += value_[next] < 0 ? 1 : -1;
          else if (!seen[next]) seen[next] = 1, region.push_back(next);
        }
      }
      for (const std::size_t c : region) value_[c] = (open || insideExcess <= 0 ? 1 : -1) * cell_;
    }
  }

  std::uint32_t add(const Vec3d& x) {
    std::size_t best = 0;
    double best2 = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < near_.size(); k++)
      if (const Vec3d d = near_[k].at - x; dot(d, d) < best2) best2 = dot(d, d), best = k;
    corners_.push_back({x, {}, near_[best].row, static_cast<float>(0.6 * cell_)});
    return static_cast<std::uint32_t>(corners_.size() - 1);
  }

  /// Returns the crossing between two corners, 0 to 1.
  double crossing(const PlaneField& field, const Vec3d& p, const Vec3d& along, double from, double to) const {
    double low = 0, high = 1, t = from / (from - to);
    for (int k = 0; k < 3; k++) {
      const PlaneHeight h = field.at(p + t * along);
      if (!h.known) break;
      if ((h.value < 0) == (from < 0)) low = t, from = h.value;
      else high = t, to = h.value;
      if (from != to) t = low + (high - low) * std::clamp(from / (from - to), 0.0, 1.0);
    }
    return t;
  }

  void march(const PlaneField& field) {
    // per corner: vertices at it, and on its edges along u and v
    std::vector<std::array<std::uint32_t, 3>> made(value_.size(), {none, none, none});
    const auto vertex = [&](std::int64_t i, std::int64_t j, std::size_t what) {
      std::uint32_t& v = made[index(i, j)][what];
      if (v != none) return v;
      const Vec3d p = place(static_cast<double>(i), static_cast<double>(j));
      if (what == 0) return v = add(p);
      const std::int64_t k = i + (what == 1), l = j + (what == 2);
      const Vec3d along = place(static_cast<double>(k), static_cast<double>(l)) - p;
      return v = add(p + crossing(field, p, along, value_[index(i, j)], value_[index(k, l)]) * along);
    };
    constexpr std::int64_t around[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (std::int64_t j = 0; j + 1 < count_[1]; j++)
      for (std::int64_t i = 0; i + 1 < count_[0]; i++) {
        std::uint32_t polygon[8];
        std::size_t n = 0;
        for (int c = 0; c < 4; c++) {
          const std::int64_t x = i + around[c][0], y = j + around[c][1], xn = i + around[(c + 1) % 4][0],
                             yn = j + around[(c + 1) % 4][1];
          const bool in = value_[index(x, y)] < 0;
          if (in) polygon[n++] = vertex(x, y, 0);
          if (in != (value_[index(xn, yn)] < 0))
            polygon[n++] = vertex(std::min(x, xn), std::min(y, yn), y == yn ? 1 : 2);
        }
        for (std::size_t k = 2; k < n; k++) faces_.push_back({polygon[0], polygon[k - 1], polygon[k]});
      }
  }

  int axis_, u_, v_;
  double side_, cell_ = 0;
  std::vector<Place> near_;
  SurfaceFrame beside_;  // copy of near_ for PlaneField
  bool cut_[2] = {};
  double low_[2] = {1e300, 1e300}, high_[2] = {-1e300, -1e300}, edge_[2] = {};  // m, along u and v
  std::int64_t count_[2] = {};
  std::vector<double> value_;  // m, above 0 outside
  std::vector<CapCorner> corners_;
  std::vector<std::array<std::uint32_t, 3>> faces_;
};

void addComponent(const SurfaceFrame& frame, const ComponentRows& component, std::uint8_t axes,
                  const PeriodicSides& sides, Additions& to) {
  const std::vector<Place> places = withImages(frame, component.rows, axes, sides);
  to.images.insert(to.images.end(), places.begin() + static_cast<std::ptrdiff_t>(component.rows.size()),
                   places.end());
  to.imageAxes.resize(to.images.size(), axes);
  for (int a = 0; a < 3; a++) {
    if (!(axes >> a & 1)) continue;
    const CapMaker cap(frame, places, axes, a, sides);
    cap.addTo(to, false, sides.period[a]);
    cap.addTo(to, true, sides.period[a]);
  }
}

}  // namespace

CutSides closeCutSides(SurfaceFrame& frame, const CutComponents& cuts, const PeriodicSides& sides) {
  CutSides out;
  if (cuts.empty()) return out;
  Additions add;
  out.axes.assign(frame.positions.size(), 0);
  for (const ComponentRows& c : rowsByComponent(frame)) {
    const auto cut = cuts.find(c.component);
    if (cut == cuts.end()) continue;
    for (const std::uint32_t i : c.rows) out.axes[i] = cut->second;
    addComponent(frame, c, cut->second, sides, add);
  }
  std::vector<std::uint32_t> rows(frame.positions.size());
  for (std::uint32_t i = 0; i < rows.size(); i++) rows[i] = i;
  std::size_t row = rows.size();
  for (const Place& p : add.images) rows.push_back(p.row);
  for (const CapCorner& c : add.corners) rows.push_back(c.nearest);
  frame = rowsOf(frame, rows);
  out.axes.insert(out.axes.end(), add.imageAxes.begin(), add.imageAxes.end());
  for (const Place& p : add.images) frame.positions[row++] = p.at;
  const auto first = static_cast<std::uint32_t>(row);
  for (const CapCorner& c : add.corners) {
    frame.positions[row] = c.at;
    frame.normals[row] = c.normal;
    frame.radii[row] = c.radius;
    frame.components[row++] = capComponent;
  }
  out.axes.resize(rows.size(), 0);
  for (const auto& [a, b, c] : add.faces) out.faces.push_back({first + a, first + b, first + c});
  return out;
}

}  // namespace thaw
