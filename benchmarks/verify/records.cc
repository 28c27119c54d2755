#include "measure.h"

#include <fmt/format.h>

#include "record_mark.h"

namespace verify
{
  Records::Records(std::string f, std::map<std::string, std::string> u)
      : folder(std::move(f)), unusable(std::move(u))
  {
  }

  std::string Records::path(const std::string &run) const
  {
    return folder + "/" + run + ".h5";
  }

  const record::Reader &Records::open(const std::string &run)
  {
    if (const auto why = unusable.find(run); why != unusable.end())
      throw MissingData(fmt::format("run `{}`: {}", run, why->second));
    const auto known = readers.find(run);
    if (known != readers.end())
      return *known->second;
    if (const std::string why = replaced_record(folder + "/" + run); !why.empty())
      throw MissingData(fmt::format("run `{}`: {}", run, why));
    try
    {
      return *(readers[run] = std::make_unique<record::Reader>(path(run)));
    }
    catch (const std::runtime_error &error)
    {
      readers.erase(run);
      throw MissingData(
          fmt::format("run `{}`: {}; --fresh repeats finished runs", run, error.what()));
    }
  }
} // namespace verify
