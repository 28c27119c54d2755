#include "forecast_output.h"

#include <algorithm>
#include <filesystem>
#include <type_traits>

#include <unistd.h>

#include "forecast_probes.h"
#include "observe.h"
#include "scene/schedule.h"

namespace
{
  namespace fs = std::filesystem;

  /// A folder for this process, gone with it.
  struct ScratchFolder
  {
    fs::path path = fs::temp_directory_path() / ("mpm_pf_plan_" + std::to_string(getpid()));
    ScratchFolder() = default;
    ScratchFolder(const ScratchFolder &) = delete;
    ScratchFolder &operator=(const ScratchFolder &) = delete;
    ~ScratchFolder()
    {
      std::error_code none;
      fs::remove_all(path, none);
    }
  };

  double sample_count(const scene::Probe &probe, const double end)
  {
    return static_cast<double>(probe.compressions.empty() ? scene::sample_times(probe, end).size()
                                                          : probe.compressions.size());
  }

  double seconds_per_sample(const scene::Probe &probe, const World &world, record::Writer &writer,
                            const int most)
  {
    return std::visit(
        [&](const auto &kind)
        {
          using Kind = std::decay_t<decltype(kind)>;
          if constexpr (std::is_same_v<Kind, scene::TipProbe> ||
                        std::is_same_v<Kind, scene::ReactionProbe>)
            return 0.;
          else
            return seconds_of([&] { observe(kind, probe, world, writer); }, probe_budget_s, most);
        },
        probe.kind);
  }
} // namespace

void forecast_output(const World &world, Forecast &forecast)
{
  constexpr int most_calls = 20; // each is written
  double total = 0.;
  try
  {
    const ScratchFolder scratch;
    record::Writer writer((scratch.path / "record.h5").string(), {}, *world.scene, true);
    for (const scene::Probe &probe : world.scene->probes)
    {
      const double count = sample_count(probe, expected_end(world));
      const int most = static_cast<int>(std::clamp(count, 1., double(most_calls)));
      total += count * seconds_per_sample(probe, world, writer, most);
    }
  }
  catch (const std::exception &)
  {
    return; // a plan needs no room on a disk
  }
  forecast.seconds["output"] = total;
}
