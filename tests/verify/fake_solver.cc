// A solver that computes nothing: it takes the options of the real ones and writes a record with
// known contents, so that the campaign program can be tested without them; the hash in it is that
// of its scene, where that is one, or of the scene that the environment names as FAKE_SCENE. What
// it does is told by --set fake.<key>=<number>:
//
//   error, order, h   every quantity is off by error*h^order
//   exit              this exit code instead of a record
//   sleep             seconds of waiting;  burn: seconds of CPU time
//   short             the history ends at this time instead of 1
//   recorded          line, outline and snapshot are of this time instead of 1
//   end               the clock ends at this time instead of 1
//   bare              so many of the 21 samples of the line lie in no material
//   wall_travel       the scene has a wall with this travel, and the speed of the next
//   wall_speed
//   nan               1: the line probe holds an infinite value
//   predicted          seconds that --plan forecasts instead of what will be burnt
//   skew              the outline is a parallelogram about the origin, sheared by this
//   growth            the energy grows by this factor per unit of time
//   hole              exit code 2 if the growth is this
//   bytes             1: its trouble is told in bytes that are no UTF-8
//   checkpoint        1: told to stop while it sleeps it leaves a checkpoint and ends with 130,
//   from
//                     which --resume goes on at once
//   troubled          1: it has met trouble before it waits, and ends with 3 when told to stop
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <thread>

#include "record/checkpoint.h"
#include "record/command_line.h"
#include "record/provenance.h"
#include "record/writer.h"
#include "scene/reader.h"

namespace
{
  using Settings = std::map<std::string, double>;

  Settings settings_of(const record::CommandLine &command)
  {
    Settings settings{
        {"error", 0.},      {"order", 2.},    {"h", 1.},     {"exit", 0.},     {"sleep", 0.},
        {"burn", 0.},       {"short", 1.},    {"nan", 0.},   {"growth", 0.},   {"predicted", 0.},
        {"hole", -1.},      {"skew", 0.},     {"bytes", 0.}, {"troubled", 0.}, {"wall_travel", -1.},
        {"wall_speed", 0.}, {"recorded", 1.}, {"end", 1.},   {"bare", 0.},     {"checkpoint", 0.}};
    for (const auto &text : command.overrides)
      if (const auto equal = text.find('='); text.rfind("fake.", 0) == 0 && equal + 1 < text.size())
        settings[text.substr(5, equal - 5)] = std::strtod(text.c_str() + equal + 1, nullptr);
    return settings;
  }

  std::string hash_of(const std::string &file)
  {
    try
    {
      return scene::read_scene(file).hash;
    }
    catch (const scene::BadScene &)
    {
      return "";
    }
  }

  void burn(const double seconds)
  {
    volatile double sum = 0.;
    for (const double end = record::cpu_seconds() + seconds; record::cpu_seconds() < end;)
      for (int i = 0; i < 10000; ++i)
        sum = sum + std::sqrt(i);
  }

