// What holds the material: lines, rigid grips, driven regions, symmetry sides; and their reactions.
//
// An edge, a segment, a symmetry side of the domain and the sides of a grip are all *held lines*:
// straight, parallel to an axis, with material on one side. Shape functions are folded there
// (shape_functions.h), so the row of nodes next to the line, its carriers, has the line's own
// velocity. Each component may be held or free; an edge whose normal component is free turns and
// bends with its material, as no line does: its nodes are tied, see turning_edges.cc. A region
// whose whole displacement is given and uniform is a rigid grip: its points leave the equations and
// ride along, its sides towards other material are held lines that move through the cells with the
// grip, so that the gauge length is exact. Any other region, and one with material around a corner
// of its box, is *driven*: the displacement increments of its points are projected on the nodes
// with their masses and gradients, which is exact for affine motions, and nodes take them, those
// around the sides of the box as driven_sides.cc says.
//
// Every prescribed velocity is an increment of displacement over dt, so prescribed positions never
// drift. The reaction is the momentum which the nodes are given beyond Eq. (4), over dt.
#pragma once

#include <optional>
#include <string>

#include "solid/motion.h"
#include "solid/tracers.h"

namespace solid
{
  struct Solid; // body.h

  struct Support
  {
    std::string name;
    scene::SourceLocation place;
    Motion motion;
    Point middle = Point::Zero();       // of what it holds, initially
    std::vector<Point> corners;         // of what it holds, initially
    Point impulse = Point::Zero();      // since the start
    Point call_impulse = Point::Zero(); // of this call of advance
    Point displacement = Point::Zero();
  };

  struct HeldLine
  {
    int support = -1;                        // -1: a symmetry side
    int axis = 1;                            // 0: x = position, 1: y = position
    int side = 1;                            // +1: material at larger coordinates
    double initial = 0., from = 0., to = 0.; // position and extent at the start
    std::array<bool, 2> held{true, true};
    std::uint32_t bit = 0;                  // of the tracers whose extent an edge has, or 0
    std::array<double, 2> overhang{0., 0.}; // and so far beyond the first and the last
    std::array<double, 2> reach{3., 3.};    // cells beyond its ends in which nodes are held
    bool contact = false;                   // a wall: holds only what touches it, see walls.h
    bool reflects = false;                  // a symmetry side with images beyond, see mirrors.h
    // Of a wall, node by node along it and `margin` beyond:
    std::vector<std::uint8_t> touched; // does it hold now?
    std::vector<std::uint8_t> stuck;   // did it in the last step
    static constexpr int margin = 8;
    double position = 0., lower = 0., upper = 0.; // position and extent now
    std::size_t index(const int i, const int j) const { return (axis == 0 ? j : i) + margin; }
  };

  /// A node near a turning edge as the edge sees it.
  struct NearEdge
  {
    std::ptrdiff_t node = 0;
    std::array<int, 2> at{0, 0};   // column and row
    std::array<int, 2> step{0, 0}; // into the material along its row or column
    std::size_t outline = 0, chord = 0;
    double distance2 = 0.;  // from that chord
    double distance = 0.;   // from the edge along the row or column, in cells, inwards positive
    bool beside = false;    // between the edge's ends or within its reach of them
    Point X, x;             // where the row or column cuts the edge, initially and now
    int master = -1;        // index of the node that it is tied to, if any
    double ratio = 0.;      // v - V over that of its master
    double prescribed = 0.; // V
    double mass = 0.,
           p = 0.; // of all that its master moves, if it is one: sum r^2 m, sum r m (v - V)
  };

  /// An edge held along itself and free across.
  struct TurningEdge
  {
    HeldLine line; // as at the start
    std::vector<NearEdge> nodes;
    int component() const { return 1 - line.axis; }
  };

  struct Grip
  {
    int support = 0;
    scene::Box box;
    int region = 0; // bit of its points
  };

  /// What the points of a driven region say about a node near them: weighted sums.
  struct Cover
  {
    double weight = 0.;
    Point velocity = Point::Zero();                  // prescribed, over the step to come
    Point origin = Point::Zero();                    // where what is at the node came from, X
    Eigen::Matrix2d slope = Eigen::Matrix2d::Zero(); // dX/dx
  };

  /// Points whose bit `region` is set are driven.
  struct DrivenRegion
  {
    int support = 0;
    int region = 0;
    scene::Box box;
    std::array<std::array<bool, 2>, 2> open; // [axis][upper]: other material beyond that side
    std::vector<Cover> covers;               // by node
  };

  /// Of what a node holds in one component, the part of points driven in that component.
  struct DrivenPart
  {
    double mass = 0., momentum = 0., impulse = 0.; // the last by the step's forces
  };

  /// What a point is to do in the step to come, by component; support -1: the component is free.
  struct Prescribed
  {
    std::array<int, 2> support{-1, -1};
    Point velocity = Point::Zero(), position = Point::Zero(); // the latter at its end
    Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();       // of the velocity
  };

