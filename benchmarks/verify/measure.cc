#include "measure.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "curve.h"
#include "history_end.h"
#include "outline_measure.h"
#include "raster.h"
#include "section.h"

namespace verify
{
  namespace
  {
    /// Index of the recorded time that the take wants, to 1e-3 of the recorded length.
    std::size_t time_index(const Take &take, const Constants &constants,
                           const record::Reader &reader, const std::vector<double> &times)
    {
      if (times.empty())
        throw MissingData("nothing was recorded");
      if (!take.nth.empty())
      {
        const double nth = evaluate(take.nth, constants);
        if (nth < 1. || nth > static_cast<double>(times.size()))
          throw MissingData(
              fmt::format("recorded {} times; the {}th is asked for", times.size(), nth));
        return static_cast<std::size_t>(nth) - 1;
      }
      if (take.at.empty() || take.at == "end")
      {
        refuse_early_end(reader, take.probes.at(0)[1], times, one_recording);
        return times.size() - 1;
      }
      const double wanted = evaluate(take.at, constants);
      const auto nearer = [&](double a, double b)
      { return std::abs(a - wanted) < std::abs(b - wanted); };
      const auto found = std::min_element(times.begin(), times.end(), nearer);
      const double slack = one_recording * std::max(std::abs(times.back()), std::abs(wanted));
      if (std::abs(*found - wanted) > slack)
        throw MissingData(
            fmt::format("not recorded at time {}; the nearest is {}", wanted, *found));
      return found - times.begin();
    }

    /// A line may leave the body, but a mean or a maximum of what little lies in it is that of
    /// another line. The first and the last are those where material is.
    void refuse_bare_line(const Curve &line, const Take &take)
    {
      const auto within = std::count_if(line.y.begin(), line.y.end(),
                                        [](const double y) { return !std::isnan(y); });
      if (take.reduce != "first" && take.reduce != "last" &&
          static_cast<double>(within) < take.coverage * static_cast<double>(line.y.size()))
        throw MissingData(fmt::format("short: {} of {} samples of the line lie in material; "
                                      "wanted {:.0f} %",
                                      within, line.y.size(), 100. * take.coverage));
    }

    void add_table(const record::Table &table, const std::string &prefix, ColumnData &columns)
    {
      const std::string before = prefix.empty() ? "" : prefix + "_";
      Curve column;
      column.x = column.t = table.time;
      const bool first = columns.count("time") == 0;
      if (first)
        columns["time"] = table.time;
      for (std::size_t k = 0; k < table.columns.names.size(); ++k)
      {
        column.y.clear();
        for (const auto &row : table.rows)
          column.y.push_back(row.at(k));
        auto &target = columns[before + table.columns.names[k]];
        target.clear();
        for (std::size_t i = 0; i < columns["time"].size(); ++i)
          target.push_back(first ? column.y[i] : interpolate(column, columns["time"][i]));
      }
    }

    Quantity measure_table(const Take &take, const Constants &constants,
                           const record::Reader &reader)
    {
      ColumnData columns;
      for (const auto &[prefix, name] : take.probes)
        add_table(reader.table(name), prefix, columns);
      if (take.between.empty() && (take.at.empty() || take.at == "end"))
        refuse_early_end(reader, take.probes.at(0)[1], columns.at("time"));
      return curve_or_number(take, constants, columns, true);
    }

    Quantity measure_line(const Take &take, const Constants &constants,
                          const record::Reader &reader)
    {
      const auto line = reader.line(take.probes.at(0)[1]);
      const std::size_t i = time_index(take, constants, reader, line.time);
      const auto &sample = line.samples.at(i);
      ColumnData columns;
      const std::size_t m = sample.position.size(), k = line.columns.names.size();
      for (std::size_t j = 0; j < m; ++j)
      {
        columns["x"].push_back(sample.position[j][0]);
        columns["y"].push_back(sample.position[j][1]);
        columns["s"].push_back((sample.position[j] - sample.position[0]).norm());
        columns["time"].push_back(line.time[i]);
        for (std::size_t c = 0; c < k; ++c)
          columns[line.columns.names[c]].push_back(sample.values.at(j * k + c));
      }
      return curve_or_number(take, constants, columns, false);
    }

    Quantity measure_outline(const Take &take, const Constants &constants,
                             const record::Reader &reader)
    {
      const auto all = reader.outline(take.probes.at(0)[1]);
      Outline outline = all.outlines.at(time_index(take, constants, reader, all.time));
      if (take.mirror == "x" || take.mirror == "y")
        outline = mirrored(outline, take.mirror);
      if (!take.rotate.empty())
        outline = rotated(outline, evaluate(take.rotate, constants));
      if (take.shift.size() == 2)
        outline = shifted(outline,
                          {evaluate(take.shift[0], constants), evaluate(take.shift[1], constants)});
      if (take.of.empty() || take.of == "polygon")
        return outline;
      if (take.of == "area")
        return area(outline);
      if (take.of == "perimeter")
        return perimeter(outline);
      if (take.of == "side")
        return side_position(outline, take.side,
                             evaluate(take.y.empty() ? take.x : take.y, constants));
      if (take.of == "reach")
        return reach(outline);
      return extreme(outline, take.side)[take.of == "extreme_x" ? 0 : 1]; // read_take knows no more
    }

