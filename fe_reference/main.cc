// fe_reference SCENE [options]: argv -> read_scene -> run -> exit code. The only place that catches
// exceptions and starts MPI; one process needs no mpirun.
#include <mpi.h>

#include <csignal>
#include <iostream>

#include "fe_reference/run.h"
#include "record/outline_source.h"
#include "record/wait_policy.h"
#include "scene/reader.h"

namespace
{
  volatile std::sig_atomic_t stop_asked = 0;
  void ask_to_stop(int)
  {
    stop_asked = 1;
  }

  int work(const record::CommandLine &command, const bool first)
  {
    if (command.explain)
    {
      if (first)
        std::cout << scene::explain(*command.explain);
      return record::all_right;
    }
    scene::Scene scene = scene::read_scene(command.scene, command.overrides);
    record::resolve_outlines(scene);
    if (command.plan)
      return fe::show_plan(scene, command.threads);
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
    return fe::run(scene, command, [] { return stop_asked != 0; });
  }

  int guarded(const record::Parsed &parsed, const bool first)
  {
    if (!parsed.command)
    {
      if (first)
        (parsed.exit_code == record::all_right ? std::cout : std::cerr) << parsed.text;
      return parsed.exit_code;
    }
    try
    {
      return work(*parsed.command, first);
    }
    catch (const scene::BadScene &error)
    {
      if (first)
        std::cerr << error.what() << '\n';
    }
    catch (const fe::Stopped &error)
    {
      if (first)
        std::cerr << "fe_reference: " << error.what() << "\nrepeat with: " << parsed.command->joined
                  << '\n';
      return error.exit_code;
    }
    catch (const std::exception &error)
    {
      if (first)
        std::cerr << "fe_reference: " << error.what() << '\n';
    }
    return record::bad_input;
  }
} // namespace

int main(int argc, char **argv)
{
  const auto parsed =
      record::parse_command_line(argc, argv, "fe_reference",
                                 "Quasi-static finite-strain finite elements: the independent "
                                 "reference for the solid.");
  if (parsed.command && parsed.command->threads > 1)
    record::wait_passively(argv); // before MPI, which may be started once only
  MPI_Init(&argc, &argv);
  int number = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &number);
  const int code = guarded(parsed, number == 0);
  MPI_Finalize();
  return code;
}
