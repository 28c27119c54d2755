#include "raster.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace verify
{
  namespace
  {
    using Kind = record::Snapshot::Kind;
    using Corners = std::array<scene::Point, 4>;

    constexpr double filled = 0.75;  // of a square
    constexpr double parts_of = 0.2; // of a square's side: what a cell is cut into

    struct Square
    {
      double area = 0., sum = 0.;
    };
    using Squares = std::map<std::array<int, 2>, Square>;

    /// Adds one value of a piece of material so small that all of it lies in one square.
    class Collector
    {
    public:
      Collector(const double bin, const std::string &mirror)
          : bin(bin), sign(mirror == "x" ? -1. : 1., mirror == "y" ? -1. : 1.)
      {
      }
      void add(const scene::Point &place, const double area, const double value)
      {
        const scene::Point p = sign.cwiseProduct(place) / bin;
        Square &square =
            squares[{static_cast<int>(std::floor(p[0])), static_cast<int>(std::floor(p[1]))}];
        square.area += area;
        square.sum += area * value;
      }
      Squares squares;

    private:
      double bin;
      scene::Point sign;
    };

    /// Bilinear map of the unit square onto a cell whose corners go round.
    scene::Point at(const Corners &corner, const double r, const double s)
    {
      return (1. - r) * (1. - s) * corner[0] + r * (1. - s) * corner[1] + r * s * corner[2] +
             (1. - r) * s * corner[3];
    }

    double area_of(const scene::Point &a, const scene::Point &b)
    {
      return std::abs(a[0] * b[1] - a[1] * b[0]);
    }

    void add_cell(Collector &collector, const Corners &corner, const double value, const double bin)
    {
      const double diameter =
          std::max((corner[2] - corner[0]).norm(), (corner[3] - corner[1]).norm());
      const int parts = std::max(1, static_cast<int>(std::ceil(diameter / (parts_of * bin))));
      const double h = 1. / parts;
      for (int j = 0; j < parts; ++j)
        for (int i = 0; i < parts; ++i)
        {
          const double r = i * h, s = j * h;
          const scene::Point a = at(corner, r + h, s + h) - at(corner, r, s);
          const scene::Point b = at(corner, r, s + h) - at(corner, r + h, s);
          collector.add(at(corner, r + 0.5 * h, s + 0.5 * h), 0.5 * area_of(a, b), value);
        }
    }

    const std::vector<double> &areas(const record::Snapshot &snapshot)
    {
      const auto found = snapshot.fields.find("area");
      if (found == snapshot.fields.end())
        throw MissingData("the snapshot's points have no field `area` to weight them by");
      return found->second;
    }

    void collect_cells(Collector &collector, const record::Snapshot &snapshot,
                       const PlacedValues &values, const double bin)
    {
      for (std::size_t k = 0; k < values.place.size(); ++k)
      {
        Corners corner;
        for (std::size_t v = 0; v < 4; ++v)
          corner[v] = snapshot.vertex.at(snapshot.connectivity.at(4 * values.place[k] + v));
        add_cell(collector, corner, values.value[k], bin);
      }
    }

    void collect_points(Collector &collector, const record::Snapshot &snapshot,
                        const PlacedValues &values)
    {
      const auto &area = areas(snapshot);
      for (std::size_t k = 0; k < values.place.size(); ++k)
      {
        const std::size_t i = values.place[k];
        collector.add(snapshot.vertex.at(i), area.at(i), values.value[k]);
      }
    }

    void collect_nodes(Collector &collector, const record::Snapshot &snapshot,
                       const PlacedValues &values)
    {
      const auto where = places(snapshot);
      for (std::size_t k = 0; k < values.place.size(); ++k)
        collector.add(where.at(values.place[k]), snapshot.spacing.prod(), values.value[k]);
    }
  } // namespace

  std::vector<scene::Point> places(const record::Snapshot &snapshot)
  {
    std::vector<scene::Point> result;
    if (snapshot.kind == Kind::points)
      return snapshot.vertex;
    if (snapshot.kind == Kind::grid)
      for (int j = 0; j < snapshot.nodes[1]; ++j)
        for (int i = 0; i < snapshot.nodes[0]; ++i)
          result.push_back(snapshot.origin + snapshot.spacing.cwiseProduct(scene::Point(i, j)));
    else
      for (std::size_t c = 0; c + 3 < snapshot.connectivity.size(); c += 4)
      {
        scene::Point centre = scene::Point::Zero();
        for (std::size_t v = 0; v < 4; ++v)
          centre += 0.25 * snapshot.vertex.at(snapshot.connectivity[c + v]);
        result.push_back(centre);
      }
    return result;
  }

  Raster rasterised(const record::Snapshot &snapshot, const PlacedValues &values, const double bin,
                    const std::string &mirror)
  {
    if (!(bin > 0. && std::isfinite(bin)))
      throw MissingData(fmt::format("`bin` is {}: it is the side of a square", bin));
    Collector collector(bin, mirror);
    if (snapshot.kind == Kind::cells)
      collect_cells(collector, snapshot, values, bin);
    else if (snapshot.kind == Kind::points)
      collect_points(collector, snapshot, values);
    else
      collect_nodes(collector, snapshot, values);
    Raster raster;
    for (const auto &[index, square] : collector.squares)
      if (square.area >= filled * bin * bin)
        raster.mean[index] = square.sum / square.area;
    if (raster.mean.empty())
      throw MissingData(fmt::format("the material fills no square of side {}", bin));
    return raster;
  }

  CommonSamples common_squares(const Raster &a, const Raster &b, const double coverage)
  {
    CommonSamples common;
    common.start = {0};
    for (const auto &[index, value] : a.mean)
      if (const auto other = b.mean.find(index); other != b.mean.end())
      {
        common.x.push_back(0.); // no extent: equal weights
        common.a.push_back(value);
        common.b.push_back(other->second);
      }
    const std::size_t either = a.mean.size() + b.mean.size() - common.x.size();
    if (static_cast<double>(common.x.size()) < coverage * static_cast<double>(either))
      throw MissingData(fmt::format("{} of {} squares are filled on both sides; wanted {:.0f} %",
                                    common.x.size(), either, 100. * coverage));
    return common;
  }
} // namespace verify
