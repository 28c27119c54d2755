// What the cases declare can be read: their checks, their trades and their maps of stability.
#include <filesystem>

#include <gtest/gtest.h>

#include "expect.h"
#include "places.h"
#include "section.h"
#include "stability_file.h"
#include "trade_file.h"

namespace fs = std::filesystem;

namespace
{
  // Calls read(folder) for every case that has the file; how many that were.
  template <class Read>
  int read_all(const std::string &file, const Read &read)
  {
    verify::Places places;
    places.cases = CASES;
    int count = 0;
    for (const std::string &name : verify::case_names(places))
      if (const std::string folder = verify::case_folder(places, name);
          fs::exists(fs::path(folder) / file))
        try
        {
          ++count;
          read(folder);
        }
        catch (const verify::BadInput &error)
        {
          ADD_FAILURE() << error.what();
        }
    return count;
  }
} // namespace

TEST(Cases, ChecksCanBeReadInEverySuite)
{
  for (const char *suite : {"smoke", "quick", "full"})
  {
    int checks = 0;
    read_all("expect.toml",
             [&](const std::string &folder)
             {
               if (verify::takes_part(folder, suite))
                 checks += static_cast<int>(verify::read_case(folder, suite).checks.size());
             });
    EXPECT_GT(checks, 20) << suite;
  }
}

TEST(Cases, TradesCanBeRead)
{
  EXPECT_GT(
      read_all("tradeoff.toml", [](const std::string &folder) { verify::read_trade(folder); }), 20);
}

TEST(Cases, MapsOfStabilityCanBeRead)
{
  for (const char *suite : {"quick", "full"})
    EXPECT_GT(read_all("stability.toml",
                       [&](const std::string &folder) { verify::read_stability(folder, suite); }),
              8)
        << suite;
}
