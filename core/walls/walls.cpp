#include "core/walls/walls.hpp"

#include <cmath>
#include <limits>

namespace thaw {
namespace {

Mat3d rotation(const Vec3d& r) {  // about x, then y, then z
  const double cx = std::cos(r.x), sx = std::sin(r.x), cy = std::cos(r.y), sy = std::sin(r.y), cz = std::cos(r.z), sz = std::sin(r.z);
  const Mat3d X{{{1, 0, 0}, {0, cx, -sx}, {0, sx, cx}}}, Y{{{cy, 0, sy}, {0, 1, 0}, {-sy, 0, cy}}}, Z{{{cz, -sz, 0}, {sz, cz, 0}, {0, 0, 1}}};
  return Z * (Y * X);
}

struct Pose { Vec3d move, rotate; };

Pose poseAt(const std::vector<Keyframe>& keys, double time, Pose* rate) {
  *rate = {};
  if (keys.empty()) return {};
  if (time <= keys.front().time) return {keys.front().move, keys.front().rotate};
  for (std::size_t k = 1; k < keys.size(); k++) {
    if (time >= keys[k].time) continue;
    const Keyframe &a = keys[k - 1], &b = keys[k];
    const double span = b.time - a.time, t = (time - a.time) / span;
    *rate = {(b.move - a.move) / span, (b.rotate - a.rotate) / span};
    return {a.move + (b.move - a.move) * t, a.rotate + (b.rotate - a.rotate) * t};
  }
  return {keys.back().move, keys.back().rotate};
}

/// The plane of a side of the domain.
class SidePlane : public SignedDistance {
 public:
  SidePlane(int axis, double place, double sign) : axis_(axis), place_(place), sign_(sign) {}
  double distance(const Vec3d& x, Vec3d* gradient) const override {
    if (gradient) {
      *gradient = {};
      (*gradient)[axis_] = sign_;
    }
    return sign_ * (x[axis_] - place_);
  }
  Bounds bounds() const override {
    const double inf = std::numeric_limits<double>::infinity();
    return {{-inf, -inf, -inf}, {inf, inf, inf}};
  }

 private:
  int axis_;
  double place_, sign_;
};

}  // namespace

void addDomainWalls(const Domain& d, Walls& walls) {
  for (int a = 0; a < 3; a++)
    for (int high = 0; high < 2; high++) {
      if (d.side[static_cast<std::size_t>(a)][static_cast<std::size_t>(high)] != Side::Wall) continue;
      Wall w;
      w.shape = std::make_shared<SidePlane>(a, high ? d.max[a] : d.min[a], high ? -1 : 1);
      w.bounds = w.shape->bounds();
      w.properties.name = std::string("domain ") + static_cast<char>('x' + a) + (high ? " high" : " low");
      walls.list.push_back(std::move(w));
    }
}

void moveWalls(Walls& walls, double time) {
  for (Wall& w : walls.list) {
    w.present = time < w.properties.until;
    if (w.properties.motion.empty()) continue;
    Pose rate;
    const Pose pose = poseAt(w.properties.motion, time, &rate);
    w.move = pose.move;
    w.turn = rotation(pose.rotate);
    w.velocity = rate.move;
    // The angular velocity of angles about x, y, z in turn: each axis is turned by the rotations after it.
    const Mat3d zOnly = rotation({0, 0, pose.rotate.z}), yz = rotation({0, pose.rotate.y, pose.rotate.z});
    w.angularVelocity = yz * Vec3d{rate.rotate.x, 0, 0} + zOnly * Vec3d{0, rate.rotate.y, 0} + Vec3d{0, 0, rate.rotate.z};
  }
}

Vec3d wallVelocity(const Wall& w, const Vec3d& x) { return w.velocity + cross(w.angularVelocity, x - w.move); }

}  // namespace thaw
