// mpm_pf SCENE [options]: argv -> read_scene -> simulate -> exit code. The only place that catches
// exceptions.
#include <malloc.h>

#include <csignal>
#include <filesystem>
#include <iostream>

#include "medium/numerical_error.h"
#include "plan.h"
#include "record/cannot_write.h"
#include "record/command_line.h"
#include "record/outline_source.h"
#include "record/wait_policy.h"
#include "run.h"
#include "scene/reader.h"

namespace
{
  volatile std::sig_atomic_t stop_asked = 0;
  void ask_to_stop(int)
  {
    stop_asked = 1;
  }

  int work(const record::CommandLine &command)
  {
    if (command.explain)
    {
      std::cout << scene::explain(*command.explain);
      return record::all_right;
    }
    scene::Scene scene = scene::read_scene(command.scene, command.overrides);
    record::resolve_outlines(scene);
    if (command.plan)
    {
      std::cout << plan(scene, command.threads, command.force);
      return record::all_right;
    }
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
    return run(scene, command, [] { return stop_asked != 0; });
  }
} // namespace

int main(int argc, char **argv)
{
  // Large arrays go back to the system when they are freed. By default the first one freed raises
  // this threshold, and arrays that grow leave holes as large as themselves in the heap.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  const auto parsed = record::parse_command_line(
      argc, argv, "mpm_pf",
      "Material points and phase field: solid deformation during solidification.");
  if (!parsed.command)
  {
    (parsed.exit_code == record::all_right ? std::cout : std::cerr) << parsed.text;
    return parsed.exit_code;
  }
  if (parsed.command->threads > 1)
    record::wait_passively(argv);
  try
  {
    return work(*parsed.command);
  }
  catch (const scene::BadScene &error)
  {
    std::cerr << error.what() << '\n';
    return record::bad_input;
  }
  catch (const medium::NumericalError &error) // of a plan, which takes the first steps
  {
    std::cerr << "mpm_pf: " << error.what() << "\nrepeat with: " << parsed.command->joined << '\n';
    return record::numerical_trouble;
  }
  catch (const record::CannotWrite &error) // before the first step
  {
    std::cerr << "mpm_pf: " << error.what() << "\nrepeat with: " << parsed.command->joined << '\n';
    return record::not_written;
  }
  catch (const std::exception &error)
  {
    std::cerr << "mpm_pf: " << error.what() << '\n';
    return record::bad_input;
  }
}
