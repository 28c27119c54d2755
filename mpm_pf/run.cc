#include "run.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>

#include <omp.h>

#include "contact_forecast.h"
#include "costs.h"
#include "front_warnings.h"
#include "inertia.h"
#include "medium/numerical_error.h"
#include "observe.h"
#include "plan.h"
#include "quadrature.h"
#include "ramps.h"
#include "record/cannot_write.h"
#include "record/checkpoint.h"
#include "record/progress.h"
#include "record/run_cost.h"
#include "record/stopwatch.h"
#include "simulate.h"

namespace
{
  constexpr double checkpoint_interval_s = 300.;
  constexpr double memory_check_interval_s = 0.25;
  constexpr double flush_interval_s = 60.; // so long a row may wait to be seen in the record
  constexpr auto last_good = "last good state";
  constexpr auto forecast_at_contact = "forecast_at_contact_cpu_s";

  void save_checkpoint(const World &world, const Recorder &recorder, const record::Profile &spent,
                       const std::string &path)
  {
    record::CheckpointFile checkpoint(path, *world.scene);
    checkpoint.put("time", world.time);
    checkpoint.put("steps", static_cast<double>(world.steps));
    save(world, checkpoint);
    recorder.save(checkpoint);
    record::save(spent, checkpoint);
    checkpoint.finish();
  }

  /// A run in progress: everything that outlives its functions.
  class Session
  {
  public:
    Session(const scene::Scene &, const record::CommandLine &);
    int go(const std::function<bool()> &stop_asked);

  private:
    void open(bool resume);
    void save();
    void measure_memory();
    void keep_house();
    bool after_step(const std::function<bool()> &stop_asked);
    int march(const std::function<bool()> &stop_asked);
    void rerun_to_last_good_step(const std::function<bool()> &stop_asked);
    int fail(const std::string &what, const std::function<bool()> &stop_asked);
    int abandon(const std::string &what, int exit_code);
    int complete();
    record::Profile profile();
    void forget_checkpoint() const
    {
      std::error_code none;
      std::filesystem::remove(record::checkpoint_path(command.record_path()), none);
    }

    const scene::Scene &scene;
    const record::CommandLine &command;
    record::RunCost cost;
    ContactForecast contact;
    record::Stopwatch since_checkpoint;
    std::optional<record::Stopwatch> since_memory_check; // not before the first
    bool saved = false;                                  // there is a checkpoint of this run
    long good = 0;                                       // the last step that went well
    World world;
    std::map<std::string, double> held; // bytes by module, when they were most
    std::optional<record::Writer> writer;
    std::optional<Recorder> recorder;
    std::optional<record::Progress> progress;
  };

  Session::Session(const scene::Scene &asked, const record::CommandLine &line)
      : scene(asked), command(line), world(build_world(asked, line.threads, line.force))
  {
    std::cerr << size(world);
    open(command.resume);
    cost.set_up_done();
    since_checkpoint = {};
    progress.emplace(std::cerr, record::Progress::style_of_stderr(false), "mpm_pf " + scene.title,
                     record::Progress::Range{world.time, scene.clock.end});
  }

  void Session::open(const bool resume)
  {
    auto provenance = record::collect_provenance("mpm_pf", command.joined, command.threads);
    if (scene.noise)
      provenance["seed"] = std::to_string(scene.noise->seed);
    if (!resume)
    {
      std::filesystem::create_directories(command.output);
      writer.emplace(command.record_path(), provenance, scene, command.force);
      recorder.emplace(scene, *writer);
      return;
    }
    const auto from =
        record::Checkpoint::load(record::checkpoint_path(command.record_path()), scene);
    world.time = from.number("time");
    world.steps = static_cast<long>(from.number("steps"));
    restore(world, from);
    if (!progress) // else it is a rerun, which is no start
      cost.resume(from), contact.restore(cost.earlier(forecast_at_contact));
    writer.emplace(command.record_path(), provenance, scene, record::Writer::Resume{world.time});
    recorder.emplace(scene, *writer);
    recorder->restore(from, world.time);
    saved = true;
  }

  void Session::save()
  {
    writer->flush();
    save_checkpoint(world, *recorder, profile(), record::checkpoint_path(command.record_path()));
    since_checkpoint = {};
    saved = true;
  }

  void Session::measure_memory()
  {
    for (const auto &[what, bytes] : memory(world))
    {
      double &most = held[what];
      most = std::max(most, bytes);
    }
    since_memory_check.emplace();
  }

  record::Profile Session::profile()
  {
    measure_memory();
    auto known = numbers(world);
    if (contact.cpu_s())
      known[forecast_at_contact] = *contact.cpu_s();
    for (const auto &[what, bytes] : held)
      known["bytes " + what] = bytes;
    return cost.profile({recorder->cost(), world.steps, parts(world), known});
  }

