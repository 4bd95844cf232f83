// SPDX-License-Identifier: Apache-2.0
// Declaration of the keys of a table in a scene file. Terms of the model declare them
// (core/terms/model_part.hpp). io/scene uses one declaration to read, document, check and record keys.
#pragma once
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include "core/math/vec3.hpp"
#include "core/scene/flow_law.hpp"
#include "core/scene/motion.hpp"
#include "core/scene/shape.hpp"

namespace thaw {

/// Range of a key. NaN is never in the range. Infinity is only allowed as the word "never".
struct Range {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool openLow = false, openHigh = false;  ///< the end is excluded
  bool orNever = false;                    ///< the word "never" is allowed
  bool orOff = false;                      ///< the word "off" is allowed, and means 0
};
inline Range anyNumber() { return {}; }
inline Range positive() { return {0, std::numeric_limits<double>::infinity(), true, false, false}; }
inline Range notNegative() { return {0, std::numeric_limits<double>::infinity(), false, false, false}; }
inline Range atLeast(double low) {
  return {low, std::numeric_limits<double>::infinity(), false, false, false};
}
inline Range between(double low, double high) { return {low, high, false, false, false}; }
inline Range inside(double low, double high) { return {low, high, true, true, false}; }
/// Range of the factors of step limits.
inline Range stepFactor() { return {0, 2, true, false, false}; }
inline Range orNever(Range r) { return r.orNever = true, r; }
inline Range orOff(Range r) { return r.orOff = true, r; }

/// Effect of a change of a key between a checkpoint and the run that resumes from it.
enum class Restart {
  State,        ///< refused: particles, frames or the ledger depend on it
  Coefficient,  ///< reported: forces and energies jump
  Setting,      ///< reported: forces and energies stay as they are
  Start,        ///< reported as without effect: it sets only how a run begins
  Free          ///< not recorded
};

struct Blend;

/// Liquid value if only one quantity is given: the same, or unchanged.
enum class LiquidValue { Same, Unchanged };

/// A value for solid and liquid: one quantity, or { solid = ..., liquid = ... }.
struct BlendKey {
  const char *key, *unit;
  Range range;
  LiquidValue liquid;
  const char* about;
};

/// A quantity with a range.
struct QuantityKey {
  const char *key, *unit;
  Range range;
  const char* about;
};

/// The keys of a table. Each function for a key reads its value from the scene. If the scene lacks the key,
/// the value is unchanged, and is documented as the default.
class KeyTable {
 public:
  virtual ~KeyTable() = default;
  virtual bool reading() const = 0;    ///< the table is from a scene, and its checks apply
  virtual bool recording() const = 0;  ///< the values of a scene are recorded, for a restart
  virtual bool has(const char* key) const = 0;
  virtual bool refused(const char* key) const = 0;        ///< the key has an error
  virtual std::string textOf(const char* key) const = 0;  ///< text value in the scene, or ""
  /// Adds an error at a key, unless the key or one of `others`, on which the check depends, was already
  /// refused.
  virtual void fail(const char* key, const std::string& text,
                    std::initializer_list<const char*> others = {}) = 0;
  /// Sets the effect of changes at a restart for all later keys.
  virtual void restart(Restart effect) = 0;
  virtual KeyTable& as(Restart effect) = 0;  ///< sets the effect for the next key only
  /// Describes the default of the next key in words.
  virtual KeyTable& defaultAs(const char* words) = 0;
  virtual KeyTable& byScene() = 0;  ///< the next key's default follows from the scene
  virtual KeyTable& needed() = 0;   ///< the next key has no default; the caller adds an error if it is
                                    ///< missing
  virtual void number(const char* key, double& value, const char* unit, const Range& range,
                      const char* about) = 0;
  virtual void whole(const char* key, std::int64_t& value, std::int64_t low, std::int64_t high,
                     const char* about) = 0;
  virtual void flag(const char* key, bool& value, const char* about) = 0;
  virtual void blend(const BlendKey& key, Blend& value) = 0;
  /// A number, or a table of numbers by temperature.
  virtual void byTemperature(const char* key, double& value, TemperatureTable& table, const char* unit,
                             const Range& range, const char* about) = 0;
  /// A value for solid and liquid, or a table of numbers > 0 by temperature.
  virtual void byTemperature(const BlendKey& key, Blend& value, TemperatureTable& table) = 0;
  /// The same for a quantity without default. A number becomes a table with one entry.
  virtual void byTemperature(const QuantityKey& key, TemperatureTable& table) = 0;
  virtual void vector(const char* key, Vec3d& value, const char* unit, const char* about) = 0;
  /// One of several words. The value is its index in `words`.
  virtual void choice(const char* key, int& value, const std::vector<std::string>& words,
                      const char* about) = 0;
  template<class Enum>
  void choice(const char* key, Enum& value, const std::vector<std::string>& words, const char* about) {
    int number = static_cast<int>(value);
    choice(key, number, words, about);
    value = static_cast<Enum>(number);
  }
  /// A table within this one. Its keys are recorded only if `there` is true.
  virtual void table(const char* key, const char* about, bool there,
                     const std::function<void(KeyTable&)>& read) = 0;
  /// The key `name`. The default name is the title of the table with the element's number.
  virtual void name(std::string& value) = 0;
  /// The keys of a shape and its `place`.
  virtual void shape(Shape& value) = 0;
  /// The keyframes `motion`.
  virtual void motion(std::vector<Keyframe>& value, const char* about) = 0;
  /// The key `material`. Its value is an index into Scene::materials, set after all tables are read; -1: all.
  virtual void material(int& value, const char* about) = 0;
};

/// Adds an error if a scene lacks the key.
inline void requireKey(KeyTable& keys, const char* key) {
  if (keys.reading() && !keys.has(key)) keys.fail(key, "is missing");
}

}  // namespace thaw
