#include "stability_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace verify
{
  namespace
  {
    std::optional<double> as_number(const std::string &text)
    {
      char *end = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      return !text.empty() && *end == '\0' ? std::optional<double>(value) : std::nullopt;
    }

    std::optional<double> theory_of(const Map &map, const std::size_t row,
                                    const Constants &constants)
    {
      const std::string y = map.rows()[row];
      const bool word = y.size() > 1 && y.front() == '"';
      auto found = word ? map.theory.find(y.substr(1, y.size() - 2)) : map.theory.end();
      if (found == map.theory.end())
        found = map.theory.find("");
      if (found == map.theory.end())
        return {};
      Constants known = constants;
      const auto add = [&known](const std::string &name, const std::string &text)
      {
        if (const auto value = as_number(text))
          known.emplace_back(name, *value);
      };
      add("y", y.empty() ? "0" : y);
      int k = 0;
      for (const auto &entry : entries_of(y))
        add("y" + std::to_string(k++), entry);
      return evaluate(found->second, known);
    }

    void bisect(const Mapper &mapper, const Map &map, const std::size_t number,
                std::vector<Edge> &edges, std::vector<Cell> &bisected)
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
          const bool logarithmic = map.x.logarithmic && edge.stable * edge.unstable > 0.;
          const double middle =
              logarithmic ? std::sqrt(edge.stable * edge.unstable) : edge.middle();
          std::string x = fmt::format("{:.6g}", middle);
          if (x.find_first_of(".e") == std::string::npos)
            x += ".0";
          cells.push_back(mapper.cell(map, number, x, map.rows()[edge.row]));
          cells.back().row = edge.row;
        }
        if (open.empty())
          return;
        mapper.run(cells);
        for (std::size_t i = 0; i < open.size(); ++i)
          if (cells[i].judged())
            (cells[i].unstable() ? open[i]->unstable : open[i]->stable) = std::stod(cells[i].x);
          else
            open[i]->stopped = cells[i].kind;
        bisected.insert(bisected.end(), cells.begin(), cells.end());
      }
    }

    /// What a row without an edge says against the bounds, "" if nothing.
    std::string beyond_bounds(const std::vector<Cell> &cells, const std::size_t row,
                              const double low, const double high)
    {
      double first = INFINITY, last = -INFINITY;
      bool any_stable = false, any_unstable = false;
      for (const auto &cell : cells)
        if (const auto x = as_number(cell.x); cell.row == row && cell.judged() && x)
        {
          first = std::min(first, *x);
          last = std::max(last, *x);
          (cell.stable() ? any_stable : any_unstable) = true;
        }
      if (any_stable && !any_unstable && last > high)
        return fmt::format("stable up to {:.5g}", last);
      if (any_unstable && !any_stable && first < low)
        return fmt::format("unstable from {:.5g} on", first);
      return "";
    }
  } // namespace

  std::optional<double> Edge::ratio() const
  {
    return theory && *theory != 0. ? std::optional<double>(middle() / *theory) : std::nullopt;
  }

  std::vector<Edge> find_edges(const Mapper &mapper, const Map &map, const std::size_t number,
                               const std::vector<Cell> &cells, std::vector<Cell> &bisected)
  {
    std::vector<Edge> edges;
    for (std::size_t k = 1; k < cells.size(); ++k)
    {
      const Cell &a = cells[k - 1], &b = cells[k];
      const bool crossing = (a.stable() && b.unstable()) || (a.unstable() && b.stable());
      const auto x_a = as_number(a.x), x_b = as_number(b.x);
      if (a.row == b.row && crossing && x_a && x_b)
        edges.push_back({a.row, a.stable() ? *x_a : *x_b, a.stable() ? *x_b : *x_a, {}, {}});
    }
    bisect(mapper, map, number, edges, bisected);
    for (auto &edge : edges)
      edge.theory = theory_of(map, edge.row, mapper.stability.c.constants);
    return edges;
  }

  std::vector<std::string> broken_bounds(const Map &map, const std::vector<Cell> &cells,
                                         const std::vector<Edge> &edges, const Constants &constants)
  {
    std::vector<std::string> broken;
    if (!map.edge)
      return broken;
    const auto [low, high] = *map.edge;
    for (std::size_t row = 0; row < map.rows().size(); ++row)
    {
      const auto theory = theory_of(map, row, constants);
      if (!theory)
        continue;
      std::vector<std::string> said;
      bool any_edge = false;
      for (const auto &edge : edges)
        if (edge.row == row)
        {
          any_edge = true;
          if (const auto ratio = edge.ratio(); !ratio || *ratio < low || *ratio > high)
            said.push_back(fmt::format("the edge at {:.5g}", edge.middle()));
        }
      if (const std::string text = beyond_bounds(cells, row, low * *theory, high * *theory);
          !any_edge && !text.empty())
        said.push_back(text);
      for (const auto &text : said)
        broken.push_back(fmt::format("row {} ({}): {}, and the theoretical limit is {:.5g}, of "
                                     "which the edge must lie between {:.3g} and {:.3g}",
                                     row, map.rows()[row], text, *theory, low, high));
    }
    return broken;
  }
} // namespace verify
