// SPDX-License-Identifier: Apache-2.0
#include "tests/stability/random_themes.hpp"

#include <algorithm>
#include <vector>

namespace thaw::test {
namespace {

/// Appends lines of keys.
struct Keys {
  std::string& text;
  void operator()(const char* key, double value) { text += fmt::format("{} = {:.6g}\n", key, value); }
};

std::string placed(Dice& d, double x, double y, double z) {
  return fmt::format("place = {{ move = {}, rotate_x = {:.4g}, rotate_y = {:.4g} }}\n", vec(x, y, z),
                     d.between(0, 3), d.between(0, 3));
}

std::string headOf(std::uint64_t seed, const Scale& c, const std::string& domain,
                   const std::string& numerics) {
  return fmt::format(
             "title = \"random scene {}\"\nspacing = {:.6g}\nend = {:.6g}\nseed = {}\n\n{}\n[output]\nevery "
             "= {:.6g}\nfields = [\"velocity\", \"temperature\", \"liquid\"]\n\n[numerics]\n",
             seed, c.spacing, 20 * c.radius / c.speed, seed, domain, 4 * c.radius / c.speed) +
         numerics + "\n";
}

/// A box around the origin with a floor at z = 0.
std::string binOf(Dice& d, double wide, double high) {
  const char* side = d.of({"wall", "wall", "open", "periodic"});
  return fmt::format(
      "[domain]\nmin = {}\nmax = {}\nambient = {:.6g}\nsides = {{ x = \"{}\", y = \"{}\", z = [\"wall\", "
      "\"open\"] }}\n",
      vec(-wide, -wide, 0), vec(wide, wide, high), d.between(250, 400), side, side);
}

/// Melting and heat of a material. Returns its melting temperature (K).
double meltingOf(Dice& d, std::string& text) {
  Keys add{text};
  const double melting = d.between(300, 1200);
  add("conductivity", d.decades(0.1, 1e3));
  add("heat_capacity", d.between(400, 4000));
  if (d.chance(0.3)) text += fmt::format("melts = {:.6g}\n", melting);
  else text += fmt::format("melts = [{:.6g}, {:.6g}]\n", melting - d.between(0.1, 30), melting);
  if (d.chance(0.7)) add("latent_heat", d.decades(1e2, 3e5));
  if (d.chance(0.5)) add("hysteresis", d.between(0, 0.45));
  if (d.chance(0.3)) add("surface_tension", d.decades(1e-3, 0.5));
  return melting;
}

struct RigidMaterial {
  std::string text;
  double melting = 0;  ///< K; 0: it does not melt
};

RigidMaterial rigidMaterial(Dice& d, int number, double speed) {
  RigidMaterial m;
  m.text = fmt::format("[material.r{}]\nlaw = \"rigid\"\n", number);
  Keys add{m.text};
  const double density = d.decades(100, 8000);
  const bool melts = d.chance(0.6);
  if (melts && d.chance(0.3))
    m.text += fmt::format("density = {{ solid = {:.6g}, liquid = {:.6g} }}\n", density,
                          density * d.between(0.85, 1.15));
  else add("density", density);
  if (melts) m.melting = meltingOf(d, m.text), add("viscosity", d.decades(1e-2, 100));
  if (melts && d.chance(0.3)) {
    add("weld_temperature", m.melting - d.between(40, 60));
    if (d.chance(0.5)) add("weld_time", speed / 9.81 * d.decades(1e-3, 1));
  }
  if (d.chance(0.3)) {
    add("young", d.decades(1e6, 1e10));
    add("strength", density * speed * speed * d.decades(1, 1e3));
  }
  if (d.chance(0.7)) add("friction", d.between(0, 1));
  if (d.chance(0.7)) add("restitution", d.unit());
  if (d.chance(0.4)) add("rolling_friction", d.decades(1e-4, 1e-2));
  return m;
}

std::string rigidNumerics(Dice& d, double speed, double radius, bool soft) {
  std::string t = "overlap = \"remove later\"\n";
  if (!soft && d.chance(0.5))
    t += fmt::format("sleep_speed = {:.4g}\nsleep_after = {:.4g}\n", speed * d.decades(1e-3, 0.1),
                     radius / speed * d.decades(1e-2, 0.3));
  else if (d.chance(0.2)) t += "pressure_solver = \"incompressible\"\n";
  if (d.chance(0.3)) t += fmt::format("max_step = {:.4g}\n", radius / speed * d.decades(1e-3, 1e-1));
  return t;
}

/// Liquid of another material in the lower part of the bin.
std::string pool(Dice& d, double wide, double deep) {
  return fmt::format(
      "[material.liquid]\ndensity = {:.6g}\nviscosity = {:.6g}\n\n[[body]]\nname = \"pool\"\nmaterial = "
      "\"liquid\"\nbox = {{ size = {} }}\nplace = {{ move = {} }}\n\n",
      d.decades(300, 3000), d.decades(1e-3, 10), vec(2 * wide, 2 * wide, deep), vec(0, 0, 0.5 * deep));
}

std::string softBody(Dice& d, double radius, double z, double speed) {
  const double density = d.decades(300, 3000);
  return fmt::format(
             "[material.soft]\ndensity = {:.6g}\nyoung = {:.6g}\npoisson = {:.3g}\ndamping = "
             "{:.4g}\n\n[[body]]\nname = \"soft\"\nmaterial = \"soft\"\n{}\n",
             density, density * speed * speed * d.decades(3, 300), d.between(0, 0.45), d.decades(0.1, 100),
             shape(d, radius).text) +
         placed(d, 0, 0, z) + "\n";
}

/// A jet of melt that freezes on cold pieces.
std::string jet(Dice& d, double melting, const Scale& c, double high) {
  return fmt::format(
      "[[emitter]]\nmaterial = \"r0\"\ndisc = {{ radius = {:.6g} }}\ncentre = {}\nspeed = "
      "{:.6g}\ntemperature = {:.6g}\nend = {:.6g}\n\n",
      c.spacing * d.between(1, 3), vec(0.5 * c.radius, 0, high - 2 * c.spacing), c.speed * d.between(0.2, 1),
      melting + d.between(1, 60), d.between(0.5, 3) * c.radius / c.speed);
}

/// An obstacle above the bodies, which moves down through them and turns.
std::string stirrer(Dice& d, double temperature, double radius, double high) {
  std::string t = "[[obstacle]]\nname = \"stirrer\"\n" + shape(d, 0.6 * radius).text + "\n";
  t += fmt::format("place = {{ move = {} }}\n", vec(0, 0, high - 0.6 * radius));
  t += fmt::format("motion = [{{ time = 0 }}, {{ time = {:.6g}, move = {}, rotate = {} }}]\n",
                   std::sqrt(radius / 9.81) * d.between(5, 15),
                   vec(0.5 * radius, 0, (0.7 * radius - high) * d.unit()), vec(0, 0, d.between(-0.5, 0.5)));
  if (temperature > 0) t += fmt::format("temperature = {:.6g}\n", temperature * d.between(0.7, 1.6));
  return t + "\n";
}

std::string liquidLaw(Dice& d) {
  const char* law = d.of({"bingham", "herschel_bulkley", "power_law", "carreau"});
  std::string t = fmt::format("\n[material.melt.flow]\nlaw = \"{}\"\nviscosity = {:.6g}\n", law,
                              d.decades(1e-2, 100));
  Keys add{t};
  const std::string name = law;
  if (name == "bingham" || name == "herschel_bulkley") add("yield_stress", d.decades(0.1, 300));
  if (name != "bingham") add("exponent", d.between(0.4, 1.6));
  if (name == "carreau") add("relaxation_time", d.decades(1e-3, 1));
  if (d.chance(0.3)) add("largest_viscosity", d.decades(100, 1e4));
  return t;
}

/// A material that melts, with the effects of heat.
std::string meltMaterial(Dice& d, double& melting) {
  std::string t = "[material.melt]\n";
  Keys add{t};
  if (d.chance(0.5)) t += "law = \"rigid\"\n";
  else add("young", d.decades(1e4, 1e6));
  const double density = d.decades(500, 5000);
  add("density", density);
  melting = meltingOf(d, t);
  if (d.chance(0.4)) add("expansion", d.decades(1e-5, 1e-2));
  if (d.chance(0.3)) add("emissivity", d.unit());
  if (d.chance(0.3)) add("convection", d.decades(1, 1e4));
  if (d.chance(0.5)) add("absorptivity", d.unit());
  if (d.chance(0.3)) add("contact_conductance", d.decades(1, 1e5));
  if (d.chance(0.3)) add("mush_drag", d.decades(1e2, 1e7));
  if (d.chance(0.3)) {
    t += fmt::format("evaporation = [[{:.6g}, 0], [{:.6g}, {:.6g}]]\n", melting, melting * d.between(1.1, 2),
                     d.decades(1e-3, 1));
    add("evaporation_heat", d.decades(1e3, 3e6));
  }
  if (t.find("surface_tension") != std::string::npos && d.chance(0.5))
    add("contact_angle", d.between(0.2, 2.6));
  if (d.chance(0.3)) t += liquidLaw(d);
  else add("viscosity", d.decades(1e-3, 10));
  return t + "\n";
}

std::string sourceOf(Dice& d, double power, double radius, double high) {
  const std::string switched = d.chance(0.3) ? fmt::format("end = {:.4g}\n", d.decades(1e-2, 1)) : "";
  const std::string above = vec(d.between(-radius, radius), d.between(-radius, radius), 0.9 * high);
  switch (d.below(4)) {
    case 0: return fmt::format("[[lamp]]\nposition = {}\npower = {:.6g}\n{}\n", above, power, switched);
    case 1:
      return fmt::format("[[lamp]]\nkind = \"direction\"\nirradiance = {:.6g}\ndirection = {}\n{}\n",
                         power / (radius * radius), vec(d.between(-1, 1), d.between(-1, 1), -1), switched);
    case 2:
      return fmt::format(
          "[[laser]]\nposition = {}\npower = {:.6g}\nradius = {:.6g}\nabsorption_depth = {:.6g}\nmotion = "
          "[{{ time = 0 }}, {{ time = {:.4g}, move = {} }}]\n{}\n",
          above, power, radius * d.between(0.1, 0.5), d.chance(0.5) ? 0 : 0.2 * radius, d.decades(0.1, 3),
          vec(radius, 0, 0), switched);
    default:
      return fmt::format("[[heated_region]]\n{}\n{}power = {:.6g}\n{}\n", shape(d, radius).text,
                         placed(d, 0, 0, 0.5 * radius), power, switched);
  }
}

}  // namespace

std::string rigidScene(Dice& d, std::uint64_t seed) {
  const int bodies = 2 + d.below(7), kinds = 1 + d.below(2);
  const double radius = d.decades(0.02, 0.5), speed = std::sqrt(9.81 * radius) * d.decades(0.3, 3);
  const double wide = radius * d.between(2.2, 4), deep = d.chance(0.35) ? radius * d.between(0.5, 1.5) : 0;
  const double each = 2 * radius * radius * radius, volume = bodies * each + 4 * wide * wide * deep;
  const Scale c{radius, std::cbrt(volume / d.decades(300, 3000)), speed};
  const double pitch = 2.1 * radius, high = deep + pitch * bodies + 6 * radius;
  const bool soft = d.chance(0.3);
  std::string t = headOf(seed, c, binOf(d, wide, high), rigidNumerics(d, speed, radius, soft));
  std::vector<RigidMaterial> materials;
  for (int k = 0; k < kinds; k++)
    materials.push_back(rigidMaterial(d, k, speed)), t += materials.back().text + "\n";
  for (int b = 0; b < bodies; b++) {
    const int k = d.below(kinds);
    const double melting = materials[static_cast<std::size_t>(k)].melting, shake = 0.6 * (wide - radius);
    const double x = d.between(-shake, shake), y = d.between(-shake, shake), z = deep + (b + 1.1) * pitch;
    t += fmt::format("[[body]]\nname = \"b{}\"\nmaterial = \"r{}\"\n{}\n", b, k, shape(d, radius).text);
    t += placed(d, x, y, z);
    if (melting > 0) t += fmt::format("temperature = {:.6g}\n", melting + d.between(-60, 20));
    if (d.chance(0.5)) t += fmt::format("velocity = {}\n", vec(0, 0, -speed * d.unit()));
    if (d.chance(0.4))
      t += fmt::format("spin = {}\n", vec(0, speed / radius * d.unit(), speed / radius * d.unit()));
    if (d.chance(0.1))
      t += fmt::format("clamp = [{{ sphere = {{ radius = {:.6g} }}, place = {{ move = {} }} }}]\n",
                       0.4 * radius, vec(x, y, z));
    t += "\n";
  }
  if (deep > 0) t += pool(d, wide, deep);
  if (soft) t += softBody(d, radius, high - 3 * radius, speed);
  if (d.chance(0.5)) t += stirrer(d, materials[0].melting, radius, high);
  else if (materials[0].melting > 0 && d.chance(0.4)) t += jet(d, materials[0].melting, c, high);
  return t;
}

std::string heatedScene(Dice& d, std::uint64_t seed) {
  const double radius = d.decades(5e-3, 0.2), speed = std::sqrt(9.81 * radius);
  const double wide = radius * d.between(1.2, 2), deep = radius * d.between(0.4, 1.2), high = 5 * radius;
  const double volume = 2 * radius * radius * radius + 4 * wide * wide * deep;
  const Scale c{radius, std::cbrt(volume / d.decades(300, 3000)), speed};
  std::string numerics = "overlap = \"remove later\"\n";
  if (d.chance(0.3)) numerics += "viscosity_solver = \"implicit\"\n";
  std::string t = headOf(seed, c, binOf(d, wide, high), numerics);
  double melting = 0;
  t += meltMaterial(d, melting);
  const bool wet = d.chance(0.8);
  if (wet)
    t += fmt::format(
        "[[body]]\nname = \"pool\"\nmaterial = \"melt\"\nbox = {{ size = {} }}\nplace = {{ move = {} "
        "}}\ntemperature = {:.6g}\n\n",
        vec(2 * wide, 2 * wide, deep), vec(0, 0, 0.5 * deep), melting + d.between(-20, 300));
  t += fmt::format("[[body]]\nname = \"block\"\nmaterial = \"melt\"\n{}\n", shape(d, radius).text) +
       placed(d, 0, 0, (wet ? deep : 0) + 1.1 * radius) +
       fmt::format("temperature = {:.6g}\n\n", melting + d.between(-100, 30));
  const double power = radius * radius * d.decades(1e3, 1e7);
  for (int k = 0; k <= d.below(2); k++) t += sourceOf(d, power, radius, high);
  if (d.chance(0.4)) t += stirrer(d, melting, radius, high);
  return t;
}

}  // namespace thaw::test