  /// What is done by the clock, and more often on a slow machine. A function of its own, and never
  /// part of another: tests/instructions leaves it out of what a step costs.
  [[gnu::noinline]] void Session::keep_house()
  {
    add(contact, world, cost.cpu_seconds());
    progress->set_end(expected_end(world));
    progress->update(world.time, "step " + std::to_string(world.steps));
    if (!since_memory_check || since_memory_check->wall_seconds() > memory_check_interval_s)
      measure_memory();
    if (since_checkpoint.wall_seconds() > checkpoint_interval_s)
      save();
    writer->flush_after(flush_interval_s);
  }

  bool Session::after_step(const std::function<bool()> &stop_asked)
  {
    good = world.steps;
    keep_house();
    const bool stop = stop_asked();
    if (stop)
      save();
    return !stop;
  }

  /// Once more from the last checkpoint, or from the start, to the state before the trouble: the
  /// same scene gives the same bits, so a run that goes well need not keep its states. No
  /// checkpoint is later than the last good step, since only good steps come to after_step().
  void Session::rerun_to_last_good_step(const std::function<bool()> &stop_asked)
  {
    recorder.reset(), writer.reset();
    world = World{}; // two at once might not find room
    world = build_world(scene, command.threads, command.force);
    open(saved);
    simulate(world, *recorder, [&](const World &now) { return now.steps < good && !stop_asked(); });
    scene::Probe probe;
    probe.name = last_good;
    observe(scene::SnapshotProbe{}, probe, world, *writer);
  }

  int Session::fail(const std::string &what, const std::function<bool()> &stop_asked)
  {
    progress->finish("failed");
    std::cerr << "mpm_pf: " << what << "\nGoing back to the last good state ...\n";
    const record::Profile spent = profile();
    rerun_to_last_good_step(stop_asked);
    writer->finish(spent, "failed: " + what);
    forget_checkpoint();
    std::cerr << "The record keeps what came before and, as snapshot \"" << last_good
              << "\", the state after step " << world.steps << " at time " << world.time
              << ": open " << command.output << '/' << command.record
              << ".xdmf.\nThe same scene meets the same trouble, so there is nothing to resume: "
                 "change what is named above and start anew.\nrepeat with: "
              << command.joined << '\n';
    return record::numerical_trouble;
  }

  /// Stopped by what the scene is not to blame for: a full disk, a file that cannot be written.
  int Session::abandon(const std::string &what, const int exit_code)
  {
    progress->finish("stopped");
    std::ostringstream text;
    text << "stopped after step " << world.steps << " at time " << world.time << ": " << what;
    std::cerr << "mpm_pf: " << text.str() << "\nWhat could be recorded is in "
              << command.record_path() << ".part; remove the cause and "
              << (saved ? "go on with --resume, from the last checkpoint"
                        : "start anew, without --resume: there is no checkpoint yet")
              << ".\nrepeat with: " << command.joined << '\n';
    try
    {
      if (writer)
      {
        writer->attribute("stopped_by", text.str());
        writer->flush();
      }
    }
    catch (const std::exception &)
    {
      // Where nothing can be written, what was said above is all.
    }
    return exit_code;
  }

  int Session::complete()
  {
    std::string warning = recorder->warning();
    for (const std::string &doubt :
         {warning_on_scaling(world), warning_on_wall_ramps(world), warning_on_support_ramps(world),
          warning_on_quadrature(world), warning_on_thin_bodies(world), warning_on_idle_walls(world),
          warning_on_missing_walls(world), warning_on_kinetic_energy(world),
          warning_on_energy(world), warning_on_sides(world), warning_on_areas(world),
          warning_on_melted_crystals(world)})
      if (!doubt.empty())
        warning += (warning.empty() ? "" : "; ") + doubt;
    const auto tell = [&](const char *attribute, const std::string &text)
    {
      if (!text.empty())
        std::cerr << "mpm_pf: " << text << '\n', writer->attribute(attribute, text);
    };
    tell("warning", warning);
    tell("inertia", verdict_on_inertia(world));
    writer->finish(profile());
    forget_checkpoint();
    progress->finish();
    std::cout << command.record_path() << '\n';
    return record::all_right;
  }

  int Session::march(const std::function<bool()> &stop_asked)
  {
    std::string trouble;
    try
    {
      if (!simulate(world, *recorder, [&](const World &) { return after_step(stop_asked); }))
      {
        progress->finish("interrupted; go on with --resume");
        return record::interrupted;
      }
    }
    catch (const medium::NumericalError &found)
    {
      trouble = found.what();
    }
    return trouble.empty() ? complete() : fail(trouble, stop_asked);
  }

  int Session::go(const std::function<bool()> &stop_asked)
  {
    try
    {
      return march(stop_asked);
    }
    catch (const std::exception &error)
    {
      return abandon(error.what(), record::is_of_writing(error) ? record::not_written
                                                                : record::numerical_trouble);
    }
  }
} // namespace

int run(const scene::Scene &scene, const record::CommandLine &command,
        const std::function<bool()> &stop_asked)
{
  std::cerr << banner(scene);
  omp_set_num_threads(command.threads);
  return Session(scene, command).go(stop_asked);
}
