// SPDX-License-Identifier: Apache-2.0
// Keys of [output] for pictures.
#include "io/scene/tables/read_sections.hpp"

namespace thaw {

namespace {

void readBackground(TableReader& r, const char* key, std::optional<std::uint32_t>& colour,
                    const char* about) {
  std::string text;
  r.text(key, text, about, "\"#rrggbb\"");
  if (text.empty()) return;
  if (std::uint32_t read = 0; readColour(text, read)) colour = read;
  else r.refuseValue(key, "expected six hexadecimal digits such as \"#202830\"");
}

void readLight(TableReader& r, PictureLight& light) {
  r.needed().vector("direction", light.direction, "", "direction from the scene to the light, of any length");
  if (r.reading() && !r.has("direction")) r.fail(r.place(), r.path() + ": needs `direction`");
  else if (!(length(light.direction) > 0)) r.refuseValue("direction", "expected a direction other than 0");
  readColourKey(r, light.colour, "colour of the light");
  r.number("strength", light.strength, "", notNegative(),
           "1: as bright as the sun of pictures without lights");
  r.number("size", light.size, "rad", between(0, 1.5),
           "angle that the light subtends: the larger, the softer its shadows. The real sun has 0.5 deg");
}

void readLights(TableReader& r, Output& o) {
  r.vector("sun", o.sun, "",
           "direction from the scene to the sun of pictures, of any length; default: over the camera's left "
           "shoulder");
  if (o.sun && !(o.sun->z > 0)) r.refuseValue("sun", "expected a direction above the horizon: z > 0");
  r.number("ambient", o.ambient, "", notNegative(), "strength of the sky's light in pictures");
  r.tables("light", "a distant light of pictures; lights replace the sun, and the first one makes highlights",
           o.lights, readLight);
  if (o.sun && !o.lights.empty()) r.fail("sun", "lights replace the sun: remove `sun` or `light`", {"light"});
}

}  // namespace

void readPicture(TableReader& r, Output& o) {
  readBackground(r, "background", o.background, "colour of the background of pictures; default: a pale sky");
  readBackground(r, "background_top", o.backgroundTop,
                 "colour of the background high above the horizon, in a gradient from `background`; default: "
                 "`background`");
  if (o.backgroundTop && !o.background) r.fail("background_top", "needs `background`", {"background"});
  readLights(r, o);
  int spray = static_cast<int>(o.spray);
  r.choice("spray", spray, {"ellipsoids", "spheres", "hide", "surfels"},  // as in Spray
           "look of drops of one and two particles in pictures of a surface: ellipsoids of their volume "
           "along their motion, spheres, hidden, or their surfels");
  o.spray = static_cast<Spray>(spray);
  std::int64_t width = o.width, height = o.height;
  r.whole("width", width, 64, 16384, "width of pictures, in pixels");
  r.whole("height", height, 64, 16384, "height of pictures, in pixels");
  o.width = static_cast<int>(width);
  o.height = static_cast<int>(height);
  r.table("camera", "camera of the pictures; without it the view is fitted to all frames",
          [&](TableReader& c) {
            if (c.reading()) o.camera.fitted = false;
            c.vector("from", o.camera.from, "m", "position of the camera");
            c.vector("at", o.camera.at, "m", "point that it looks at");
            c.number("field_of_view", o.camera.fieldOfView, "rad", between(0.01, 3), "vertical angle");
            if (!c.reading()) return;
            if (!c.has("from") || !c.has("at")) c.fail(c.place(), c.path() + ": needs `from` and `at`");
            else if (o.camera.from == o.camera.at) c.fail("at", "must differ from `from`");
          });
}

}  // namespace thaw
