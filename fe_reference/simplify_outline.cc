#include "simplify_outline.h"

#include <algorithm>

#include "scene/geometry.h"

namespace fe
{
  namespace
  {
    using scene::distance_to_segment;
    using scene::Point;
    using scene::Polyline;

    // Marks what is kept between first and last, which are kept already.
    void keep_between(const Polyline &open, const std::size_t first, const std::size_t last,
                      const double tolerance, std::vector<char> &kept)
    {
      double farthest = tolerance;
      std::size_t split = first;
      for (std::size_t k = first + 1; k < last; ++k)
      {
        const double distance = distance_to_segment(open[k], open[first], open[last]);
        if (distance > farthest)
        {
          farthest = distance;
          split = k;
        }
      }
      if (split == first)
        return;
      kept[split] = 1;
      keep_between(open, first, split, tolerance, kept);
      keep_between(open, split, last, tolerance, kept);
    }

    struct Vertex
    {
      Point at;
      bool marked;
    };

    // What the outline would lose with its vertex k.
    double sharpness(const std::vector<Vertex> &closed, const std::size_t k)
    {
      const std::size_t n = closed.size();
      return distance_to_segment(closed[k].at, closed[(k + n - 1) % n].at, closed[(k + 1) % n].at);
    }

    // Of two vertices closer than `gap` the flatter one goes, or the one that is not marked: a
    // corner, say where the body meets a symmetry side, must stay whatever comes just before it.
    void part_close_pairs(std::vector<Vertex> &closed, const double gap)
    {
      for (std::size_t k = 0; k < closed.size() && closed.size() > 3;)
      {
        const std::size_t next = (k + 1) % closed.size();
        const bool both = closed[k].marked && closed[next].marked;
        if (both || (closed[next].at - closed[k].at).norm() >= gap)
        {
          ++k;
          continue;
        }
        const bool first = closed[k].marked == closed[next].marked
                               ? sharpness(closed, k) < sharpness(closed, next)
                               : closed[next].marked;
        closed.erase(closed.begin() + static_cast<std::ptrdiff_t>(first ? k : next));
        k = k > 0 ? k - 1 : 0;
      }
    }

    // Does the outline go straight on from direction `a` to direction `b`?
    bool straight_on(const Point &a, const Point &b)
    {
      return a.dot(b) > 0. && std::abs(a[0] * b[1] - a[1] * b[0]) <= 1e-6 * a.norm() * b.norm();
    }

    // The curves' chords turn by more than rounding at every vertex: each is a part of its own.
    void mark_straight_ends(const Polyline &closed, const double longest_short,
                            std::vector<char> &marked)
    {
      const std::size_t n = closed.size();
      const auto side = [&](const std::size_t k)
      { return Point(closed[(k + 1) % n] - closed[k % n]); };
      std::size_t start = 0;
      while (start < n && straight_on(side(start + n - 1), side(start)))
        ++start;
      for (std::size_t from = start; from < start + n;)
      {
        std::size_t to = from + 1;
        while (to < start + n && straight_on(side(from), side(to)))
          ++to;
        if ((closed[to % n] - closed[from % n]).norm() > longest_short)
          marked[from % n] = marked[to % n] = 1;
        from = to;
      }
    }
  } // namespace

  std::vector<char> ends_of_parts(const scene::Polyline &outline, const double longest_short,
                                  const std::vector<scene::Where> &parts,
                                  const scene::Box &bodies_box, const double tolerance)
  {
    const std::size_t n = outline.size();
    std::vector<char> marked(n, 0);
    mark_straight_ends(outline, longest_short, marked);
    const std::vector<char> corners = marked;
    // All but the same as a corner: no sliver of a side for it.
    const auto beside_corner = [&](const std::size_t k)
    {
      for (const std::size_t near : {k + n - 2, k + n - 1, k + 1, k + 2})
        if (corners[near % n] && (outline[near % n] - outline[k]).norm() < 0.02 * longest_short)
          return true;
      return false;
    };
    for (const scene::Where &part : parts)
    {
      const auto in = [&](const std::size_t k) // the side after vertex k
      {
        const Point middle = 0.5 * (outline[k % n] + outline[(k + 1) % n]);
        return scene::contains(part, bodies_box, middle, tolerance);
      };
      for (std::size_t k = 0; k < n; ++k)
        if (in(k + n - 1) != in(k) && !beside_corner(k))
          marked[k] = 1;
    }
    return marked;
  }

  scene::Polyline simplify_outline(const scene::Polyline &outline, const std::vector<char> &marked,
                                   const Simplification &lengths)
  {
    if (outline.size() < 4)
      return outline;
    Polyline open = outline;
    open.push_back(outline.front());
    // A closed curve is split where it is farthest from its first vertex.
    std::size_t opposite = 0;
    for (std::size_t k = 1; k < outline.size(); ++k)
      if ((outline[k] - outline[0]).norm() > (outline[opposite] - outline[0]).norm())
        opposite = k;
    std::vector<char> kept = marked;
    kept.push_back(1);
    kept.front() = kept[opposite] = 1;
    const std::vector<char> ends = kept;
    for (std::size_t from = 0, to = 1; to < open.size(); ++to)
      if (ends[to])
      {
        keep_between(open, from, to, lengths.tolerance, kept);
        from = to;
      }

    std::vector<Vertex> vertices;
    for (std::size_t k = 0; k + 1 < open.size(); ++k)
      if (kept[k])
        vertices.push_back({open[k], marked[k] != 0});
    part_close_pairs(vertices, lengths.gap);
    if (vertices.size() < 3)
      return outline;
    Polyline result;
    for (const Vertex &vertex : vertices)
      result.push_back(vertex.at);
    return result;
  }
} // namespace fe
