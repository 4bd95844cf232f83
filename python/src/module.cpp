// SPDX-License-Identifier: Apache-2.0
// The compiled part of the Python package: simulations and checked scenes. python/thaw/simulation.py is its
// only caller.
#include <mpi.h>
#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "core/geometry/basic/shape_error.hpp"
#include "io/commands/check.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/scene/read_scene.hpp"
#include "python/src/obstacle.hpp"
#include "python/src/python_simulation.hpp"
#include "python/src/register_functions.hpp"
#include "python/src/surface_file.hpp"

namespace py = pybind11;

namespace thaw::python {
namespace {

/// Starts MPI for programs that have not done so (mpi4py does), and ends it with the interpreter.
void startMpi() {
  int done = 0;
  MPI_Initialized(&done);
  if (done) return;
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  py::module_::import("atexit").attr("register")(py::cpp_function([] {
    int ended = 0;
    MPI_Finalized(&ended);
    if (!ended) MPI_Finalize();
  }));
}

/// Sets the Python error of a class of thaw.errors.
void raise(const char* name, const std::exception& e) {
  PyErr_SetString(py::object(py::module_::import("thaw.errors").attr(name)).ptr(), e.what());
}

/// An IoError's text begins with its path and a colon.
void raiseFileError(const IoError& e) {
  const std::string text = e.what();
  const std::size_t colon = text.find(": ");
  const py::object type = py::module_::import("thaw.errors").attr("FileError");
  const py::object value = colon == std::string::npos ? type("", text)
                                                      : type(text.substr(0, colon), text.substr(colon + 2));
  PyErr_SetObject(type.ptr(), value.ptr());
}

void defineSimulation(py::module_& m) {
  py::class_<ArrayGuard>(m, "ArrayGuard");
  py::class_<LoadRows>(m, "LoadRows")
      .def("view", &LoadRows::view)
      .def("rows", &LoadRows::rows)
      .def("fields", &LoadRows::fields);
  py::class_<PythonSimulation>(m, "Simulation")
      .def(py::init<const std::string&, const Options&, const py::object&, std::optional<int>>())
      .def("step", &PythonSimulation::step)
      .def("run", &PythonSimulation::run, py::arg("until"), py::arg("steps"), py::arg("progress"))
      .def("finish", &PythonSimulation::finish)
      .def("resume", &PythonSimulation::resume)
      .def("request_stop", &PythonSimulation::requestStop)
      .def_property_readonly("stop_reason", &PythonSimulation::stopReason)
      .def_property_readonly("stopped", &PythonSimulation::stopped)
      .def_property_readonly("time", &PythonSimulation::time)
      .def_property_readonly("end", &PythonSimulation::end)
      .def_property_readonly("last_step", &PythonSimulation::lastStep)
      .def_property_readonly("steps", &PythonSimulation::steps)
      .def_property_readonly("rank", &PythonSimulation::rank)
      .def_property_readonly("ranks", &PythonSimulation::ranks)
      .def_property_readonly("warnings", &PythonSimulation::warnings)
      .def("ledger", &PythonSimulation::ledger)
      .def("tables", &PythonSimulation::tables)
      .def("rows", &PythonSimulation::rows)
      .def("fields", &PythonSimulation::fields)
      .def("view", &PythonSimulation::view, py::arg("table"), py::arg("field"), py::arg("writable"))
      .def("gather", &PythonSimulation::gather, py::arg("table"), py::arg("field"))
      .def("arrays", &PythonSimulation::arrays)
      .def("history", &PythonSimulation::history)
      .def("begin_block", &PythonSimulation::beginBlock, py::arg("table"), py::arg("edit"))
      .def("end_block", &PythonSimulation::endBlock, py::arg("edit"))
      .def("refuse_close", &PythonSimulation::refuseClose)
      .def("restore", &PythonSimulation::restore)
      .def("write_frame", &PythonSimulation::writeFrame)
      .def("write_checkpoint", &PythonSimulation::writeCheckpoint)
      .def("on_step", &PythonSimulation::onStep)
      .def("on_frame", &PythonSimulation::onFrame)
      .def("on_phase", &PythonSimulation::onPhase, py::arg("phase"), py::arg("call"))
      .def("on_end", &PythonSimulation::onEnd)
      .def("add_load", &PythonSimulation::addLoad);
}

/// Not collective: each rank checks by itself.
std::string checkOf(const std::string& path, const std::vector<std::string>& overrides, int ranks) {
  ProgramCalls calls;
  std::string report;
  {
    const CallScope scope(calls);
    const py::gil_scoped_release others;
    CheckOptions o;
    o.scene = path;
    o.overrides = overrides;
    o.ranks = ranks;
    report = checkJson(o, MPI_COMM_SELF);
  }
  if (calls.failed) throwFailure(calls, {});
  return report;
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  m.doc() = "Compiled part of the package thaw.";
  startMpi();
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const BlewUp& e) { raise("BlewUp", e); } catch (const SceneErrors& e) {
      raise("SceneError", e);
    } catch (const ShapeError& e) { raise("SceneError", e); } catch (const IoError& e) {
      raiseFileError(e);
    }
  });
  defineSimulation(m);
  defineObstacle(m);
  m.def(
      "register_extension",
      [](const std::string& name, const std::string& about, const std::vector<KeyNote>& keys,
         const std::vector<AddedField>& fields, const py::object& load, const py::object& update,
         const py::object& stepLimit, bool heats) {
        registerFunctions(name, about, keys, fields, {load, update, stepLimit, heats});
      },
      py::arg("name"), py::arg("about"), py::arg("keys"), py::arg("fields"), py::arg("load"),
      py::arg("update"), py::arg("step_limit"), py::arg("heats"));
  m.def(
      "write_surface_file",
      [](const std::string& frame, const std::string& file, double cell) {
        const py::gil_scoped_release others;
        writeSurfaceFile(frame, file, cell);
      },
      py::arg("frame"), py::arg("file"), py::arg("cell"), "Writes the meshes of a frame of surfels as PLY.");
  m.def("check", &checkOf, py::arg("path"), py::arg("overrides"), py::arg("ranks"),
        "The report of `thaw check --json` on a file, as JSON.");
  m.def(
      "abort", [] { MPI_Abort(MPI_COMM_WORLD, 1); }, "Ends all ranks at once.");
  m.def("documentation", &sceneDocumentation, "The key table of scene files, as Markdown.");
  m.def("schema", &sceneSchema, "The JSON schema of scene files.");
  m.def("example", &exampleScene, "A small complete scene, as TOML.");
}

}  // namespace thaw::python
