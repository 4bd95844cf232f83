// The command line of thaw.
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "io/commands/check.hpp"
#include "io/commands/compare_command.hpp"
#include "io/commands/export.hpp"
#include "io/commands/info_command.hpp"
#include "io/commands/render.hpp"
#include "io/commands/run.hpp"
#include "io/commands/scene_for_all.hpp"
#include "io/hdf5/parallel_file.hpp"
#include "io/scene/read_scene.hpp"
#include "io/version.hpp"
#include "parallel/communicator.hpp"

namespace {

/// Says once, not once a rank, what is wrong with the command line: all ranks see the same one. MPI's end
/// keeps another rank from ending the job before the first has said it.
void sayOnce(CLI::App& app, const CLI::ParseError& e, int* argc, char*** argv) {
  thaw::MpiSession mpi(argc, argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) app.exit(e);
}

/// The arguments but the program's name, from the last to the first, as CLI11 takes them. It takes -.5 for an
/// option: with a zero before the point it is a number.
std::vector<std::string> reversedArguments(int argc, char** argv) {
  std::vector<std::string> all;
  for (int a = argc; a-- > 1;) {
    const std::string text = argv[a];
    const bool bare = text.size() > 2 && text[0] == '-' && text[1] == '.' && text[2] >= '0' && text[2] <= '9';
    all.push_back(bare ? "-0" + text.substr(1) : text);
  }
  return all;
}

/// CLI11 would only say that a command is missing.
void checkCommand(const CLI::App& app, const std::string& given) {
  std::string names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == given) return;
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  throw CLI::ValidationError(given, "there is no such command; expected one of " + names);
}

/// What other commands take as --ranks: CLI11 would only say that it was not expected.
void checkRanks(int argc, char** argv) {
  const std::string command = argv[1];
  if (command != "run" && command != "relax") return;
  for (int a = 2; a < argc; a++)
    if (const std::string text = argv[a]; text.rfind("--ranks", 0) == 0 || text == "-n" || text == "-np")
      throw CLI::ValidationError(text, "ranks are started by mpirun: mpirun -n 4 thaw " + command + " SCENE");
}

/// CLI11 would take a key=value without its --set for the scene.
void checkSettings(int argc, char** argv) {
  for (int a = 2; a < argc; a++) {
    const std::string text = argv[a], before = argv[a - 1];
    const std::size_t equals = text.find('=');
    const bool setting = equals != std::string::npos && equals > 0 && text[0] != '-' && before[0] != '-';
    if (setting && !std::filesystem::exists(text))
      throw CLI::ValidationError(text, "each key=value needs its own --set: --set '" + text + "'");
  }
}

/// CLI11's own exit codes for wrong usage are all 2 here.
bool parsed(CLI::App& app, int argc, char** argv, int& code) {
  try {
    if (argc > 1 && argv[1][0] != '-')
      checkCommand(app, argv[1]), checkRanks(argc, argv), checkSettings(argc, argv);
    app.parse(reversedArguments(argc, argv));
    return true;
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e), code = 0, false;  // --help, --version
    sayOnce(app, e, &argc, &argv);
    code = thaw::exitUsage;
    return false;
  }
}

}  // namespace

int main(int argc, char** argv) {
  using namespace thaw;
  CLI::App app("thaw simulates solids and fluids that deform, melt, flow, freeze and break, over MPI.",
               "thaw");
  app.set_version_flag("--version", std::string("thaw ") + versionNumber() + " (" + versionCommit() + ")");
  app.require_subcommand(1);
  RunOptions run;
  CheckOptions check;
  RenderOptions render;
  ExportOptions exportOptions;
  CompareArguments compare;
  InfoArguments info;
  CLI::App* runApp = app.add_subcommand("run", "simulate a scene; under mpirun on several ranks");
  addRunOptions(*runApp, run);
  RunOptions relax;
  relax.relax = 100000;
  relax.steps = 0;
  CLI::App* relaxApp = app.add_subcommand("relax", "move the oriented bodies of a scene to rest");
  addRelaxOptions(*relaxApp, relax);
  CLI::App* checkApp = app.add_subcommand("check", "say what would be simulated");
  addCheckOptions(*checkApp, check);
  CLI::App* renderApp = app.add_subcommand("render", "make pictures of a frame or of a run");
  addRenderOptions(*renderApp, render);
  CLI::App* exportApp = app.add_subcommand("export", "write the frames of a surface for other programs");
  addExportOptions(*exportApp, exportOptions);
  CLI::App* compareApp = addCompareCommand(app, compare);
  CLI::App* infoApp = addInfoCommand(app, info);
  CLI::App* docsApp = app.add_subcommand("docs", "print the keys of a scene file (docs/scene.md)");
  int code = 0;
  if (!parsed(app, argc, argv, code)) return code;

  if (*renderApp) return renderCommand(render);
  if (*exportApp) return exportCommand(exportOptions);
  if (*docsApp) return std::fputs(sceneDocumentation().c_str(), stdout) < 0 ? exitInputOutput : 0;
  useRomio();  // before MPI starts
  MpiSession mpi(&argc, &argv);
  if (*compareApp) return compareCommand(compare);
  if (*infoApp) return infoCommand(info);
  if (*checkApp) return checkCommand(check);
  if (*relaxApp) return runCommand(relax);
  return runCommand(run);
}
