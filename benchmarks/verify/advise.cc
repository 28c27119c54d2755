// verify advise: the cheapest measured settings that meet an error, with the evidence; never an
// extrapolation.
#include <algorithm>
#include <fstream>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "campaign_files.h"
#include "commands.h"
#include "record/command_line.h"
#include "record/provenance.h"
#include "section.h"

namespace verify
{
  namespace
  {
    constexpr double margin =
        1.25; // the measured error must be this much better than what is asked

    double error_wanted(const std::string &text)
    {
      std::size_t used = 0;
      double value = 0.;
      try
      {
        value = std::stod(text, &used);
      }
      catch (const std::exception &)
      {
      }
      const std::string rest = text.substr(used);
      if (!(value > 0.) || (!rest.empty() && rest != "%"))
        throw BadInput(fmt::format(
            "--error {}: give a number or a percentage above 0, like 0.02 or 2%", text));
      return rest == "%" ? value / 100. : value;
    }

    /// "tip, relative" for --quantity tip (its first norm) or --quantity "tip, relative".
    std::string measure_named(const Json &trade, const std::string &wanted)
    {
      std::string known;
      for (const std::string name : trade.at("measures"))
      {
        if (name == wanted || name.substr(0, name.rfind(", ")) == wanted)
          return name;
        known += "\n  " + name;
      }
      throw BadInput(fmt::format("no quantity `{}` was measured; there are:{}", wanted, known));
    }

    std::string one_line(const Json &row, const std::string &measure)
    {
      std::string settings;
      for (const std::string setting : row.at("set"))
        settings += " " + setting;
      return fmt::format("{:9.3g} error {:9.3g} s CPU  {}:{}",
                         row.at("errors").at(measure).get<double>(), row.at("cpu_s").get<double>(),
                         row.at("family").get<std::string>(), settings);
    }

    /// Settings as TOML, one section per table.
    std::string fragment(const Json &row)
    {
      std::map<std::string, std::string> sections;
      std::string dropped;
      for (const std::string setting : row.at("set"))
      {
        if (setting.back() == '=') // a key that was taken away
        {
          dropped += " " + setting.substr(0, setting.size() - 1);
          continue;
        }
        const auto equal = setting.find('='), dot = setting.rfind('.', equal);
        const std::string section = dot == std::string::npos ? "" : setting.substr(0, dot);
        const std::size_t key = dot == std::string::npos ? 0 : dot + 1;
        sections[section] +=
            setting.substr(key, equal - key) + " = " + setting.substr(equal + 1) + "\n";
      }
      std::string text = dropped.empty() ? "" : "# without" + dropped + "\n";
      for (const auto &[section, lines] : sections)
        text += (section.empty() ? "" : "[" + section + "]\n") + lines;
      return text;
    }

    /// Measured rows by cost, cheapest first, of one solver.
    std::vector<Json> by_cost(const Json &trade, const std::string &measure,
                              const std::string &solver)
    {
      std::vector<Json> rows;
      for (const auto &row : trade.at("rows"))
        if (row.at("solver") == solver && row.at("errors").at(measure).is_number())
          rows.push_back(row);
      std::sort(rows.begin(), rows.end(),
                [](const Json &a, const Json &b) { return a.at("cpu_s") < b.at("cpu_s"); });
      return rows;
    }

    const Json *cheapest(const std::vector<Json> &rows, const std::string &measure,
                         const double error)
    {
      for (const auto &row : rows)
        if (row.at("errors").at(measure).get<double>() <= error)
          return &row;
      return nullptr;
    }

    void print_advice(const std::vector<Json> &rows, const Json &best, const std::string &measure)
    {
      fmt::print("# {}\n{}\nevidence\n  {}\n", one_line(best, measure), fragment(best),
                 one_line(best, measure));
      const Json *cheaper = nullptr;
      for (const auto &row : rows)
      {
        if (&row == &best)
          break;
        cheaper = &row;
      }
      if (cheaper)
        fmt::print("next cheaper, fails\n  {}\n", one_line(*cheaper, measure));
      else
        fmt::print("nothing cheaper was measured\n");
      fmt::print("repeat with\n  {}\n", best.at("repeat").get<std::string>());
    }

    /// Of the reference of a measure: 0 of a theory, nothing of a run without grids.
    std::optional<double> uncertainty_of(const Json &trade, const std::string &measure)
    {
      const auto &known = trade.at("reference").at("uncertainty");
      if (!known.contains(measure))
        return 0.;
      return known.at(measure).is_null() ? std::nullopt
                                         : std::optional<double>(known.at(measure).get<double>());
    }

    /// When and with which program it was measured; a warning if this is another one.
    void print_origin(const Json &trade, const Paths &paths, const std::string &name,
                      const std::string &output)
    {
      const Json &made = trade.value("provenance", Json::object());
      const std::string commit = made.value("commit", "unknown"),
                        present = record::collect_provenance("verify", "", 1).at("commit");
      fmt::print("measured {}, commit {}\n", made.value("start", "at an unknown time"), commit);
      if (commit != present)
        fmt::print("warning: this program is of commit {}; measure again with\n  {} tradeoff {} "
                   "--output {}\n",
                   present, paths.program, name, output);
    }
  } // namespace

  int advise(const Paths &paths, const AdviceRequest &request)
  {
    const auto &[name, quantity, error, output] = request;
    case_folder(paths, name);
    const double wanted = error_wanted(error);
    const std::string file = output + "/tradeoff/" + name + ".json";
    std::ifstream stream(file);
    const Json trade = stream ? Json::parse(stream, nullptr, false) : Json();
    if (!trade.is_object())
    {
      fmt::print(stderr, "{} {}, with\n  {} tradeoff {} --output {}\n", file,
                 stream ? "cannot be read: measure again" : "is missing: measure first",
                 paths.program, name, output);
      return record::reference_missing;
    }
    const std::string measure = measure_named(trade, quantity);
    print_origin(trade, paths, name, output);
    const std::optional<double> uncertainty = uncertainty_of(trade, measure);
    fmt::print("{}: {} at most {:.3g}; margin {}, uncertainty of the reference {}\n", name, measure,
               wanted, margin, uncertainty ? fmt::format("{:.2g}", *uncertainty) : "unknown");
    if (!uncertainty)
      fmt::print(
          "warning: errors are distances from one run whose own error nobody measured; three "
          "or more [[reference]] would tell it\n");
    const double allowed = wanted / margin - uncertainty.value_or(0.);
    if (allowed > 0.)
      fmt::print("so a measured error of at most {:.2g} meets it\n", allowed);
    else
      fmt::print("so the reference is too uncertain to say that anything meets it\n");
    const auto points = by_cost(trade, measure, "mpm_pf"),
               elements = by_cost(trade, measure, "fe_reference");
    const Json *best = cheapest(points, measure, allowed),
               *fe = cheapest(elements, measure, allowed);
    if (best)
      print_advice(points, *best, measure);
    else
    {
      double smallest = -1.;
      for (const auto &row : points)
        if (const double e = row.at("errors").at(measure); smallest < 0. || e < smallest)
          smallest = e;
      fmt::print("no measured setting of mpm_pf meets it; the smallest measured error is {}. "
                 "Nothing is extrapolated.\n",
                 smallest < 0. ? "none" : fmt::format("{:.3g}", smallest));
    }
    if (fe && (!best || fe->at("cpu_s").get<double>() < best->at("cpu_s").get<double>()))
      fmt::print("finite elements are the better tool here:\n  {}\n", one_line(*fe, measure));
    return best ? 0 : 1;
  }
} // namespace verify
