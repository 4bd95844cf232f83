// SPDX-License-Identifier: Apache-2.0
// The command line of thaw.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "io/command_line/completion.hpp"
#include "io/command_line/man_page.hpp"
#include "io/commands/check.hpp"
#include "io/commands/compare_command.hpp"
#include "io/commands/export.hpp"
#include "io/commands/info_command.hpp"
#include "io/commands/new_command.hpp"
#include "io/commands/plot.hpp"
#include "io/commands/preview.hpp"
#include "io/commands/render.hpp"
#include "io/commands/run.hpp"
#include "io/commands/view.hpp"
#include "io/hdf5/parallel_file.hpp"
#include "io/scene/read_scene.hpp"
#include "io/scene/scene_for_all.hpp"
#include "io/scene/text/nearest_word.hpp"
#include "io/text/version.hpp"
#include "parallel/communicator.hpp"

namespace {

/// Prints a command-line error once, on rank 0. The MPI session keeps the other ranks from ending the job
/// before rank 0 has printed it.
void printErrorOnce(CLI::App& app, const CLI::ParseError& e, int* argc, char*** argv) {
  thaw::MpiSession mpi(argc, argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) app.exit(e);
}

/// Returns the arguments without the program name, last first, as CLI11 expects. Writes "-.5" as "-0.5",
/// since CLI11 takes the former for an option.
std::vector<std::string> reversedArguments(int argc, char** argv) {
  std::vector<std::string> all;
  for (int a = argc; a-- > 1;) {
    const std::string text = argv[a];
    const bool pointFirst = text.size() > 2 && text[0] == '-' && text[1] == '.' && text[2] >= '0' &&
                            text[2] <= '9';
    all.push_back(pointFirst ? "-0" + text.substr(1) : text);
  }
  return all;
}

/// Returns the command of this name, or null.
const CLI::App* findCommand(const CLI::App& app, const std::string& name) {
  const auto all = app.get_subcommands([&](const CLI::App* command) { return command->get_name() == name; });
  return all.empty() ? nullptr : all.front();
}

/// Refuses an unknown command with a suggestion and the list of commands. CLI11 only reports a missing
/// command.
void checkCommand(const CLI::App& app, const std::string& given) {
  if (findCommand(app, given)) return;
  std::string names;
  std::set<std::string> words;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    words.insert(command->get_name());
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  throw CLI::ValidationError(given,
                             "unknown command; expected one of " + names + thaw::suggestion(given, words));
}

/// Refuses unknown long options of the command with a suggestion.
void checkOptions(const CLI::App& app, int argc, char** argv) {
  std::set<std::string> words;
  for (const CLI::Option* option : findCommand(app, argv[1])->get_options())
    for (const std::string& name : option->get_lnames()) words.insert("--" + name);
  for (int a = 2; a < argc; a++) {
    const std::string text = argv[a], name = text.substr(0, text.find('='));
    if (name == "--") return;  // later arguments are not options
    if (name.rfind("--", 0) == 0 && !words.count(name))
      throw CLI::ValidationError(
          name, fmt::format("unknown option of `thaw {}`{}", argv[1], thaw::suggestion(name, words)));
  }
}

/// Returns the error for arguments that no option takes. The error of CLI11 lists them in reverse order.
CLI::ValidationError unexpectedArguments(const CLI::App& app) {
  std::string all;
  for (const std::string& text : app.remaining(true)) all += (all.empty() ? "" : " ") + text;
  return CLI::ValidationError(all, "not expected; `--help` lists the arguments");
}

/// Refuses rank options of run and relax, and names mpirun. CLI11 only reports an unexpected argument.
void checkRanks(int argc, char** argv) {
  const std::string command = argv[1];
  if (command != "run" && command != "relax") return;
  for (int a = 2; a < argc; a++)
    if (const std::string text = argv[a]; text.rfind("--ranks", 0) == 0 || text == "-n" || text == "-np")
      throw CLI::ValidationError(text, "ranks are started by mpirun: mpirun -n 4 thaw " + command + " SCENE");
}

/// Refuses a key=value without its --set. CLI11 takes it for the scene.
void checkSettings(int argc, char** argv) {
  for (int a = 2; a < argc; a++) {
    const std::string text = argv[a], before = argv[a - 1];
    const std::size_t equals = text.find('=');
    const bool setting = equals != std::string::npos && equals > 0 && text[0] != '-' && before[0] != '-';
    if (setting && !std::filesystem::exists(text))
      throw CLI::ValidationError(text, "each key=value needs its own --set: --set '" + text + "'");
  }
}

/// Parses the command line. Throws CLI::ParseError.
void parseInOrder(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(reversedArguments(argc, argv));
  } catch (const CLI::ExtrasError&) { throw unexpectedArguments(app); }
}

