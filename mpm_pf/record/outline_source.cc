#include "record/outline_source.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <sstream>

#include "record/reader.h"
#include "scene/hash.h"
#include "scene/reader.h"

namespace record
{
  namespace
  {
    using scene::RecordedOutline;

    [[noreturn]] void complain(const scene::Body &body, const std::string &why)
    {
      std::string place = body.place.file + ":" + std::to_string(body.place.line);
      if (!body.place.key.empty())
        place += ": " + body.place.key;
      throw scene::BadScene(place + ": the outline of body \"" + body.name +
                            "\" cannot be read from a record: " + why);
    }

    Point crossing(const Point &a, const Point &b, const double height)
    {
      const double s = (height - a[1]) / (b[1] - a[1]);
      return {a[0] + s * (b[0] - a[0]), height};
    }

    /// Pieces of the curves below the line, each from crossing to crossing; curves that do not
    /// cross it go to `whole` or nowhere.
    std::vector<Polyline> pieces_below(const std::vector<Polyline> &curves, const double height,
                                       std::vector<Polyline> &whole)
    {
      std::vector<Polyline> pieces;
      for (const Polyline &curve : curves)
      {
        const std::size_t n = curve.size();
        const auto below = [&](const std::size_t k) { return curve[k % n][1] < height; };
        std::size_t first = 0; // the first vertex above the line: no piece is cut in two there
        while (first < n && below(first))
          ++first;
        if (first == n && n > 0)
          whole.push_back(curve);
        for (std::size_t k = first; first < n && k < first + n; ++k)
        {
          const Point &a = curve[k % n], &b = curve[(k + 1) % n];
          if (below(k + 1) && !below(k))
            pieces.push_back({crossing(a, b, height)});
          if (below(k + 1))
            pieces.back().push_back(b);
          if (below(k) && !below(k + 1))
            pieces.back().push_back(crossing(a, b, height));
        }
      }
      return pieces;
    }

    /// Ends of pieces (2 k: first vertex of piece k, 2 k + 1: its last) along the line, joined in
    /// pairs: between the first and the second crossing is solid, then not, and so on.
    std::vector<std::size_t> partners(const std::vector<Polyline> &pieces)
    {
      const auto x = [&](const std::size_t end)
      { return (end % 2 == 0 ? pieces[end / 2].front() : pieces[end / 2].back())[0]; };
      std::vector<std::size_t> order(2 * pieces.size()), partner(order.size());
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(), order.end(),
                       [&](const std::size_t a, const std::size_t b) { return x(a) < x(b); });
      for (std::size_t k = 0; k < order.size(); k += 2)
      {
        partner[order[k]] = order[k + 1];
        partner[order[k + 1]] = order[k];
      }
      return partner;
    }

    std::vector<Polyline> mirrored(std::vector<Polyline> curves)
    {
      for (Polyline &curve : curves)
        for (Point &vertex : curve)
          vertex[1] = -vertex[1];
      return curves;
    }

    /// Index of the wanted time; a negative one means the last.
    std::size_t index_of(const scene::Body &body, const std::vector<double> &times,
                         const double wanted)
    {
      if (times.empty())
        complain(body, "its probe recorded nothing");
      if (wanted < 0.)
        return times.size() - 1;
      std::ostringstream present;
      for (std::size_t k = 0; k < times.size(); ++k)
      {
        if (std::abs(times[k] - wanted) <= 1e-6 * std::max(1e-300, std::abs(times.back())))
          return k;
        present << (k == 0 ? "" : ", ") << times[k];
      }
      std::ostringstream why;
      why << "it was not taken at time " << wanted << " but at " << present.str();
      complain(body, why.str());
    }

    std::vector<Polyline> read_curves(const scene::Body &body, const std::string &path,
                                      const RecordedOutline &source)
    {
      try
      {
        const Outlines outlines = Reader(path).outline(source.probe);
        return outlines.outlines.at(index_of(body, outlines.time, source.time));
      }
      catch (const scene::BadScene &)
      {
        throw;
      }
      catch (const std::runtime_error &error)
      {
        complain(body, std::string(error.what()) + ". Run the scene that writes this record "
                                                   "first, or correct the path and probe");
      }
    }

    /// Every bit of the curves, and where each of them ends.
    std::string bytes_of(const std::vector<Polyline> &curves)
    {
      std::string bytes;
      for (const Polyline &curve : curves)
      {
        bytes += std::to_string(curve.size()) + ' ';
        for (const Point &vertex : curve)
          bytes.append(reinterpret_cast<const char *>(vertex.data()), 2 * sizeof(double));
      }
      return bytes;
    }
  } // namespace

  std::vector<Polyline> cut_above(const std::vector<Polyline> &curves, const double height)
  {
    std::vector<Polyline> result;
    const std::vector<Polyline> pieces = pieces_below(curves, height, result);
    const std::vector<std::size_t> partner = partners(pieces);
    std::vector<bool> used(pieces.size(), false);
    for (std::size_t start = 0; start < pieces.size(); ++start)
    {
      if (used[start])
        continue;
      Polyline closed;
      for (std::size_t end = 2 * start; !used[end / 2]; end = partner[end])
      {
        const Polyline &piece = pieces[end / 2];
        used[end / 2] = true;
        if (end % 2 == 0)
          closed.insert(closed.end(), piece.begin(), piece.end());
        else
          closed.insert(closed.end(), piece.rbegin(), piece.rend());
        end ^= 1; // leave the piece at its other end
      }
      closed.erase(std::unique(closed.begin(), closed.end()), closed.end());
      while (closed.size() > 1 && closed.front() == closed.back())
        closed.pop_back();
      if (closed.size() >= 3)
        result.push_back(std::move(closed));
    }
    return result;
  }

  void resolve_outlines(scene::Scene &scene)
  {
    std::string resolved;
    for (scene::Body &body : scene.bodies)
    {
      const auto *source = std::get_if<RecordedOutline>(&body.shape);
      if (source == nullptr)
        continue;
      const std::string path = source->path; // the scene's reader put it beside its scene file
      std::vector<Polyline> curves = read_curves(body, path, *source);
      if (source->cut_above)
        curves = cut_above(curves, *source->cut_above);
      if (source->cut_below)
        curves = mirrored(cut_above(mirrored(curves), -*source->cut_below));
      if (curves.empty())
        complain(body, path + ": nothing of probe \"" + source->probe +
                           "\" is left at that time and between the cuts; widen cut_above and "
                           "cut_below or take another time");
      resolved += bytes_of(curves) + '\n';
      body.shape = scene::Polygon{std::move(curves)};
    }
    if (!resolved.empty())
      scene.hash = scene::hash_of(scene.hash + resolved);
  }
} // namespace record
