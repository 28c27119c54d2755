#include "judge.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "csv.h"
#include "curve.h"
#include "end_times.h"
#include "grids.h"
#include "norm.h"

namespace verify
{
  std::string text(const Status status)
  {
    switch (status)
    {
    case Status::pass:
      return "pass";
    case Status::fail:
      return "fail";
    case Status::missing:
      return "missing";
    default:
      return "no reference";
    }
  }

  namespace
  {
    double usual_coverage(const Take::Kind kind)
    {
      if (kind == Take::Kind::snapshot) // squares at an edge are filled by one and not the other
        return 0.9;
      return kind == Take::Kind::line ? 0.95 : 0.99;
    }

    Norm norm_of(const Check &check, const Case &c)
    {
      Norm norm;
      norm.name = check.norm;
      if (!check.scale.empty())
        norm.scale = evaluate(check.scale, c.constants);
      norm.coverage = check.coverage.value_or(usual_coverage(check.take.kind));
      return norm;
    }

    /// A theory or a number, in the shape of what was taken.
    Quantity like(const Quantity &taken, const std::string &text, const Constants &constants)
    {
      if (const auto *curve = std::get_if<Curve>(&taken))
      {
        Curve reference = *curve;
        reference.y = evaluate(text, constants, {{"x", curve->x}, {"t", curve->t}});
        return reference;
      }
      if (const auto *raster = std::get_if<Raster>(&taken))
      {
        const double value = evaluate(text, constants);
        Raster reference = *raster;
        for (auto &[index, mean] : reference.mean)
          mean = value;
        return reference;
      }
      if (std::holds_alternative<Outline>(taken))
        throw MissingData("an outline can only be held against the outline of a run");
      return evaluate(text, constants);
    }

    Quantity from_csv(const Against &against, const Case &c)
    {
      ColumnData columns = read_csv(c.folder + "/" + against.text);
      const bool timed = columns.count("time") > 0;
      if (!timed) // `at` and `between` then mean the abscissa
        columns["time"] = evaluate(against.take.abscissa, c.constants, columns);
      return curve_or_number(against.take, c.constants, columns, true);
    }

    Quantity reference_for(const Check &check, const Case &c, Records &records,
                           const Quantity &taken)
    {
      switch (check.against.kind)
      {
      case Against::Kind::run:
        return measure(check.against.take, c.constants, records);
      case Against::Kind::csv:
        return from_csv(check.against, c);
      case Against::Kind::zero:
        return like(taken, "0", c.constants);
      default:
        return like(taken, check.against.text, c.constants);
      }
    }

    /// What the value of a check is made of, for a given run.
    double value_of(const Check &check, const Case &c, Records &records, const std::string &run,
                    Verdict &verdict)
    {
      const Quantity taken = measure(check.take, c.constants, records, run);
      if (const auto *number = std::get_if<double>(&taken))
        verdict.taken = *number;
      if (const auto *curve = std::get_if<Curve>(&taken))
        verdict.taken_curve = *curve;
      if (const auto *outline = std::get_if<Outline>(&taken))
        verdict.taken_outline = *outline;
      if (check.against.kind == Against::Kind::nothing)
      {
        if (!verdict.taken)
          throw MissingData("norm \"value\" needs a number: give the take `at` or `reduce`");
        return *verdict.taken;
      }
      const Quantity reference = reference_for(check, c, records, taken);
      refuse_unequal_ends(check, records, run);
      if (const auto *number = std::get_if<double>(&reference))
        verdict.reference = *number;
      if (const auto *curve = std::get_if<Curve>(&reference))
        verdict.reference_curve = *curve;
      if (const auto *outline = std::get_if<Outline>(&reference))
        verdict.reference_outline = *outline;
      return distance(norm_of(check, c), taken, reference, reference);
    }

    double order_of(const Check &check, const Case &c, Records &records, Verdict &verdict)
    {
      for (const auto &run : check.order_over)
      {
        verdict.h.push_back(*c.find_run(run)->h);
        verdict.errors.push_back(value_of(check, c, records, run, verdict));
      }
      verdict.taken.reset();
      verdict.reference.reset();
      return observed_order(verdict.h, verdict.errors);
    }

    /// Uncertainty of one code from its grids, in the norm of the check.
    GridUncertainty uncertainty_of(const std::vector<std::string> &runs, const Take &take,
                                   const Check &check, const Case &c, Records &records,
                                   const Quantity &size_of)
    {
      std::vector<double> h;
      std::vector<Quantity> values;
      for (const auto &run : runs)
      {
        h.push_back(*c.find_run(run)->h);
        values.push_back(measure(take, c.constants, records, run));
      }
      const auto known = std::find(runs.begin(), runs.end(), take.run);
      const std::size_t wanted =
          known == runs.end() ? fine_to_coarse(h).front() : known - runs.begin();
      Norm norm = norm_of(check, c);
      if (norm.name == "value")
        norm.name = "absolute";
      const auto difference = [&](std::size_t i, std::size_t j)
      {
        const double size = distance(norm, values[i], values[j], size_of);
        const auto *a = std::get_if<double>(&values[i]), *b = std::get_if<double>(&values[j]);
        return a && b && *a < *b ? -size : size;
      };
      return grid_uncertainty(h, difference, wanted, check.order_at_most);
    }

