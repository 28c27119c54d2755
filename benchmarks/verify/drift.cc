#include "drift.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "forecasts.h"
#include "record/atomic_write.h"
#include "section.h"

namespace verify
{
  namespace
  {
    using Values = std::map<std::string, double>;

    std::string path_of(const Case &c)
    {
      return c.folder + "/accepted.toml";
    }

    Values accepted_values(const Case &c, const std::string &suite)
    {
      Values values;
      if (!std::filesystem::exists(path_of(c)))
        return values;
      Section file(path_of(c), suite);
      if (auto table = file.section(suite))
        for (const auto &name : table->keys())
        {
          const auto value = table->number(name);
          if (value && !std::isfinite(*value))
            table->add_error(name, fmt::format("a value of {} cannot have been accepted", *value),
                             "take the line out; --accept writes it anew");
          values[name] = value.value_or(0.);
        }
      file.throw_errors();
      return values;
    }

    /// How far a check's value may lie from the accepted one, whose magnitude is `accepted`.
    /// Rounding is another one with another compiler, so a check that asks for nothing but
    /// rounding, by its limit, drifts when it grows tenfold. Any other value is as large elsewhere;
    /// one that nearly vanishes is the difference of larger numbers, of which its tolerance is a
    /// part.
    double tolerance(const Check &check, const double accepted)
    {
      constexpr double rounding = 1e-6, tenfold = 9., nearly_zero = 0.05;
      const double limit = std::max(std::abs(check.low), std::abs(check.high));
      if (limit <= rounding)
        return std::max(std::max(tenfold, check.drift) * accepted, 1e-3 * limit);
      const double part = accepted < nearly_zero * limit ? 5e-3 : 1e-3;
      return std::max(check.drift * accepted, part * limit);
    }

    std::string quoted(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : text)
        if (const auto code = static_cast<unsigned char>(c); code < 32 || code == 127)
          result += fmt::format("\\u{:04x}", code); // a line's end would end the key
        else
          result += (c == '"' || c == '\\') ? std::string("\\") + c : std::string(1, c);
      return result + "\"";
    }
  } // namespace

  void check_accepted(const std::string &folder)
  {
    Case c;
    c.folder = folder;
    std::set<std::string> errors; // one that is no TOML is the same for every suite
    for (const char *suite : {"smoke", "quick", "full"})
      try
      {
        accepted_values(c, suite);
      }
      catch (const BadInput &error)
      {
        errors.insert(error.what());
      }
    if (!errors.empty())
      throw BadInput(fmt::format("{}\n", fmt::join(errors, "\n")));
  }

  void compare_with_accepted(std::vector<Verdict> &verdicts, const Case &c)
  {
    const Values values = accepted_values(c, c.suite);
    for (auto &verdict : verdicts)
    {
      const auto found = values.find(verdict.check.name);
      verdict.drift.unknown = found == values.end() && verdict.value;
      if (found == values.end() || !verdict.value)
        continue;
      verdict.drift.accepted = found->second;
      verdict.drift.tolerance = tolerance(verdict.check, std::abs(found->second));
      verdict.drift.drifted = std::abs(*verdict.value - found->second) > verdict.drift.tolerance;
    }
  }

  void accept(const std::vector<Verdict> &verdicts, const Case &c)
  {
    std::map<std::string, Values> all;
    for (const char *suite : {"smoke", "quick", "full"})
      all[suite] = accepted_values(c, suite);
    Values kept; // what did not pass, or had no program or reference here, keeps its old value
    for (const auto &verdict : verdicts)
      if (is_forecast(verdict))
        continue; // it has no drift: the machine decides
      else if (const auto old = all[c.suite].find(verdict.check.name);
               verdict.status == Status::pass)
        kept[verdict.check.name] = *verdict.value;
      else if (old != all[c.suite].end())
        kept.insert(*old);
    all[c.suite] = kept;
    std::string file =
        "# Last accepted values of the checks, written by `verify run --accept`; a change is "
        "reported as drift.\n";
    for (const auto &[suite, values] : all)
      if (!values.empty())
      {
        file += "\n[" + suite + "]\n";
        for (const auto &[name, value] : values)
        {
          std::string number = fmt::format("{:.6g}", value);
          if (number.find_first_of(".en") == std::string::npos)
            number += ".0";
          file += quoted(name) + " = " + number + "\n";
        }
      }
    record::write_atomically(path_of(c), file);
  }

  void accept(const Campaign &campaign)
  {
    std::string errors;
    for (const auto &result : campaign.cases)
      try
      {
        accept(result.verdicts, result.c);
      }
      catch (const std::filesystem::filesystem_error &error)
      {
        errors += fmt::format("{} cannot be written: {}; its accepted values are the old ones\n",
                              path_of(result.c), error.code().message());
      }
    if (!errors.empty())
      throw BadInput(errors);
  }
} // namespace verify