/// Returns the text of a usage error.
std::string usageText(const CLI::App*, const CLI::Error& e) {
  return fmt::format("thaw: error: {}\nRun with --help for more information.\n", e.what());
}

/// Parses the command line. Returns false when the program ends now, with `code`: 2 for every usage error.
bool parsed(CLI::App& app, int argc, char** argv, int& code) {
  try {
    if (argc > 1 && argv[1][0] != '-')
      checkCommand(app, argv[1]), checkRanks(argc, argv), checkOptions(app, argc, argv),
          checkSettings(argc, argv);
    parseInOrder(app, argc, argv);
    return true;
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e), code = 0, false;  // --help, --version
    printErrorOnce(app, e, &argc, &argv);
    code = thaw::exitUsage;
    return false;
  }
}

/// Options of `thaw docs`.
struct DocsOptions {
  bool man = false, schema = false;
  std::string completion;
};

CLI::App* addDocsCommand(CLI::App& app, DocsOptions& o) {
  CLI::App* command = app.add_subcommand("docs",
                                         "print the keys of a scene file (docs/scene.md), or other pages");
  auto* man = command->add_flag("--man", o.man, "print the man page thaw.1 instead");
  auto* schema = command->add_flag("--schema", o.schema, "print the JSON schema of scene files for editors")
                     ->excludes(man);
  command->add_option("--completion", o.completion, "print the completion of the command line for this shell")
      ->check(CLI::IsMember({"bash"}))
      ->excludes(man)
      ->excludes(schema);
  return command;
}

int docsCommand(const CLI::App& app, const DocsOptions& o) {
  const std::string text = o.man                   ? thaw::manPage(thaw::describe(app), thaw::versionNumber())
                           : o.schema              ? thaw::sceneSchema()
                           : !o.completion.empty() ? thaw::bashCompletion(thaw::describe(app))
                                                   : thaw::sceneDocumentation();
  return std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0 ? thaw::exitInputOutput : 0;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace thaw;
  CLI::App app("thaw simulates solids and fluids that deform, melt, flow, freeze and break, over MPI.",
               "thaw");
  app.set_version_flag("--version", std::string("thaw ") + versionNumber() + " (" + versionCommit() + ")");
  app.require_subcommand(1);
  app.failure_message(usageText);
  RunOptions run;
  CheckOptions check;
  RenderOptions render;
  ExportOptions exportOptions;
  ViewOptions view;
  CompareArguments compare;
  InfoArguments info;
  NewOptions fresh;
  PlotOptions plot;
  CLI::App* newApp = addNewCommand(app, fresh);
  CLI::App* runApp = app.add_subcommand("run", "simulate a scene; mpirun starts it on several ranks");
  addRunOptions(*runApp, run);
  RunOptions relax;
  relax.relax = 100000;
  relax.steps = 0;
  CLI::App* relaxApp = app.add_subcommand("relax", "relax the oriented bodies of a scene");
  addRelaxOptions(*relaxApp, relax);
  PreviewOptions preview;
  CLI::App* previewApp = app.add_subcommand("preview", "show a scene before it runs");
  addPreviewOptions(*previewApp, preview);
  CLI::App* checkApp = app.add_subcommand("check", "check a scene and report what would be simulated");
  addCheckOptions(*checkApp, check);
  CLI::App* renderApp = app.add_subcommand("render", "render pictures of a frame or a run");
  addRenderOptions(*renderApp, render);
  CLI::App* exportApp = app.add_subcommand("export", "export frames for other programs");
  addExportOptions(*exportApp, exportOptions);
  CLI::App* viewApp = app.add_subcommand("view", "show a run in the browser, finished or running");
  addViewOptions(*viewApp, view);
  CLI::App* compareApp = addCompareCommand(app, compare);
  CLI::App* infoApp = addInfoCommand(app, info);
  CLI::App* plotApp = addPlotCommand(app, plot);
  DocsOptions docs;
  CLI::App* docsApp = addDocsCommand(app, docs);
  int code = 0;
  if (!parsed(app, argc, argv, code)) return code;

  if (*renderApp) return renderCommand(render);
  if (*exportApp) return exportCommand(exportOptions);
  if (*viewApp) return viewCommand(view);
  if (*newApp) return newCommand(fresh);
  if (*plotApp) return plotCommand(plot);
  if (*docsApp) return docsCommand(app, docs);
  useRomio();  // before MPI starts
  MpiSession mpi(&argc, &argv);
  if (*compareApp) return compareCommand(compare);
  if (*infoApp) return infoCommand(info);
  if (*checkApp) return checkCommand(check);
  if (*previewApp) return previewCommand(preview);
  if (*relaxApp) return runCommand(relax);
  return runCommand(run);
}
