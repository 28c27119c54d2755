// What the cases declare can be read: their checks, their trades and their maps of stability.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "expect.h"
#include "paths.h"
#include "scene/reader.h"
#include "section.h"
#include "stability_cells.h"
#include "trade_default.h"

namespace fs = std::filesystem;

namespace
{
  // Calls read(folder) for every case that has the file; how many that were.
  template <class Read>
  int read_all(const std::string &file, const Read &read)
  {
    verify::Paths places;
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

  /// What the scene language says against a run's settings; "" if nothing.
  std::string refusal(const std::string &folder, const std::string &scene,
                      const std::vector<std::string> &set)
  {
    try
    {
      scene::read_scene(folder + "/" + scene, set);
    }
    catch (const scene::BadScene &error)
    {
      return error.what();
    }
    return "";
  }

  /// Every cell of the maps of a suite: visit(case, map, settings of the cell).
  template <class Visit>
  void visit_cells(const std::string &suite, const Visit &visit)
  {
    read_all("stability.toml",
             [&](const std::string &folder)
             {
               const auto maps = verify::read_stability(folder, suite).maps;
               for (const auto &map : maps)
                 for (const auto &x : map.x.values)
                   for (const auto &y : map.rows())
                   {
                     auto set = map.set;
                     for (const auto &setting : map.x.set)
                       set.push_back(verify::with_value(setting, x));
                     for (const auto &setting : map.y.set)
                       set.push_back(verify::with_value(setting, y));
                     visit(folder, map, set);
                   }
             });
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
              30)
        << suite;
}

TEST(Cases, EveryCaseIsMapped)
{
  const int cases = read_all("expect.toml",
                             [](const std::string &folder)
                             {
                               EXPECT_TRUE(fs::exists(folder + "/stability.toml")) << folder;
                               if (fs::exists(folder + "/stability.toml"))
                               {
                                 EXPECT_FALSE(verify::read_stability(folder, "full").maps.empty())
                                     << folder;
                               }
                             });
  EXPECT_GT(cases, 30);
}

// One class alone is no map: some cell of every map must have a neighbour to differ from, and
// something must be asked of it, or none of its cells could be called accurate.
TEST(Cases, EveryMapHasCellsToCompareAndAsksSomethingOfThem)
{
  read_all("stability.toml",
           [](const std::string &folder)
           {
             const verify::Stability declared = verify::read_stability(folder, "full");
             for (const auto &map : declared.maps)
             {
               EXPECT_GE(map.x.values.size() * map.rows().size(), 3u) << folder << ": " << map.name;
               const auto asks = [&map](const verify::Accurate &accurate)
               {
                 const auto &maps = accurate.maps;
                 return maps.empty() || std::count(maps.begin(), maps.end(), map.name) > 0;
               };
               EXPECT_TRUE(std::any_of(declared.accurate.begin(), declared.accurate.end(), asks))
                   << folder << ": " << map.name;
             }
             // A check for a map that does not exist asks nothing of anything.
             for (const auto &accurate : declared.accurate)
               for (const auto &name : accurate.maps)
                 EXPECT_TRUE(std::any_of(declared.maps.begin(), declared.maps.end(),
                                         [&name](const verify::Map &map)
                                         { return map.name == name; }))
                     << folder << ": " << accurate.check.name << " names " << name;
           });
}

// A key that is gone makes every row that sets it a refused one, which no campaign of checks sees.
TEST(Cases, SettingsOfTradesAreOfTheSceneLanguage)
{
  int rows = 0;
  read_all("expect.toml",
           [&](const std::string &folder)
           {
             verify::Trade trade;
             try
             {
               trade = fs::exists(folder + "/tradeoff.toml") ? verify::read_trade(folder)
                                                             : verify::default_trade(folder);
             }
             catch (const verify::BadInput &) // nothing to trade, or the test above tells it
             {
               return;
             }
             for (const auto &run : trade.c.runs)
               EXPECT_EQ(refusal(folder, run.scene, run.set), "") << folder << ": " << run.name;
             rows += static_cast<int>(trade.c.runs.size());
           });
  EXPECT_GT(rows, 100);
}

TEST(Cases, SettingsOfRunsAreOfTheSceneLanguage)
{
  for (const char *suite : {"smoke", "quick", "full"})
    read_all("expect.toml",
             [&](const std::string &folder)
             {
               if (verify::takes_part(folder, suite))
                 for (const auto &run : verify::read_case(folder, suite).runs)
                   if (run.expect_exit == 0)
                   {
                     EXPECT_EQ(refusal(folder, run.scene, run.set), "")
                         << folder << ": " << run.name;
                   }
             });
}

// A cell may be refused, that is a class; but for its value, never for its key.
TEST(Cases, SettingsOfMapsAreOfTheSceneLanguage)
{
  for (const char *suite : {"quick", "full"})
    visit_cells(
        suite,
        [](const std::string &folder, const verify::Map &map, const std::vector<std::string> &set)
        {
          const std::string text = refusal(folder, map.scene, set);
          EXPECT_EQ(text.find("there is no"), std::string::npos)
              << folder << ": " << map.name << "\n"
              << text;
        });
}

TEST(Cases, MapsHaveAsManyCellsAsIsPromised)
{
  const auto count = [](const char *suite)
  {
    int cells = 0;
    visit_cells(suite, [&](const auto &...) { ++cells; });
    return cells;
  };
  EXPECT_GE(count("full"), 600);
  // Continuous integration has minutes for them.
  EXPECT_GE(count("quick"), 60);
  EXPECT_LE(count("quick"), 90);
}
