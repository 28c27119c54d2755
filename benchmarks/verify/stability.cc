// verify stability: classes over declared axes, and the edge of stability by bisection.
#include <filesystem>

#include <fmt/format.h>

#include "campaign_files.h"
#include "commands.h"
#include "record/command_line.h"
#include "record/provenance.h"
#include "section.h"
#include "stability_edges.h"

namespace verify
{
  namespace fs = std::filesystem;
  namespace
  {
    Json axis_to_json(const Axis &axis)
    {
      return {{"label", axis.label},
              {"values", axis.values},
              {"set", axis.set},
              {"logarithmic", axis.logarithmic}};
    }

    Json cells_to_json(const std::vector<Cell> &cells)
    {
      Json list = Json::array();
      for (const auto &cell : cells)
        list.push_back({{"column", cell.column},
                        {"row", cell.row},
                        {"x", cell.x},
                        {"y", cell.y},
                        {"class", cell.kind},
                        {"why", cell.why},
                        {"exit_code", cell.outcome.exit_code},
                        {"wall_s", cell.outcome.wall_s},
                        {"cpu_s", cell.outcome.cpu_s},
                        {"repeat", shell(cell.job.command.arguments)}});
      return list;
    }

    Json map_to_json(const Mapper &mapper, const Map &map, const std::size_t number)
    {
      auto cells = mapper.grid(map, number);
      mapper.run(cells);
      std::vector<Cell> bisected;
      const auto edges = find_edges(mapper, map, number, cells, bisected);
      Json json{{"name", map.name}, {"x", axis_to_json(map.x)}, {"y", axis_to_json(map.y)}};
      json["cells"] = cells_to_json(cells);
      json["edges"] = Json::array();
      for (const auto &edge : edges)
        json["edges"].push_back({{"row", edge.row},
                                 {"stable", edge.stable},
                                 {"unstable", edge.unstable},
                                 {"edge", edge.middle()},
                                 {"stopped", edge.stopped},
                                 {"theory", number_or_null(edge.theory)},
                                 {"ratio", number_or_null(edge.ratio())}});
      json["bisected"] = cells_to_json(bisected);
      for (auto &cell : json["bisected"])
        cell.erase("column"); // it lies between two
      if (map.edge)
        json["edge_bounds"] = *map.edge;
      json["broken"] = broken_bounds(map, cells, edges, mapper.stability.c.constants);
      return json;
    }

    void print_map(const Json &map)
    {
      fmt::print("\n{}: {} across, {} down\n", map["name"].get<std::string>(),
                 map["x"]["label"].get<std::string>(), map["y"]["label"].get<std::string>());
      for (const auto &cell : map["cells"])
        fmt::print("  {:>14} {:>14}  {}\n", cell["x"].get<std::string>(),
                   cell["y"].get<std::string>(), cell["class"].get<std::string>());
      for (const auto &edge : map["edges"])
        fmt::print("  edge in row {}: stable at {:.5g}, not at {:.5g}{}\n", edge["row"].get<int>(),
                   edge["stable"].get<double>(), edge["unstable"].get<double>(),
                   edge["ratio"].is_null()
                       ? ""
                       : fmt::format("; {:.4g} of the theoretical limit {:.5g}",
                                     edge["ratio"].get<double>(), edge["theory"].get<double>()));
      for (const auto &edge : map["edges"])
        if (const std::string stopped = edge["stopped"]; !stopped.empty())
          fmt::print("  edge in row {}: no finer, what lies between is {}\n",
                     edge["row"].get<int>(), stopped);
      for (const std::string sentence : map["broken"])
        fmt::print("  outside its bounds: {}\n", sentence);
    }

    /// A map of which no cell came to a class of stability.
    bool says_nothing(const Json &map)
    {
      for (const auto &cell : map["cells"])
        if (const std::string kind = cell["class"];
            kind != "refused" && kind != "not judged" && kind != "out of time")
          return false;
      fmt::print("map `{}` says nothing: all its cells were refused, not judged or out of time\n",
                 map["name"].get<std::string>());
      return true;
    }
  } // namespace

  int stability(const Paths &paths, const CampaignOptions &options)
  {
    const record::Lock lock = lock_output(options.output);
    int cells = 0, bad_maps = 0;
    for (const auto &name : chosen_cases(options.cases, paths))
    {
      const std::string folder = case_folder(paths, name);
      if (!fs::exists(folder + "/stability.toml"))
      {
        if (!options.cases.empty())
          throw BadInput(fmt::format("{} holds no stability.toml", folder));
        continue;
      }
      const Stability declared = read_stability(folder, options.suite);
      if (declared.maps.empty())
        continue;
      const Mapper mapper{declared, paths, options, options.output + "/stability/runs"};
      Json result{{"format", "mpm_pf stability 1"}, {"case", name}, {"suite", options.suite}};
      for (const auto &[key, value] : record::collect_provenance(
               "verify", shell({paths.program, "stability", name}), options.cores))
        result["provenance"][key] = value;
      result["maps"] = Json::array();
      for (std::size_t k = 0; k < declared.maps.size(); ++k)
      {
        result["maps"].push_back(map_to_json(mapper, declared.maps[k], k + 1));
        if (interrupted())
          return record::interrupted;
        print_map(result["maps"].back());
        bad_maps +=
            says_nothing(result["maps"].back()) || !result["maps"].back()["broken"].empty() ? 1 : 0;
        cells += static_cast<int>(result["maps"].back()["cells"].size());
      }
      write_text(options.output + "/stability/" + name + ".json", json_text(result));
    }
    fmt::print("\n{} cells in {}/stability\n", cells, options.output);
    if (cells > 0)
      report(paths, options.output);
    return cells == 0 ? 4 : bad_maps > 0 ? 1 : 0;
  }
} // namespace verify