  struct Supports
  {
    std::vector<Support> all;
    std::vector<HeldLine> lines;
    std::vector<TurningEdge> edges;
    std::vector<Grip> grips;
    std::vector<DrivenRegion> driven;
    // Only if there are driven regions, by node and by point:
    std::vector<std::array<DrivenPart, 2>> driven_parts;
    std::vector<Prescribed> prescribed;
    // Only if there are turning edges, by node: components that they hold, index in an edge's list.
    std::vector<std::uint8_t> tied;
    std::vector<int> listed;
    FoldTable folds;
    std::vector<std::ptrdiff_t> marked; // nodes whose fold is set
    double speed = 0.;                  // largest prescribed in the last step
    double work = 0., work_done = 0.;   // by supports since the start; sum of absolute values
  };

  /// First and last column (of a line along y: row) of nodes from reach[0] cells before the line to
  /// reach[1] cells beyond, whether they are in use or not.
  inline std::array<double, 2> nodes_within(const HeldLine &line, const Grid &grid,
                                            const std::array<double, 2> &reach)
  {
    const int along = 1 - line.axis;
    const auto column = [&](const double x) { return (x - grid.lower[along]) * grid.inverse_dx; };
    return {std::ceil(column(line.lower) - reach[0] - 1e-9),
            std::floor(column(line.upper) + reach[1] + 1e-9)};
  }

  /// Call f(i, j, n) for the nodes of `row` along the line, from reach[0] cells before it to
  /// reach[1] cells beyond.
  template <typename F>
  void for_nodes_along(const HeldLine &line, const Grid &grid, const int row,
                       const std::array<double, 2> &reach, F &&f)
  {
    // However long the line (a symmetry side has no ends), only what is in use is looked at.
    const auto [begin, end] =
        line.axis == 1 ? grid.columns(row) : std::pair{grid.row_begin, grid.row_end};
    const auto [from, to] = nodes_within(line, grid, reach);
    const int first = static_cast<int>(std::max<double>(begin, from));
    const int last = static_cast<int>(std::min<double>(end - 1, to));
    for (int k = first; k <= last; ++k)
    {
      const int i = line.axis == 1 ? k : row, j = line.axis == 1 ? row : k;
      if (grid.has(i, j))
        f(i, j, grid.at(i, j));
    }
  }

  /// Everything of the scene that holds; points get their region bits, those in rigid grips are
  /// moved behind `active`, and the tracers are marked. Throws scene::BadScene for a support that
  /// touches nothing, lies across a slanted outline, or bends its edge by more than a quarter of a
  /// cell.
  Supports make_supports(const scene::Scene &, Points &, Tracers &);

  /// Symmetry sides to the grid's mirrors; but where a support holds an edge on the side, which it
  /// may move away, the side remains a held line.
  void place_mirrors(Supports &, Grid &);

  /// Lines to where they are at time t, and the folds into the grid.
  void place_supports(Supports &, const Tracers &, Grid &, double t);

  /// The step [t, t + dt] over which supports hold. Without `count_reaction` the nodes have not got
  /// their forces, so what holding them takes is no reaction.
  struct HeldStep
  {
    double t = 0., dt = 0.;
    bool count_reaction = true;

    double end() const { return t + dt; }
  };

  /// What driven points are to do over the step, by point and for the nodes around them, their
  /// parts of the nodes, and their reactions.
  void prescribe(Solid &, const HeldStep &);

  /// Node velocities after forces to what supports ask for over the step, and the reactions.
  void apply_supports(Supports &, Grid &, const HeldStep &);

  struct HeldNode
  {
    std::ptrdiff_t node;
    std::array<bool, 2> held; // components that get the velocity
    Point velocity;
    bool met = false; // by a wall, which takes what comes at another velocity than its own
  };
  /// Give a node the velocity in the held components; the momentum that takes is the reaction of
  /// `support`; null: of none.
  void set_velocity(Supports &, Support *, Grid &, const HeldNode &);

  /// Points and tracers with prescribed positions to the end of the step of length dt, and what
  /// that takes of a rigid grip: its points' momentum and the loads on them.
  void move_held_points(Solid &, double dt);

  /// The nodes near turning edges and what they are tied to; their velocities over the step; the
  /// tracers of the edges to where they belong at time t.
  void locate_turning_edges(Supports &, const Tracers &, const Grid &);
  void apply_turning_edges(Supports &, Grid &, const HeldStep &);
  void move_turning_edges(const Supports &, Tracers &, double t);

  /// The nodes in and around driven boxes, see driven_sides.cc.
  void apply_driven_regions(Supports &, Grid &, bool count_reaction);

  /// Driven points of a range move and strain as prescribed, not as the nodes that they share with
  /// others.
  void move_as_prescribed(const Supports &, Points &, bool gradient_only, PointRange);

  /// Driven points to where they belong at the step's end.
  void move_driven_points(const Supports &, Points &);

  /// Sides of the support's box beyond which there is material that no other box holds as well,
  /// [axis][upper].
  std::array<std::array<bool, 2>, 2> open_sides(const scene::Scene &, const scene::Support &);

  /// Largest speed that any support ever asks for up to `end`.
  double largest_prescribed_speed(const Supports &, double end);
} // namespace solid
