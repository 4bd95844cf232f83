// SPDX-License-Identifier: Apache-2.0
#include "io/simulation/driven_obstacle.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "core/scene/tension_form.hpp"
#include "core/simulation/step_context.hpp"
#include "core/walls/wall_load.hpp"
#include "io/run/run_state.hpp"

namespace thaw {
namespace {

/// Interval (s) between the two keyframes of a move, longer than any run. It is a power of two, so scaling by
/// it is exact.
constexpr double horizon = 1048576;
/// Number of keyframes to keep. A retry repeats steps from a snapshot, and needs the motion of that time.
constexpr std::size_t mostKeyframes = 4096;

std::size_t wallNamed(const Walls& walls, const std::string& name) {
  std::string names;
  for (std::size_t k = 0; k < walls.list.size(); k++) {
    if (walls.list[k].isImage()) continue;
    if (walls.list[k].properties.name == name) return k;
    names += (names.empty() ? "'" : ", '") + walls.list[k].properties.name + "'";
  }
  throw std::invalid_argument("unknown obstacle '" + name + "'; the scene has " +
                              (names.empty() ? "none" : names));
}

/// Returns true if the wall may have periodic images. They follow the motion of the scene only.
bool mayHaveImages(const Domain& d, const Wall& wall) {
  for (int a = 0; a < 3; a++) {
    const double length = d.max[a] - d.min[a];
    if (d.side[static_cast<std::size_t>(a)][0] == Side::Periodic &&
        wall.bounds.max[a] - wall.bounds.min[a] < length * (1 - 1e-9))
      return true;
  }
  return false;
}

/// Returns true if some liquid meets walls at an angle other than 90 degrees, with any form of tension.
bool hasContactAngles(const Scene& s) {
  return std::any_of(s.materials.begin(), s.materials.end(), [&s](const Material& m) {
    return m.surfaceTension > 0 && !contactAnglesOf(s, m).empty();
  });
}

/// Throws std::invalid_argument if the scene has forces on obstacles that wallLoad() does not compute.
void requireKnownForces(const Scene& scene, const Modules& m, const std::string& name) {
  const std::pair<bool, const char*> without[] = {{m.incompressible, "the incompressible solver"},
                                                  {m.implicitViscosity, "implicit viscosity"},
                                                  {hasContactAngles(scene), "contact angles"},
                                                  {m.rigid, "rigid solids"},
                                                  {m.sheet, "sheets"},
                                                  {m.oriented, "oriented particles"},
                                                  {m.sleep || m.pieceSleep, "sleeping particles"}};
  for (const auto& [used, what] : without)
    if (used) throw std::invalid_argument(name + " cannot be driven: its load by " + what + " is unknown");
}

void requireDrivable(const Scene& scene, const Modules& modules, const Wall& wall) {
  const std::string name = "obstacle '" + wall.properties.name + "'";
  if (wall.properties.motion.empty())
    throw std::invalid_argument(name + " is static: give it a keyframe, motion = [{ time = 0 }]");
  if (mayHaveImages(scene.domain, wall))
    throw std::invalid_argument(name + " cannot be driven: it is shorter than the periodic domain");
  requireKnownForces(scene, modules, name);
}

void setMotion(Wall& wall, double time, const ObstacleMotion& m) {
  std::vector<Keyframe>& keys = wall.properties.motion;
  std::erase_if(keys, [time](const Keyframe& k) { return k.time >= time; });
  if (keys.size() > mostKeyframes) keys.erase(keys.begin(), keys.begin() + mostKeyframes / 2);
  keys.push_back({time, m.position, m.rotation});
  keys.push_back({time + horizon, m.position + m.velocity * horizon, m.rotation + m.rotationRate * horizon});
}

}  // namespace

DrivenObstacle::DrivenObstacle(Simulation& sim, const std::string& name)
    : sim_(&sim), wall_(wallNamed(sim.world().walls, name)), load_(std::make_shared<WallLoad>()) {
  requireDrivable(sim.world().scene, sim.world().modules, sim.world().walls.list[wall_]);
  sim.onPhase(HookPhase::Forces, [&run = sim.runState(), wall = wall_, load = load_] {
    const WallContext at = stepContext(run.world, run.halos(), run.tools, 0).walls;
    *load = wallLoad(at, run.tools.sums.scales.inverseLatticeSum, run.tools.walls.contacts, wall);
  });
}

void DrivenObstacle::move(const ObstacleMotion& m) {
  for (const Vec3d& v : {m.position, m.velocity, m.rotation, m.rotationRate})
    if (!isFinite(v)) throw std::invalid_argument("the motion of an obstacle must be finite");
  Wall& wall = sim_->world().walls.list[wall_];
  const double time = sim_->time();
  setMotion(wall, time, m);
  wall.pose = poseAt(wall.properties.motion, time);
}

const Pose& DrivenObstacle::pose() const { return std::as_const(*sim_).world().walls.list[wall_].pose; }

ObstacleLoad DrivenObstacle::load() const {
  const WallLoad& mine = *load_;
  constexpr int sums = 6;
  std::array<ExactSum, sums> all;
  std::array<std::int64_t, sums * ExactSum::digits> digits;
  for (std::size_t k = 0; k < sums; k++) {
    all[k] = k < 3 ? mine.force[k] : mine.torque[k - 3];
    all[k].carry();
    std::copy(all[k].digit.begin(), all[k].digit.end(),
              digits.begin() + static_cast<std::ptrdiff_t>(k * ExactSum::digits));
  }
  MPI_Allreduce(MPI_IN_PLACE, digits.data(), static_cast<int>(digits.size()), MPI_INT64_T, MPI_SUM,
                sim_->communicator());
  std::array<double, sums> value;
  for (std::size_t k = 0; k < sums; k++) {
    std::copy_n(digits.begin() + static_cast<std::ptrdiff_t>(k * ExactSum::digits), ExactSum::digits,
                all[k].digit.begin());
    value[k] = all[k].value();
  }
  return {{value[0], value[1], value[2]}, {value[3], value[4], value[5]}};
}

}  // namespace thaw
