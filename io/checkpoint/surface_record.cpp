// SPDX-License-Identifier: Apache-2.0
#include "io/checkpoint/surface_record.hpp"

#include "core/simulation/ledger/totals.hpp"

namespace thaw {
namespace {

const std::string at = "/surface", componentsAt = at + "/components", eventsAt = at + "/events";

/// Calls use(name, unit, element, pointer to member) for each member of a component.
template<class Use> void eachMember(const SurfaceComponent*, Use&& use) {
  use("id", "1", Element::U64, &SurfaceComponent::label);  // "id" as in all tables
  use("particles", "1", Element::I64, &SurfaceComponent::particles);
  use("surfels", "1", Element::I64, &SurfaceComponent::surfels);
  use("mass", "kg", Element::F64, &SurfaceComponent::mass);
  use("particle_volume", "m^3", Element::F64, &SurfaceComponent::particleVolume);
  use("volume", "m^3", Element::F64, &SurfaceComponent::volume);
  use("area", "m^2", Element::F64, &SurfaceComponent::area);
  use("centroid", "m", Element::F64, &SurfaceComponent::centroid);
  use("iso_offset", "m", Element::F64, &SurfaceComponent::isoOffset);
}
template<class Use> void eachMember(const SurfaceEvent*, Use&& use) {
  use("step", "1", Element::I64, &SurfaceEvent::step);
  use("time", "s", Element::F64, &SurfaceEvent::time);
  use("kind", "1", Element::U8, &SurfaceEvent::kind);
  use("component", "1", Element::U64, &SurfaceEvent::label);
  use("other", "1", Element::U64, &SurfaceEvent::other);
}

template<class T> struct InFile { using type = T; };
template<> struct InFile<SurfaceEventKind> { using type = std::uint8_t; };

template<class Record>
void writeRecords(H5File& file, const std::string& group, const std::vector<Record>& records) {
  file.createGroup(group);
  eachMember(static_cast<const Record*>(nullptr),
             [&]<class T>(const char* name, const char* unit, Element element, T Record::*member) {
               std::vector<typename InFile<T>::type> values;
               for (const Record& r : records)
                 values.push_back(static_cast<typename InFile<T>::type>(r.*member));
               file.writeAll(group + "/" + name, {element, values.size(), sizeof(T) == sizeof(Vec3d) ? 3 : 0},
                             values.data());
               file.setText(group + "/" + name, "units", unit);
             });
}

template<class Record>
std::vector<Record> readRecords(const H5File& file, const std::string& group, const char* counted) {
  std::vector<Record> records(file.shape(group + "/" + counted).rows);
  eachMember(static_cast<const Record*>(nullptr), [&]<class T>(const char* name, const char*, Element element,
                                                               T Record::*member) {
    const auto values = readRows<typename InFile<T>::type>(file, group + "/" + name, element);
    if (values.size() != records.size())
      throw IoError(file.path(), "is damaged: " + group + "/" + name + " has an unexpected number of rows");
    for (std::size_t k = 0; k < records.size(); k++) records[k].*member = static_cast<T>(values[k]);
  });
  return records;
}

}  // namespace

SurfaceRecord surfaceRecordOf(const Surface& s) {
  return {s.surfels.id.active, s.lastStep, s.counters, s.components, s.events};
}

void restoreSurfaceRecord(const SurfaceRecord& record, Surface& s) {
  s.lastStep = record.lastStep;
  s.counters = record.counters;
  s.components = record.components;
  s.events = record.events;
}

void writeSurfaceRecord(H5File& file, const SurfaceRecord& record) {
  file.setInteger(at, "last_step", record.lastStep);
  file.createGroup(at + "/counters");
  SurfaceCounters counters = record.counters;
  for (const NamedCount& c : countsOf(counters)) file.setInteger(at + "/counters", c.name, *c.count);
  writeRecords(file, componentsAt, record.components);
  writeRecords(file, eventsAt, record.events);
  std::vector<std::uint64_t> number;  // rows of a table need an id
  for (std::size_t k = 0; k < record.events.size(); k++) number.push_back(k + 1);
  file.writeAll(eventsAt + "/id", {Element::U64, number.size(), 0}, number.data());
  file.setText(eventsAt + "/id", "units", "1");
}

SurfaceRecord readSurfaceRecord(const H5File& file) {
  SurfaceRecord record;
  record.there = true;
  record.lastStep = file.integer(at, "last_step");
  for (const NamedCount& c : countsOf(record.counters))
    if (file.hasAttribute(at + "/counters", c.name)) *c.count = file.integer(at + "/counters", c.name);
  record.components = readRecords<SurfaceComponent>(file, componentsAt, "id");
  record.events = readRecords<SurfaceEvent>(file, eventsAt, "step");
  return record;
}

}  // namespace thaw
