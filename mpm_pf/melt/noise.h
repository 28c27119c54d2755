// Thermal noise: fluctuations of the heat current, after Karma and Rappel (Phys. Rev. E 60, 3614,
// 1999).
//
//   d theta/dt = ... - div q,   <q_m(r,t) q_n(r',t')> = 2 D F delta_mn delta(r-r') delta(t-t')
//
// On the mesh every face carries q = sqrt(2 D F/(dx dy h)) R, R a random number of mean 0 and
// variance 1, and each node takes the difference of its faces: heat is moved, never made. Only the
// conserved current matters for side branches, so the order parameter gets no noise of its own.
//
// R is the sum of two uniform numbers (exact mean and variance, |R| < 2.45): the diffusion adds up
// many of them before anything is seen. They come from Philox4x32-10 (Salmon et al., SC 2011),
// whose counter is (pair of nodes, line, step): the numbers depend on nothing else, so not on
// threads, tiles or restarts.
//
// At a no-flux wall the current through the wall is zero, and the faces along the wall, half as
// wide, have twice the variance. A symmetry side is refused unless the noise is `mirrored`: then it
// is that of the reflected whole. On a domain without symmetry sides, mirrored noise is folded
// about the middle, so that the quarter and the whole see the same fluctuations.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "medium/cuts.h"

namespace melt
{
  using medium::Field;
  using medium::Mesh;

  /// Philox4x32-10: four random words from a counter and a key.
  std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                      std::array<std::uint32_t, 2> key);

  class Noise
  {
  public:
    struct Options
    {
      double strength = 0.;    // F, length^2: F_u W0^2
      double diffusivity = 0.; // D, length^2/time
      std::uint64_t seed = 1;
      bool mirrored = false;
    };
    /// Throws std::invalid_argument for a symmetry side without `mirrored`, or for a whole domain
    /// to be folded that has an odd number of cells.
    Noise(const Mesh &, const Options &);

    /// Adds what the currents of step number `step`, of length `h` (time), carry into the rows
    /// first <= j < end of theta. Ghosts are not touched. `cuts`: walls that have moved in (null:
    /// none); no current passes them, and faces that they have made longer have less variance.
    template <class Real>
    void add_rows(Field<Real> &theta, int first, int end, long step, double h,
                  const medium::Cuts *cuts = nullptr) const;

    /// Memory held: the noise is made anew in every step.
    std::size_t bytes() const;
    /// How often add_rows() was called, by any thread.
    long calls() const { return counted; }

  private:
    mutable std::atomic<long> counted{0};
    /// Where the nodes and faces of one axis take their numbers from. Face f lies between nodes
    /// f - 1 and f and takes the number of node f - 1: when folded, both counted from the middle.
    struct Axis
    {
      int count = 0, middle = 0, drawn = 0; // nodes; where it is folded (0: not); lines of numbers
      bool periodic = false;
      std::vector<float> width; // of each node: factor on currents along this line

      int node(int i) const;
      int face(int f) const;
      float sign(int f) const; // -1 where a current through the face is a reflection
      /// Numbers of all nodes, or of all faces with their signs, from those that were drawn.
      void spread_to_nodes(const float *drawn, float *numbers) const;
      void spread_to_faces(const float *drawn, float *numbers) const;

    private:
      int lower_node(int f) const;
    };
    static Axis make_axis(int count, medium::Boundary low, medium::Boundary high, bool fold);
    void draw(int line, long step, float *x, float *y) const;

    Options options;
    Mesh mesh;
    Axis axis[2];
  };
} // namespace melt
