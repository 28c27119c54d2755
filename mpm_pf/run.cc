#include "run.h"

#include <filesystem>
#include <iostream>
#include <optional>

#include <omp.h>

#include "accounts.h"
#include "medium/trouble.h"
#include "plan.h"
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
    record::Checkpoint checkpoint;
    checkpoint.put("time", world.time);
    checkpoint.put("steps", static_cast<double>(world.steps));
    save(world, checkpoint);
    recorder.save(checkpoint);
    checkpoint.save(path, *world.scene);
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
} // namespace

int run(const scene::Scene &scene, const record::CommandLine &command,
        const std::function<bool()> &stop_asked)
{
  const double begin_wall = record::wall_seconds();
  std::cerr << banner(scene);
  omp_set_num_threads(command.threads);
  World world = build_world(scene, command.threads, command.force);

  std::filesystem::create_directories(command.output);
  const auto provenance = record::collect("mpm_pf", command.joined, command.threads);
  std::optional<record::Checkpoint> from;
  if (command.resume && std::filesystem::exists(checkpoint_path(command)))
    from = record::Checkpoint::load(checkpoint_path(command), scene);
  std::optional<record::Writer> writer;
  if (from)
    writer.emplace(command.record_path(), provenance, scene,
                   record::Writer::Resume{from->number("time")});
  else
    writer.emplace(command.record_path(), provenance, scene, command.force);
  Recorder recorder(scene, *writer);
  if (from)
  {
    world.time = from->number("time");
    world.steps = static_cast<long>(from->number("steps"));
    restore(world, *from);
    recorder.restore(*from, world.time);
  }
  const double setup_cpu = record::cpu_seconds();
  const double setup_wall = record::wall_seconds() - begin_wall;

  record::Progress progress(std::cerr, record::Progress::style_of_stderr(false),
                            "mpm_pf " + scene.title, world.time, scene.clock.end);
  double last_checkpoint = record::wall_seconds();
  const auto checkpoint = [&](const World &w)
  {
    writer->flush();
    save_checkpoint(w, recorder, checkpoint_path(command));
    last_checkpoint = record::wall_seconds();
  };
  const auto look = [&](const World &w)
  {
    progress.update(w.time, "step " + std::to_string(w.steps));
    if (stop_asked())
    {
      checkpoint(w);
      return false;
    }
    if (record::wall_seconds() - last_checkpoint > seconds_between_checkpoints)
      checkpoint(w);
    return true;
  };
  const auto profile = [&]
  { return profile_of(world, recorder, setup_cpu, setup_wall, begin_wall); };
  const auto fail = [&](const std::string &what)
  {
    progress.finish("failed");
    std::cerr << "mpm_pf: " << what
              << "\nThe record keeps what came before; repeat with: " << command.joined << '\n';
    writer->finish(profile(), "failed: " + what);
    return record::numerical_trouble;
  };
  try
  {
    if (!simulate(world, recorder, look))
    {
      progress.finish("interrupted; go on with --resume");
      return record::interrupted;
    }
  }
  catch (const solid::Trouble &trouble)
  {
    return fail(trouble.what());
  }
  catch (const medium::NumericalTrouble &trouble)
  {
    return fail(trouble.what());
  }
  if (!recorder.warning().empty())
  {
    std::cerr << "mpm_pf: " << recorder.warning() << '\n';
    writer->attribute("warning", recorder.warning());
  }
  writer->finish(profile());
  std::error_code none;
  std::filesystem::remove(checkpoint_path(command), none);
  progress.finish();
  std::cout << command.record_path() << '\n';
  return record::all_right;
}
