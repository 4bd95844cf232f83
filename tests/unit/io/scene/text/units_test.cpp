// SPDX-License-Identifier: Apache-2.0
#include "io/scene/text/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace thaw {
namespace {

using std::numbers::pi;

TEST(Units, KnownUnitsHaveTheirValues) {
  const struct {
    const char* text;
    double value;
    const char* unit;
  } table[] = {{"2 mm", 0.002, "m"},
               {"15 cm", 0.15, "m"},
               {"7 cm", 0.07, "m"},
               {"2.25 in", 0.05715, "m"},
               {"1e-3 km", 1, "m"},
               {"40 ms", 0.04, "s"},
               {"10 min", 600, "s"},
               {"2 h", 7200, "s"},
               {"3 us", 3e-6, "s"},
               {"56 degC", 329.15, "K"},
               {"0 \xc2\xb0"
                "C",
                273.15, "K"},
               {"-10degC", 263.15, "K"},
               {"300 K", 300, "K"},
               {"5 mK", 0.005, "K"},
               {"900 kg/m^3", 900, "kg/m^3"},
               {"0.9 g/cm^3", 900, "kg/m^3"},
               {"1 t/m^3", 1000, "kg/m^3"},
               {"1 kg/l", 1000, "kg/m^3"},
               {"60 kPa", 6e4, "Pa"},
               {"1 MPa", 1e6, "Pa"},
               {"1.5 bar", 1.5e5, "Pa"},
               {"2 N/m^2", 2, "Pa"},
               {"2 Pa s", 2, "Pa s"},
               {"2 Pa*s", 2, "Pa s"},
               {"1 mPa s", 0.001, "Pa s"},
               {"1 cP", 0.001, "Pa s"},
               {"0.03 N/m", 0.03, "N/m"},
               {"72 mN/m", 0.072, "N/m"},
               {"2 kJ/kg", 2000, "J/kg"},
               {"2.1 kJ/(kg K)", 2100, "J/(kg K)"},
               {"2.1 kJ/kg/K", 2100, "J/(kg K)"},
               {"0.25 W/(m K)", 0.25, "W/(m K)"},
               {"0.25 W / (m * K)", 0.25, "W/(m K)"},
               {"10 W/m^2/K", 10, "W/(m^2 K)"},
               {"5 1/s", 5, "1/s"},
               {"5 Hz", 5, "1/s"},
               {"5 s^-1", 5, "1/s"},
               {"9.81 m/s^2", 9.81, "m/s^2"},
               {"9.81 m/s\xc2\xb2", 9.81, "m/s^2"},
               {"30 deg", pi / 6, "rad"},
               {"0.5 turn", pi, "rad"},
               {"60 rpm", 2 * pi, "rad/s"},
               {"90 deg/s", pi / 2, "rad/s"},
               {"30 %", 0.3, ""},
               {"1e-6 m^2/s", 1e-6, "m^2/s"},
               {"  +3 m ", 3, "m"},
               {"1 mm^3", 1e-9, "m^3"},
               {"4 m\xc2\xb7s", 4, "m s"},
               {"1 dam", 10, "m"},
               {"2 \xc2\xb5m", 2e-6, "m"}};
  for (const auto& t : table) {
    const Quantity q = parseQuantity(t.text);
    EXPECT_EQ(q.error, "") << t.text;
    EXPECT_DOUBLE_EQ(q.value, t.value) << t.text;
    EXPECT_EQ(q.dimension, dimensionOf(t.unit)) << t.text << " against " << t.unit;
    EXPECT_TRUE(q.hasUnit) << t.text;
  }
}

TEST(Units, DecimalFactorsGiveTheNearestDouble) {
  EXPECT_EQ(parseQuantity("7 cm").value, 0.07);  // 7 * 0.01 differs
  EXPECT_EQ(parseQuantity("1.1 mm").value, 1.1 / 1000);
  EXPECT_EQ(parseQuantity("35 ms").value, 0.035);
}

TEST(Units, BareNumbersAreInSiUnits) {
  const Quantity q = parseQuantity("2.5e3");
  EXPECT_EQ(q.error, "");
  EXPECT_FALSE(q.hasUnit);
  EXPECT_EQ(q.value, 2500);
}

TEST(Units, ErrorsNameTheProblem) {
  const struct {
    const char *text, *error;
  } table[] = {
      {"", "a number is missing"},
      {"mm", "a number is missing"},
      {"+-3 m", "a number is missing"},
      {"3 foo", "unknown unit 'foo'"},
      {"1/50", "'50' is not a unit; expected one number and one unit (expressions are not allowed here)"},
      {"3 Mm m/", "a unit is missing"},
      {"3 kmin", "unknown unit 'kmin'"},
      {"3 W/(m K", "a closing parenthesis is missing"},
      {"3 W)", "a closing parenthesis has no opening one"},
      {"3 m^", "a power must be a whole number from -9 to 9"},
      {"3 m^99", "a power must be a whole number from -9 to 9"},
      {"3 W/degC", "degC cannot be combined with other units; use K"},
      {"1e999 m", "the number is too large or too small"},
      {"3 ((((((((m))))))))", "parentheses are nested too deeply"}};
  for (const auto& t : table) EXPECT_EQ(parseQuantity(t.text).error, t.error) << t.text;
}

TEST(Units, InfinityIsNotFinite) {  // the reader of keys rejects non-finite values
  EXPECT_FALSE(std::isfinite(parseQuantity("inf m").value));
  EXPECT_FALSE(std::isfinite(parseQuantity("nan s").value));
  EXPECT_FALSE(std::isfinite(parseQuantity("1 Gm^9 Gm^9 Gm^9 Gm^9").value));
}

TEST(Units, AngularVelocityIsNoFrequency) { EXPECT_NE(dimensionOf("rad/s"), dimensionOf("1/s")); }

TEST(Units, EveryKindHasAnExampleOfItsDimension) {
  for (const char* unit :
       {"m",  "s",   "K",    "rad",     "kg/m^3",   "Pa s", "N/m",  "m/s",       "m/s^2", "rad/s",
        "Pa", "1/s", "kg/s", "W/(m K)", "J/(kg K)", "J/kg", "W/kg", "W/(m^2 K)", "m^2/s", "K/m"}) {
    const std::string text = kindOfUnit(unit);
    const std::size_t open = text.find('"'), close = text.rfind('"');
    ASSERT_LT(open, close) << text;
    const Quantity q = parseQuantity(text.substr(open + 1, close - open - 1));
    EXPECT_EQ(q.error, "") << text;
    EXPECT_EQ(q.dimension, dimensionOf(unit)) << text;
  }
}

}  // namespace
}  // namespace thaw
