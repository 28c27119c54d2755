#include "run.h"

#include <filesystem>
#include <iostream>
#include <optional>

#include <omp.h>

#include "accounts.h"
#include "front_warnings.h"
#include "inertia.h"
#include "medium/trouble.h"
#include "plan.h"
#include "quadrature.h"
#include "record/checkpoint.h"
#include "record/progress.h"
#include "simulate.h"

namespace
{
  constexpr double seconds_between_checkpoints = 300.;

  /// A record that could not have been started must not be found by the next campaign.
  std::string checkpoint_path(const record::CommandLine &command)
  {
    return command.output + "/" + command.record + ".checkpoint.h5";
  }

  void save_checkpoint(const World &world, const Recorder &recorder, const std::string &path)
  {
    record::CheckpointFile checkpoint(path, *world.scene);
    checkpoint.put("time", world.time);
    checkpoint.put("steps", static_cast<double>(world.steps));
    save(world, checkpoint);
    recorder.save(checkpoint);
    checkpoint.finish();
  }

  record::Profile profile_of(const World &world, const Recorder &recorder, const double setup_cpu,
                             const double setup_wall, const double begin_wall)
  {
    record::Profile profile;
    const double cpu = record::cpu_seconds(), wall = record::wall_seconds() - begin_wall;
    const double output_cpu = recorder.cpu_seconds(), output_wall = recorder.wall_seconds();
    profile.parts = {
        {"set-up", setup_wall, setup_cpu, 1},
        {"solve", wall - setup_wall - output_wall, cpu - setup_cpu - output_cpu, world.steps},
        {"output", output_wall, output_cpu, 1}};
    for (const auto &part : parts(world))
      profile.parts.push_back(part);
    profile.numbers = numbers(world);
    profile.numbers["wall_s"] = wall;
    profile.numbers["cpu_s"] = cpu;
    profile.numbers["peak_rss_bytes"] = record::peak_rss_bytes();
    for (const auto &[what, bytes] : memory(world))
      profile.numbers["bytes " + what] = bytes;
    return profile;
  }

  /// A run in progress: everything that outlives its functions.
  class Session
  {
  public:
    Session(const scene::Scene &, const record::CommandLine &);
    int go(const std::function<bool()> &stop_asked);

  private:
    void open();
    void save();
    bool look(const std::function<bool()> &stop_asked);
    int fail(const std::string &what);
    int complete();
    record::Profile profile() const
    {
      return profile_of(world, *recorder, setup_cpu, setup_wall, begin_wall);
    }

    const scene::Scene &scene;
    const record::CommandLine &command;
    double begin_wall = record::wall_seconds();
    double setup_cpu = 0., setup_wall = 0., last_checkpoint = 0.;
    World world;
    std::optional<record::Writer> writer;
    std::optional<Recorder> recorder;
    std::optional<record::Progress> progress;
  };

  Session::Session(const scene::Scene &asked, const record::CommandLine &line)
      : scene(asked), command(line), world(build_world(asked, line.threads, line.force))
  {
    open();
    setup_cpu = record::cpu_seconds();
    setup_wall = record::wall_seconds() - begin_wall;
    last_checkpoint = record::wall_seconds();
    progress.emplace(std::cerr, record::Progress::style_of_stderr(false), "mpm_pf " + scene.title,
                     world.time, scene.clock.end);
  }

  void Session::open()
  {
    std::filesystem::create_directories(command.output);
    const auto provenance = record::collect("mpm_pf", command.joined, command.threads);
    if (!command.resume || !std::filesystem::exists(checkpoint_path(command)))
    {
      writer.emplace(command.record_path(), provenance, scene, command.force);
      recorder.emplace(scene, *writer);
      return;
    }
    const auto from = record::Checkpoint::load(checkpoint_path(command), scene);
    world.time = from.number("time");
    world.steps = static_cast<long>(from.number("steps"));
    restore(world, from);
    writer.emplace(command.record_path(), provenance, scene, record::Writer::Resume{world.time});
    recorder.emplace(scene, *writer);
    recorder->restore(from, world.time);
  }

  void Session::save()
  {
    writer->flush();
    save_checkpoint(world, *recorder, checkpoint_path(command));
    last_checkpoint = record::wall_seconds();
  }

  bool Session::look(const std::function<bool()> &stop_asked)
  {
    progress->expect(expected_end(world));
    progress->update(world.time, "step " + std::to_string(world.steps));
    const bool stop = stop_asked();
    if (stop || record::wall_seconds() - last_checkpoint > seconds_between_checkpoints)
      save();
    return !stop;
  }

  int Session::fail(const std::string &what)
  {
    progress->finish("failed");
    std::cerr << "mpm_pf: " << what
              << "\nThe record keeps what came before; repeat with: " << command.joined << '\n';
    writer->finish(profile(), "failed: " + what);
    return record::numerical_trouble;
  }

  int Session::complete()
  {
    std::string warning = recorder->warning();
    for (const std::string &doubt :
         {warning_on_scaling(world), warning_on_quadrature(world), warning_on_thin_bodies(world),
          warning_on_idle_walls(world), warning_on_energy(world), warning_on_sides(world),
          warning_on_areas(world)})
      if (!doubt.empty())
        warning += (warning.empty() ? "" : "; ") + doubt;
    if (!warning.empty())
    {
      std::cerr << "mpm_pf: " << warning << '\n';
      writer->attribute("warning", warning);
    }
    if (const std::string verdict = verdict_on_inertia(world); !verdict.empty())
    {
      std::cerr << "mpm_pf: " << verdict << '\n';
      writer->attribute("inertia", verdict);
    }
    writer->finish(profile());
    std::error_code none;
    std::filesystem::remove(checkpoint_path(command), none);
    progress->finish();
    std::cout << command.record_path() << '\n';
    return record::all_right;
  }

  int Session::go(const std::function<bool()> &stop_asked)
  {
    try
    {
      if (simulate(world, *recorder, [&](const World &) { return look(stop_asked); }))
        return complete();
    }
    catch (const solid::Trouble &trouble)
    {
      return fail(trouble.what());
    }
    catch (const medium::NumericalTrouble &trouble)
    {
      return fail(trouble.what());
    }
    progress->finish("interrupted; go on with --resume");
    return record::interrupted;
  }
} // namespace

int run(const scene::Scene &scene, const record::CommandLine &command,
        const std::function<bool()> &stop_asked)
{
  std::cerr << banner(scene);
  omp_set_num_threads(command.threads);
  return Session(scene, command).go(stop_asked);
}