  /// Exact: history sin(t), line x^2, outline a unit square, field x + y; all but the energy off by
  /// `off`.
  void write(record::Writer &writer, const Settings &s)
  {
    const double off = s.at("error") * std::pow(s.at("h"), s.at("order"));
    for (int i = 0; i <= 100 && 0.01 * i <= s.at("short"); ++i)
    {
      const double t = 0.01 * i;
      writer.table("history", {{"force", "strain"}, {"N", "-"}}, t,
                   {2. * std::sin(t) * (1. + off), t < 0.5 ? t : 1. - t});
      writer.table("energy", {{"kinetic_energy"}, {"J"}}, t, {std::exp(s.at("growth") * t)});
    }
    record::LineSample line;
    for (int i = 0; i <= 20; ++i)
    {
      const double x = 0.05 * i;
      line.position.push_back({x, 0.5});
      line.values.push_back(x * x + off);
    }
    if (s.at("nan") > 0.)
      line.values[3] = std::numeric_limits<double>::infinity();
    for (int i = 0; i < static_cast<int>(s.at("bare")); ++i)
      line.values[20 - i] = std::numeric_limits<double>::quiet_NaN();
    const double recorded = s.at("recorded");
    writer.line("profile", {{"u"}, {"m"}}, recorded, line);
    const double k = s.at("skew");
    if (k != 0.)
      writer.outline("outline", recorded,
                     {{{-2. - k, -1.}, {2. - k, -1.}, {2. + k, 1.}, {-2. + k, 1.}}});
    else
      writer.outline("outline", recorded, {{{0., 0.}, {1. + off, 0.}, {1. + off, 1.}, {0., 1.}}});
    record::Snapshot snapshot;
    snapshot.vertex = {{0., 0.}, {1., 0.}, {0., 1.}, {1., 1.}};
    snapshot.fields["sum"] = {off, 1. + off, 1. + off, 2. + off};
    snapshot.fields["area"] = {1., 1., 1., 1.};
    writer.snapshot("fields", recorded, snapshot);
    writer.attribute("largest", 1. + off);
    if (off > 0.)
      writer.attribute("inertia", "inertia shows: not quasi-static");
  }
} // namespace

int main(int argc, char **argv)
{
  const std::string name = std::filesystem::path(argv[0]).filename().string();
  const auto parsed =
      record::parse_command_line(argc, argv, name, "a solver that computes nothing");
  if (!parsed.command)
  {
    std::printf("%s", parsed.text.c_str());
    return parsed.exit_code;
  }
  const auto &command = *parsed.command;
  const Settings s = settings_of(command);
  if (command.plan)
  {
    std::printf("  on: everything (line 1)\n  off: nothing\n  memory, points: 5 MB\n"
                "forecast cpu_s=%g solver_bytes=5e6 resident_bytes=%g\n",
                s.at("predicted") > 0. ? s.at("predicted") : 0.01 + s.at("burn"),
                record::peak_rss_bytes()); // under a sanitizer six times as much
    return 0;
  }
  if (s.at("troubled") > 0.)
  {
    std::printf("a banner\nfake run: failed in 0 s\nfake trouble, going back\n");
    std::fflush(stdout);
    std::signal(SIGTERM, [](int) { std::_Exit(3); });
  }
  if (s.at("checkpoint") > 0. && !command.resume)
  {
    std::filesystem::create_directories(command.output);
    std::fclose(std::fopen((command.record_path() + ".part").c_str(), "w"));
    std::fclose(std::fopen(record::checkpoint_path(command.record_path()).c_str(), "w"));
    std::signal(SIGTERM, [](int) { std::_Exit(record::interrupted); });
  }
  if (s.at("checkpoint") == 0. || !command.resume)
    std::this_thread::sleep_for(std::chrono::duration<double>(s.at("sleep")));
  burn(s.at("burn"));
  if (s.at("growth") == s.at("hole"))
    return 2;
  if (s.at("exit") != 0.)
  {
    std::printf("fake trouble of kind %g%s\n", s.at("exit"), s.at("bytes") > 0. ? " \xe9\xff" : "");
    return static_cast<int>(s.at("exit"));
  }
  std::filesystem::create_directories(command.output);
  scene::Scene scene;
  scene.file = command.scene;
  const char *other = std::getenv("FAKE_SCENE");
  scene.hash = hash_of(other ? other : command.scene);
  scene.text = "title = \"fake\"\n[clock]\nend = " + std::to_string(s.at("end")) + "\n";
  if (s.at("wall_travel") >= 0.)
    scene.text += "[[wall]]\nside = \"top\"\ntravel = " + std::to_string(s.at("wall_travel")) +
                  "\nspeed = " + std::to_string(s.at("wall_speed")) + "\n";
  record::Writer writer(command.record_path(), record::collect_provenance(name, command.joined, 1),
                        scene, command.force);
  write(writer, s);
  record::Profile profile;
  profile.numbers = {{"steps", 100.}, {"cells", 16.}, {"points", 64.}, {"bytes points", 5e6}};
  writer.finish(profile);
  return 0;
}