    void add_uncertainty(const Check &check, const Case &c, Records &records, Verdict &verdict)
    {
      const auto size_of = [&]() -> Quantity
      {
        if (verdict.reference)
          return *verdict.reference;
        if (verdict.reference_curve)
          return *verdict.reference_curve;
        if (!verdict.reference_outline.empty())
          return verdict.reference_outline;
        return verdict.taken.value_or(1.);
      }();
      double square = 0.;
      const auto add =
          [&](const std::string &whose, const std::vector<std::string> &runs, const Take &take)
      {
        if (runs.empty())
          return 0.;
        const auto one = uncertainty_of(runs, take, check, c, records, size_of);
        square += one.uncertainty * one.uncertainty;
        verdict.uncertainty_text +=
            (verdict.uncertainty_text.empty() ? "" : "; ") + whose + ": " + one.text();
        return one.uncertainty;
      };
      add("take", check.uncertain_take, check.take);
      const double of_reference = add("reference", check.uncertain_against, check.against.take);
      if (verdict.uncertainty_text.empty())
        return;
      verdict.uncertainty = std::sqrt(square);
      if (!(of_reference <= check.high) && verdict.status == Status::pass)
      {
        verdict.status = Status::fail;
        verdict.why = fmt::format("the reference is uncertain by {:.3g}, more than the limit: it "
                                  "cannot judge",
                                  of_reference);
      }
    }

    void compare(const Check &check, const Case &c, Records &records, Verdict &verdict)
    {
      verdict.value = check.order_over.empty() ? value_of(check, c, records, "", verdict)
                                               : order_of(check, c, records, verdict);
      if (!std::isfinite(*verdict.value))
        throw MissingData(fmt::format("the value is {}", *verdict.value));
      const bool within = check.low <= *verdict.value && *verdict.value <= check.high;
      verdict.status = within ? Status::pass : Status::fail;
      if (!within)
        verdict.why = fmt::format("{:.6g} is outside [{:.6g}, {:.6g}]", *verdict.value, check.low,
                                  check.high);
      add_uncertainty(check, c, records, verdict);
    }
  } // namespace

  Verdict judge(const Check &check, const Case &c, Records &records)
  {
    Verdict verdict;
    verdict.check = check;
    try
    {
      compare(check, c, records, verdict);
    }
    catch (const MissingReference &error)
    {
      verdict.status = Status::no_reference;
      verdict.why = error.what();
    }
    catch (const std::exception &error) // whatever it is, the verdicts of the others stay
    {
      verdict.status = Status::missing;
      verdict.why = error.what();
    }
    return verdict;
  }

  std::string describe(const Take &take)
  {
    static const char *const kinds[] = {"table", "line", "outline", "snapshot", "number", "value"};
    std::string text = take.run.empty() ? "" : take.run + ": ";
    text += kinds[static_cast<int>(take.kind)];
    for (const auto &probe : take.probes)
      text += " \"" + probe[1] + "\"";
    if (!take.of.empty())
      text += " " + take.of;
    if (!take.side.empty())
      text += " " + take.side;
    if (!take.x.empty() || !take.y.empty())
      text += take.y.empty() ? " at x = " + take.x : " at y = " + take.y;
    if (!take.abscissa.empty())
      text += " over " + take.abscissa;
    if (!take.between.empty())
      text += fmt::format(" from {} to {}", take.between[0], take.between[1]);
    if (!take.bin.empty())
      text += " over squares of " + take.bin;
    if (take.mirror == "x" || take.mirror == "y")
      text += " mirrored in " + take.mirror;
    if (!take.rotate.empty())
      text += " turned by " + take.rotate + " degrees";
    if (!take.at.empty())
      text += take.at == "end" ? " at the end" : " at t = " + take.at;
    return take.reduce.empty() ? text : take.reduce + " of " + text;
  }

  std::string describe(const Against &against)
  {
    switch (against.kind)
    {
    case Against::Kind::nothing:
      return "";
    case Against::Kind::run:
      return describe(against.take);
    case Against::Kind::csv:
      return fmt::format("{}: {} over {}", against.text, against.take.of, against.take.abscissa);
    case Against::Kind::zero:
      return "zero";
    default:
      return against.text;
    }
  }
} // namespace verify