    bool inside(const std::vector<double> &box, const scene::Point &p)
    {
      return box.empty() || (p[0] >= box[0] && p[1] >= box[1] && p[0] <= box[2] && p[1] <= box[3]);
    }

    Quantity measure_snapshot(const Take &take, const Constants &constants,
                              const record::Reader &reader)
    {
      const std::string &name = take.probes.at(0)[1];
      const auto times = reader.snapshot_times(name);
      const std::size_t index = time_index(take, constants, reader, times);
      const auto snapshot = reader.snapshot(name, index);
      std::vector<double> box;
      for (const auto &text : take.box)
        box.push_back(evaluate(text, constants));
      const auto where = places(snapshot);
      ColumnData columns;
      std::vector<std::size_t> taken;
      for (std::size_t i = 0; i < where.size(); ++i)
        if (inside(box, where[i]))
        {
          taken.push_back(i);
          columns["x"].push_back(where[i][0]);
          columns["y"].push_back(where[i][1]);
          for (const auto &[field, values] : snapshot.fields)
            if (values.size() == where.size())
              columns[field].push_back(values[i]);
        }
      if (columns.empty())
        throw MissingData("the snapshot has nothing inside the box");
      Curve samples;
      samples.y = evaluate(take.of, constants, columns);
      samples.x.assign(samples.y.size(), 0.);
      samples.t.assign(samples.y.size(), times[index]);
      for (const double value : samples.y)
        if (!std::isfinite(value))
          throw MissingData(fmt::format("`{}` is {} somewhere in the snapshot", take.of, value));
      if (!take.bin.empty())
        return rasterised(snapshot, {taken, samples.y}, evaluate(take.bin, constants), take.mirror);
      return reduce(samples, take.reduce);
    }

    Quantity measure_number(const Take &take, const record::Reader &reader)
    {
      const std::string &name = take.probes.at(0)[1];
      double value = reader.number(name);
      const auto profile = reader.profile();
      if (const auto found = profile.numbers.find(name);
          !std::isfinite(value) && found != profile.numbers.end())
        value = found->second;
      if (!std::isfinite(value))
        throw MissingData(fmt::format("the record has no finite number `{}`", name));
      return value;
    }

    Quantity measure_value(const Take &take, const Constants &constants, Records &records,
                           const std::string &run)
    {
      Constants known = constants;
      for (std::size_t i = 0; i < take.with.size(); ++i)
      {
        const Quantity inner = measure(take.with[i], constants, records, run);
        if (!std::holds_alternative<double>(inner))
          throw MissingData(
              fmt::format("`{}` is no number: give it `at` or `reduce`", take.with_names[i]));
        known.emplace_back(take.with_names[i], std::get<double>(inner));
      }
      return evaluate(take.probes.at(0)[1], known);
    }

    Quantity measure_in(const Take &take, const Constants &constants, const record::Reader &reader)
    {
      switch (take.kind)
      {
      case Take::Kind::table:
        return measure_table(take, constants, reader);
      case Take::Kind::line:
        return measure_line(take, constants, reader);
      case Take::Kind::outline:
        return measure_outline(take, constants, reader);
      case Take::Kind::snapshot:
        return measure_snapshot(take, constants, reader);
      default:
        return measure_number(take, reader);
      }
    }
  } // namespace

  Quantity curve_or_number(const Take &take, const Constants &constants, const ColumnData &columns,
                           const bool by_time)
  {
    Curve curve;
    curve.t = columns.at("time");
    curve.y = evaluate(take.of, constants, columns);
    curve.x = evaluate(take.abscissa.empty() ? (by_time ? "time" : "s") : take.abscissa, constants,
                       columns);
    if (!take.between.empty())
      curve = between(curve, by_time && !take.along_abscissa, evaluate(take.between[0], constants),
                      evaluate(take.between[1], constants));
    if (by_time)
      for (std::size_t i = 0; i < curve.y.size(); ++i)
        if (!std::isfinite(curve.y[i]) || !std::isfinite(curve.x[i]))
          throw MissingData(fmt::format("`{}` is not finite at time {}", take.of, curve.t[i]));
    if (curve.y.empty())
      throw MissingData("no samples in the stretch that is asked for");
    if (!take.reduce.empty())
    {
      if (!by_time)
        refuse_bare_line(curve, take);
      return reduce(curve, take.reduce);
    }
    if (!by_time || take.at.empty())
      return curve;
    if (take.at == "end")
      return curve.y.back();
    const double value = interpolate({curve.t, curve.y, curve.t}, evaluate(take.at, constants));
    if (!std::isfinite(value))
      throw MissingData(fmt::format("short: recorded from time {} to {}, wanted at {}",
                                    curve.t.front(), curve.t.back(), take.at));
    return value;
  }

  Quantity measure(const Take &take, const Constants &constants, Records &records,
                   const std::string &run)
  {
    if (take.kind == Take::Kind::value)
      return measure_value(take, constants, records, run);
    const auto &reader = records.open(run.empty() ? take.run : run);
    try
    {
      return measure_in(take, constants, reader);
    }
    catch (const MissingData &)
    {
      throw;
    }
    catch (const BadInput &)
    {
      throw;
    }
    catch (const std::runtime_error &error) // the reader: no such probe
    {
      throw MissingData(error.what());
    }
  }
} // namespace verify
