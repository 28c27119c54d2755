#include "end_times.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "history_end.h"

namespace verify
{
  namespace
  {
    using Kind = Take::Kind;

    std::vector<double> times_of(const Take &take, const record::Reader &reader)
    {
      const std::string &probe = take.probes.at(0)[1];
      switch (take.kind)
      {
      case Kind::table:
        return reader.table(probe).time;
      case Kind::line:
        return reader.line(probe).time;
      case Kind::outline:
        return reader.outline(probe).time;
      default:
        return reader.snapshot_times(probe);
      }
    }

    /// The time of a take at the end, where that is the end of the clock.
    std::optional<double> end_of(const Take &take, Records &records, const std::string &run)
    {
      const bool last = take.kind == Kind::table
                            ? take.at == "end"
                            : take.nth.empty() && (take.at.empty() || take.at == "end");
      if (!last || take.kind == Kind::number || take.kind == Kind::value)
        return {};
      const auto &reader = records.open(run.empty() ? take.run : run);
      if (may_end_early(reader))
        return {};
      const auto times = times_of(take, reader);
      return times.empty() ? std::nullopt : std::optional<double>(times.back());
    }
  } // namespace

  void refuse_unequal_ends(const Check &check, Records &records, const std::string &run)
  {
    if (check.against.kind != Against::Kind::run)
      return;
    const auto taken = end_of(check.take, records, run),
               reference = end_of(check.against.take, records, "");
    if (taken && reference &&
        std::abs(*taken - *reference) >
            one_recording * std::max(std::abs(*taken), std::abs(*reference)))
      throw MissingData(fmt::format("what is taken at the end is of time {}, what it is held "
                                    "against of time {}: say `at` on both sides",
                                    *taken, *reference));
  }
} // namespace verify
