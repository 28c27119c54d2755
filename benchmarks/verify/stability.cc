// verify stability: classes over declared axes, and the edge of stability by bisection.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "commands.h"
#include "record/provenance.h"
#include "section.h"
#include "stability_cells.h"
#include "written.h"

namespace verify
{
  namespace fs = std::filesystem;
  namespace
  {
    struct Edge
    {
      std::size_t row = 0;
      double stable = 0., unstable = 0.;
      std::string stopped; // class of a cell between the two that is neither: no finer edge
    };

    /// Neighbouring cells of each row, one stable and one not, whose x are numbers.
    std::vector<Edge> edges_of(const std::vector<Cell> &cells)
    {
      std::vector<Edge> edges;
      for (std::size_t k = 1; k < cells.size(); ++k)
      {
        const Cell &a = cells[k - 1], &b = cells[k];
        const bool crossing = (a.stable() && b.unstable()) || (a.unstable() && b.stable());
        char *end_a = nullptr, *end_b = nullptr;
        const double x_a = std::strtod(a.x.c_str(), &end_a), x_b = std::strtod(b.x.c_str(), &end_b);
        if (a.row == b.row && crossing && *end_a == '\0' && *end_b == '\0')
          edges.push_back({a.row, a.stable() ? x_a : x_b, a.stable() ? x_b : x_a, {}});
      }
      return edges;
    }

    void bisect(const Mapper &mapper, const Map &map, const std::size_t number,
                std::vector<Edge> &edges)
    {
      for (int k = 0; k < map.bisections && !interrupted(); ++k)
      {
        std::vector<Cell> cells;
        std::vector<Edge *> open;
        for (auto &edge : edges)
        {
          if (!edge.stopped.empty())
            continue;
          open.push_back(&edge);
          const double middle = map.x.logarithmic ? std::sqrt(edge.stable * edge.unstable)
                                                  : 0.5 * (edge.stable + edge.unstable);
          std::string x = fmt::format("{:.6g}", middle);
          if (x.find_first_of(".e") == std::string::npos)
            x += ".0";
          cells.push_back(
              mapper.cell(map, number, x, map.y.values.empty() ? "" : map.y.values[edge.row]));
        }
        if (open.empty())
          return;
        mapper.run(cells);
        for (std::size_t i = 0; i < open.size(); ++i)
          if (cells[i].judged())
            (cells[i].unstable() ? open[i]->unstable : open[i]->stable) = std::stod(cells[i].x);
          else
            open[i]->stopped = cells[i].kind;
      }
    }

    Json axis_to_json(const Axis &axis)
    {
      return {{"label", axis.label}, {"values", axis.values}, {"set", axis.set}};
    }

    Json edge_to_json(const Edge &edge, const Map &map, const Constants &constants)
    {
      Json json{{"row", edge.row},           {"stable", edge.stable},
                {"unstable", edge.unstable}, {"edge", 0.5 * (edge.stable + edge.unstable)},
                {"stopped", edge.stopped},   {"theory", nullptr}};
      if (map.theory.empty())
        return json;
      Constants known = constants;
      const auto add = [&known](const std::string &name, const std::string &text)
      {
        char *end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        if (*end == '\0')
          known.emplace_back(name, value);
      };
      const std::string y = map.y.values.empty() ? "0" : map.y.values[edge.row];
      add("y", y);
      int k = 0;
      for (const auto &entry : entries_of(y))
        add("y" + std::to_string(k++), entry);
      json["theory"] = evaluate(map.theory, known);
      return json;
    }

    Json map_to_json(const Mapper &mapper, const Map &map, const std::size_t number)
    {
      auto cells = mapper.grid(map, number);
      mapper.run(cells);
      auto edges = edges_of(cells);
      bisect(mapper, map, number, edges);
      Json json{{"name", map.name}, {"x", axis_to_json(map.x)}, {"y", axis_to_json(map.y)}};
      json["cells"] = Json::array();
      json["edges"] = Json::array();
      for (const auto &cell : cells)
        json["cells"].push_back({{"column", cell.column},
                                 {"row", cell.row},
                                 {"x", cell.x},
                                 {"y", cell.y},
                                 {"class", cell.kind},
                                 {"why", cell.why},
                                 {"exit_code", cell.outcome.exit_code},
                                 {"wall_s", cell.outcome.wall_s},
                                 {"cpu_s", cell.outcome.cpu_s},
                                 {"repeat", shell(cell.job.command.arguments)}});
      for (const auto &edge : edges)
        json["edges"].push_back(edge_to_json(edge, map, mapper.stability.c.constants));
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
        fmt::print("  edge in row {}: stable at {:.5g}, not at {:.5g}\n", edge["row"].get<int>(),
                   edge["stable"].get<double>(), edge["unstable"].get<double>());
      for (const auto &edge : map["edges"])
        if (const std::string stopped = edge["stopped"]; !stopped.empty())
          fmt::print("  edge in row {}: no finer, what lies between is {}\n",
                     edge["row"].get<int>(), stopped);
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

  int stability(const Places &places, const CampaignOptions &options)
  {
    int cells = 0, empty_maps = 0;
    for (const auto &name : options.cases.empty() ? case_names(places) : options.cases)
    {
      const std::string folder = case_folder(places, name);
      if (!fs::exists(folder + "/stability.toml"))
      {
        if (!options.cases.empty())
          throw BadInput(fmt::format("{} holds no stability.toml", folder));
        continue;
      }
      const Stability declared = read_stability(folder, options.suite);
      if (declared.maps.empty())
        continue;
      const Mapper mapper{declared, places, options, options.output + "/stability/runs"};
      Json result{{"format", "mpm_pf stability 1"}, {"case", name}, {"suite", options.suite}};
      for (const auto &[key, value] :
           record::collect("verify", shell({places.program, "stability", name}), options.cores))
        result["provenance"][key] = value;
      result["maps"] = Json::array();
      for (std::size_t k = 0; k < declared.maps.size(); ++k)
      {
        result["maps"].push_back(map_to_json(mapper, declared.maps[k], k + 1));
        if (interrupted())
          return 130;
        print_map(result["maps"].back());
        empty_maps += says_nothing(result["maps"].back()) ? 1 : 0;
        cells += static_cast<int>(result["maps"].back()["cells"].size());
      }
      write_text(options.output + "/stability/" + name + ".json",
                 result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
    }
    fmt::print("\n{} cells in {}/stability\n", cells, options.output);
    if (cells > 0)
      report(places, options.output);
    return cells == 0 ? 4 : empty_maps > 0 ? 1 : 0;
  }
} // namespace verify
