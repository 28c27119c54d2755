#include "measure.h"

#include <fmt/format.h>

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
    auto &reader = readers[run];
    if (!reader)
      try
      {
        reader = std::make_unique<record::Reader>(path(run));
      }
      catch (const std::runtime_error &error)
      {
        readers.erase(run);
        throw MissingData(fmt::format("run `{}`: {}", run, error.what()));
      }
    return *reader;
  }
} // namespace verify
