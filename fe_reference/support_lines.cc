#include "support_lines.h"

#include <algorithm>

#include "scene/geometry.h"

namespace fe
{
  namespace
  {
    using scene::Point;
    using scene::Polyline;
    using Piece = std::array<Point, 2>;

    double cross(const Point &a, const Point &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }

    std::vector<Piece> sides_of(const scene::Box &box)
    {
      const Point a = box.lower, c = box.upper, b(c[0], a[1]), d(a[0], c[1]);
      return {{a, b}, {b, c}, {c, d}, {d, a}};
    }

    // Where piece and chord cross, as parts of the piece and of the chord.
    bool crossing(const Piece &piece, const Point &p, const Point &q, double &s, double &t)
    {
      const Point along = piece[1] - piece[0], chord = q - p;
      const double determinant = cross(along, chord);
      if (std::abs(determinant) <= 1e-12 * along.norm() * chord.norm())
        return false;
      s = cross(p - piece[0], chord) / determinant, t = cross(p - piece[0], along) / determinant;
      return s >= 0. && s <= 1. && t >= 0. && t <= 1.;
    }

    // Parts of the chord from p to q at which something held or loaded begins or ends.
    std::vector<double> ends_on(const Point &p, const Point &q,
                                const std::vector<scene::Where> &parts, const double tolerance)
    {
      std::vector<double> ends;
      const Point chord = q - p;
      const double length2 = chord.squaredNorm();
      for (const scene::Where &part : parts)
        if (const auto *segment = std::get_if<scene::Segment>(&part))
        {
          for (const Point &end : {segment->a, segment->b})
            if (std::abs(cross(end - p, chord)) < tolerance * chord.norm())
              ends.push_back((end - p).dot(chord) / length2);
        }
        else if (const auto *box = std::get_if<scene::Box>(&part))
        {
          double s = 0., t = 0.;
          for (const Piece &side : sides_of(*box))
            if (crossing(side, p, q, s, t))
              ends.push_back(t);
        }
      std::sort(ends.begin(), ends.end());
      return ends;
    }

    bool boxes_meet(const std::vector<scene::Support> &supports)
    {
      std::vector<scene::Box> boxes;
      for (const scene::Support &support : supports)
        if (const auto *box = std::get_if<scene::Box>(&support.where))
          boxes.push_back(*box);
      for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if ((boxes[i].lower.array() <= boxes[j].upper.array()).all() &&
              (boxes[j].lower.array() <= boxes[i].upper.array()).all())
            return true;
      return false;
    }

    bool in_domain(const scene::Domain &domain, const Point &x)
    {
      return (x.array() > domain.lower.array()).all() && (x.array() < domain.upper().array()).all();
    }
  } // namespace

  Polyline with_ends(const Polyline &outline, const std::vector<scene::Where> &parts,
                     const EndTolerances &tolerances)
  {
    const auto [gap, matching] = tolerances;
    Polyline result;
    for (std::size_t k = 0; k < outline.size(); ++k)
    {
      const Point p = outline[k], q = outline[(k + 1) % outline.size()];
      result.push_back(p);
      for (const double t : ends_on(p, q, parts, matching))
      {
        const Point end = p + t * (q - p);
        if (t > 0. && t < 1. && (end - result.back()).norm() > gap && (end - q).norm() > gap)
          result.push_back(end);
      }
    }
    return result;
  }

  std::vector<Piece> held_lines_inside(const std::vector<scene::Body> &bodies,
                                       const scene::Domain &domain,
                                       const std::vector<Polyline> &outlines,
                                       const std::vector<scene::Support> &supports,
                                       const double gap)
  {
    std::vector<Piece> inside;
    if (boxes_meet(supports))
      return inside;
    for (const scene::Support &support : supports)
    {
      const auto *box = std::get_if<scene::Box>(&support.where);
      for (const Piece &side : box ? sides_of(*box) : std::vector<Piece>{})
      {
        std::vector<double> cuts{0., 1.};
        double s = 0., t = 0.;
        for (const Polyline &outline : outlines)
          for (std::size_t k = 0; k < outline.size(); ++k)
            if (crossing(side, outline[k], outline[(k + 1) % outline.size()], s, t))
              cuts.push_back(s);
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
        {
          const Point along = side[1] - side[0];
          const Piece piece{side[0] + cuts[k] * along, side[0] + cuts[k + 1] * along};
          const Point middle = 0.5 * (piece[0] + piece[1]);
          if ((piece[1] - piece[0]).norm() > gap && in_domain(domain, middle) &&
              scene::signed_distance(bodies, middle) > gap)
            inside.push_back(piece);
        }
      }
    }
    return inside;
  }
} // namespace fe
