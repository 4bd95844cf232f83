// SPDX-License-Identifier: Apache-2.0
// Events of bodies that a weld has left without particles, in the order of their execution.
#include "core/oriented/adaptive_sampling/welded_bodies.hpp"

#include <gtest/gtest.h>

#include <string>

namespace thaw {
namespace {

struct Bodies {
  Scene s;
  Bodies() {
    for (const char* name : {"a", "b", "c"}) s.oriented.emplace_back().name = name;
  }
  void weld(int body, int other, double time) {
    OrientedEvent e;
    e.kind = OrientedEventKind::Weld;
    e.time = time;
    e.otherIndex = other;
    s.oriented[static_cast<std::size_t>(body)].events.push_back(e);
  }
  void cut(int body, double time) {
    OrientedEvent e;
    e.time = time;
    s.oriented[static_cast<std::size_t>(body)].events.push_back(e);
  }
  /// Text such as "b.0: b in a by 0.1" for each event.
  std::string found() const {
    std::string text;
    for (const EventOfWelded& f : eventsOfWelded(s))
      text += (text.empty() ? "" : ", ") + s.oriented[f.body].name + "." + std::to_string(f.event) + ": " +
              s.oriented[f.named].name + " in " + s.oriented[f.into].name + " by " +
              std::to_string(f.weld->time).substr(0, 3);
    return text;
  }
};

TEST(WeldedBodies, AcceptsEventsBeforeTheWeldAndOfTheWhole) {
  Bodies x;
  x.weld(0, 1, 0.2);
  x.cut(1, 0.1);
  x.cut(0, 0.3);
  x.weld(0, 2, 0.3);
  EXPECT_EQ(x.found(), "");
}

TEST(WeldedBodies, FindsLaterEventsOfWeldedBodies) {
  Bodies x;
  x.weld(0, 1, 0.2);
  x.cut(1, 0.3);
  x.weld(2, 1, 0.4);
  x.weld(0, 1, 0.5);
  x.weld(1, 2, 0.6);
  EXPECT_EQ(x.found(), "b.0: b in a by 0.2, c.0: b in a by 0.2, a.1: b in a by 0.2, b.1: b in a by 0.2");
}

TEST(WeldedBodies, WholeMayBeWeldedAgain) {
  Bodies x;
  x.weld(0, 1, 0.1);
  x.weld(2, 0, 0.2);
  x.cut(1, 0.3);
  x.cut(0, 0.3);
  x.cut(2, 0.3);
  EXPECT_EQ(x.found(), "a.1: a in c by 0.2, b.0: b in c by 0.1");
}

TEST(WeldedBodies, SimultaneousEventsFollowTheOrderOfTheScene) {
  Bodies x;
  x.weld(1, 0, 0.1);  // after the event of a at that time
  x.cut(0, 0.1);
  x.cut(2, 0.1);
  EXPECT_EQ(x.found(), "");
  Bodies y;
  y.weld(0, 1, 0.1);
  y.cut(1, 0.1);
  EXPECT_EQ(y.found(), "b.0: b in a by 0.1");
}

}  // namespace
}  // namespace thaw
