// How much of a traction a node can take.
//
// The force of a traction on node i is int w_i t ds over the outline. Where the outline cuts cells
// the nodes outside the body are seen by the edge, but hardly or not at all by the points, which
// stand half a spacing inside; the force on such a node would fling the few points that see it, and
// no stress could ever balance it. What the points can balance is known: a uniform stress sigma
// gives the internal force sigma N_i with
//   N_i = sum_p V_p grad w_i(x_p),   in the limit of many points   B_i = int w_i n ds,
// by the divergence theorem. So with the edge's normal n_i at the node (the mean over what is
// loaded there) each node takes of its traction the share
//   r_i = (N_i . n_i)/(B_i . n_i),
// and what all nodes of a place do not take is given to them in proportion. A uniform pressure is
// then balanced by a uniform stress exactly, whatever the points represent of the cut cells: the
// boundary term is integrated with the quadrature of the stresses.
#pragma once

#include "solid/tracers.h"

namespace solid
{
  class EdgeShares
  {
  public:
    /// After each sorting: the points and chords that may see a loaded node until the next one.
    void find_near(const Tracers &, const Points &, const Grid &);

    /// Shares of the nodes that loaded chords touch, for the points and chords as they now are.
    void measure(const Tracers &, const Points &, const Interpolation &, double inverse_density);

    /// r_i of a node that a loaded chord touches.
    double operator[](const std::ptrdiff_t node) const { return sums[node].share; }

    double bytes() const;

  private:
    struct Sums
    {
      Point loaded = Point::Zero(), edge = Point::Zero(), points = Point::Zero();
      double share = 0.;
    };
    std::vector<Sums> sums; // of all nodes; zero but for those in use
    std::vector<std::ptrdiff_t> nodes;
    std::vector<std::uint32_t> near;
    struct Chord
    {
      std::size_t outline, tracer; // that it starts from
    };
    std::vector<Chord> chords;

    void add_loaded(const Tracers &, const Interpolation &);
    void add_edges(const Tracers &, const Interpolation &);
    void add_points(const Points &, const Interpolation &, double inverse_density);
  };
} // namespace solid
