// JUnit XML with the numbers as properties (CTest's own writer drops them).
#include <fmt/format.h>

#include "campaign_files.h"

namespace verify
{
  namespace
  {
    std::string escaped(const std::string &text)
    {
      std::string result;
      for (const char c : as_utf8(text))
        switch (c)
        {
        case '<':
          result += "&lt;";
          break;
        case '>':
          result += "&gt;";
          break;
        case '&':
          result += "&amp;";
          break;
        case '"':
          result += "&quot;";
          break;
        default: // control characters are not allowed in XML
          result += static_cast<unsigned char>(c) < 32 && c != '\n' && c != '\t' ? ' ' : c;
        }
      return result;
    }

    std::string property(const std::string &name, const std::string &value)
    {
      return fmt::format("        <property name=\"{}\" value=\"{}\"/>\n", name, escaped(value));
    }
    std::string property(const std::string &name, const std::optional<double> &value)
    {
      return value ? property(name, fmt::format("{:.10g}", *value)) : "";
    }

    std::string test_case(const Verdict &v, const Case &c, const std::string &repeat)
    {
      std::string text = fmt::format(
          "    <testcase classname=\"{}\" name=\"{}\" time=\"0\">\n      <properties>\n",
          escaped(c.name), escaped(v.check.name));
      text += property("value", v.value) + property("low", v.check.low) +
              property("high", v.check.high) + property("uncertainty", v.uncertainty) +
              property("unit", value_unit(v.check)) + property("norm", v.check.norm) +
              property("accepted", v.drift.accepted) + property("source", v.check.source);
      text += "      </properties>\n";
      if (v.status == Status::no_reference)
        text += fmt::format("      <error message=\"no reference\">{}</error>\n", escaped(v.why));
      else if (v.status != Status::pass)
        text += fmt::format("      <failure message=\"{}\">{}\nrepeat with: {}</failure>\n",
                            escaped(verify::text(v.status)), escaped(v.why), escaped(repeat));
      return text + "    </testcase>\n";
    }

    std::string test_case(const Run &run, const Job &job, const Outcome &outcome, const Case &c)
    {
      std::string text = fmt::format(
          "    <testcase classname=\"{}\" name=\"run {}\" time=\"{:.3f}\">\n      <properties>\n",
          escaped(c.name), escaped(run.name), outcome.wall_s);
      text += property("cpu_s", outcome.cpu_s) +
              property("peak_rss_bytes", outcome.peak_rss_bytes) +
              property("exit_code", static_cast<double>(outcome.exit_code));
      text += "      </properties>\n";
      if (!outcome.good())
        text += fmt::format("      <error message=\"{}\">{}\nrepeat with: {}</error>\n",
                            escaped(outcome.status), escaped(outcome.log_tail),
                            escaped(shell(job.command.arguments)));
      return text + "    </testcase>\n";
    }
  } // namespace

  std::string junit(const Campaign &campaign, const Paths &paths)
  {
    std::string suites;
    for (const auto &result : campaign.cases)
    {
      int failures = 0, errors = 0;
      std::string cases;
      for (std::size_t i = 0; i < result.outcomes.size(); ++i)
      {
        errors += result.outcomes[i].good() ? 0 : 1;
        cases += test_case(result.c.runs[i], result.jobs[i], result.outcomes[i], result.c);
      }
      for (const auto &v : result.verdicts)
      {
        failures += v.status == Status::fail || v.status == Status::missing ? 1 : 0;
        errors += v.status == Status::no_reference ? 1 : 0;
        cases += test_case(v, result.c, repeat_case(paths, result.c, campaign.options.output));
      }
      suites += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" "
                            "errors=\"{}\">\n{}  </testsuite>\n",
                            escaped(result.c.name), result.outcomes.size() + result.verdicts.size(),
                            failures, errors, cases);
    }
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"verify {}\" "
                       "time=\"{:.3f}\">\n{}</testsuites>\n",
                       escaped(campaign.options.suite), campaign.wall_s, suites);
  }
} // namespace verify
