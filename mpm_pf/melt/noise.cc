#include "melt/noise.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace melt
{
  using medium::Boundary;
  using medium::Edge;

  namespace
  {
    using Words = std::array<std::uint32_t, 4>;

    inline void philox_rounds(std::uint32_t &c0, std::uint32_t &c1, std::uint32_t &c2,
                              std::uint32_t &c3, std::uint32_t k0, std::uint32_t k1)
    {
      for (int round = 0; round < 10; ++round)
      {
        const std::uint64_t p = std::uint64_t{0xD2511F53u} * c0;
        const std::uint64_t q = std::uint64_t{0xCD9E8D57u} * c2;
        const auto p_high = static_cast<std::uint32_t>(p >> 32);
        const auto q_high = static_cast<std::uint32_t>(q >> 32);
        c0 = q_high ^ c1 ^ k0;
        c1 = static_cast<std::uint32_t>(q);
        c2 = p_high ^ c3 ^ k1;
        c3 = static_cast<std::uint32_t>(p);
        k0 += 0x9E3779B9u;
        k1 += 0xBB67AE85u;
      }
    }

    /// Sum of the two 16-bit halves of a word, about its mean: a whole number, exact in float.
    inline float centred_sum(std::uint32_t word)
    {
      return static_cast<float>(static_cast<std::int32_t>((word & 0xFFFFu) + (word >> 16)) - 65535);
    }

    /// Standard deviation of centred_sum: two uniform numbers on 65536 values.
    const double sum_deviation = std::sqrt((65536. * 65536. - 1.) / 6.);

    /// Half of a line of numbers, rounded up: the counters that it takes.
    int pairs(int drawn)
    {
      return (drawn + 1) / 2;
    }
  } // namespace

  Words philox(Words c, std::array<std::uint32_t, 2> key)
  {
    philox_rounds(c[0], c[1], c[2], c[3], key[0], key[1]);
    return c;
  }

  std::size_t Noise::bytes() const
  {
    return sizeof(*this) + (axis[0].width.capacity() + axis[1].width.capacity()) * sizeof(float);
  }

  Noise::Axis Noise::make_axis(int count, Boundary low, Boundary high, bool fold)
  {
    Axis made;
    const int last = count - 1;
    made.count = count;
    made.periodic = low == Boundary::periodic;
    made.middle = fold ? last / 2 : 0;
    made.drawn = count - made.middle;
    for (int i = 0; i < count; ++i)
    {
      const bool wall =
          (i == 0 && low == Boundary::no_flux) || (i == last && high == Boundary::no_flux);
      made.width.push_back(wall ? std::sqrt(2.f) : 1.f);
    }
    return made;
  }

  int Noise::Axis::node(int i) const
  {
    return periodic ? i % (count - 1) : std::abs(i - middle);
  }

  /// Node at the lower side of a face; beyond a mirror that of the face inside, turned round.
  int Noise::Axis::lower_node(int f) const
  {
    const int cells = count - 1;
    return periodic ? (f - 1 + cells) % cells : std::clamp(f - 1, 0, cells - 1);
  }

  int Noise::Axis::face(int f) const
  {
    const int lower = lower_node(f);
    return lower >= middle ? lower - middle : middle - 1 - lower;
  }

  float Noise::Axis::sign(int f) const
  {
    const bool beyond = !periodic && (f == 0 || f == count);
    const bool folded = lower_node(f) < middle;
    return beyond != folded ? -1.f : 1.f;
  }

  void Noise::Axis::spread_to_nodes(const float *drawn, float *numbers) const
  {
    std::reverse_copy(drawn + 1, drawn + 1 + middle, numbers);
    std::copy(drawn, drawn + this->drawn, numbers + middle);
    numbers[count - 1] = drawn[node(count - 1)];
  }

  void Noise::Axis::spread_to_faces(const float *drawn, float *numbers) const
  {
    for (int f = 1; f <= middle; ++f)
      numbers[f] = -drawn[middle - f];
    std::copy(drawn, drawn + this->drawn - 1, numbers + 1 + middle);
    for (const int end : {0, count})
      numbers[end] = sign(end) * drawn[face(end)];
  }

  Noise::Noise(const Mesh &m, const Options &o) : options(o), mesh(m)
  {
    bool symmetry = false, periodic = false;
    for (const Boundary side : mesh.boundary)
    {
      symmetry = symmetry || side == Boundary::symmetry;
      periodic = periodic || side == Boundary::periodic;
    }
    if (symmetry && !options.mirrored)
      throw std::invalid_argument("noise with a symmetry side: fluctuations are not symmetric; set "
                                  "noise.mirrored = true or take the whole domain");
    const bool fold = options.mirrored && !symmetry && !periodic;
    if (fold && (mesh.nodes[0] % 2 == 0 || mesh.nodes[1] % 2 == 0))
      throw std::invalid_argument("mirrored noise on a whole domain needs an even number of cells "
                                  "each way, so that a node lies in the middle");
    axis[0] = make_axis(mesh.nodes[0], mesh.side(Edge::left), mesh.side(Edge::right), fold);
    axis[1] = make_axis(mesh.nodes[1], mesh.side(Edge::bottom), mesh.side(Edge::top), fold);
  }

  /// Numbers of one line: currents along x and along y, in units of 1/sum_deviation. A counter
  /// serves a node of the line's first half and one of its second.
  void Noise::draw(int line, long step, float *x, float *y) const
  {
    const auto row = static_cast<std::uint32_t>(line);
    const auto number = static_cast<std::uint64_t>(step);
    const auto low = static_cast<std::uint32_t>(number);
    const auto high = static_cast<std::uint32_t>(number >> 32);
    const auto key0 = static_cast<std::uint32_t>(options.seed);
    const auto key1 = static_cast<std::uint32_t>(options.seed >> 32);
    const int half = pairs(axis[0].drawn);
    float *far_x = x + half, *far_y = y + half;
#pragma omp simd
    for (int i = 0; i < half; ++i)
    {
      std::uint32_t c0 = static_cast<std::uint32_t>(i), c1 = row, c2 = low, c3 = high;
      philox_rounds(c0, c1, c2, c3, key0, key1);
      x[i] = centred_sum(c0);
      y[i] = centred_sum(c1);
      far_x[i] = centred_sum(c2);
      far_y[i] = centred_sum(c3);
    }
  }

  namespace
  {
    /// Factor on currents along a line of nodes whose faces a wall has changed to size m.
    float width_at(const medium::Cut &cut)
    {
      return static_cast<float>(1. / std::sqrt(cut.size()));
    }

    /// Takes back what came through walls at the left and right of a row, and divides by their
    /// cells.
    template <class Real>
    void stop_at_columns(Real *row, const medium::Cuts &walls, Real wide, const float *through)
    {
      if (const auto &left = walls.at(Edge::left))
      {
        const auto i = static_cast<std::size_t>(left->last);
        row[i] += wide * ((1 - Real(1. / left->size())) * Real(through[i + 1]) - Real(through[i]));
      }
      if (const auto &right = walls.at(Edge::right))
      {
        const auto i = static_cast<std::size_t>(right->last);
        row[i] += wide * (Real(through[i + 1]) - (1 - Real(1. / right->size())) * Real(through[i]));
      }
    }
  } // namespace

  template <class Real>
  void Noise::add_rows(Field<Real> &theta, int first, int end, long step, double h,
                       const medium::Cuts *cuts) const
  {
    counted.fetch_add(1, std::memory_order_relaxed);
    const medium::Cuts none, &walls = cuts ? *cuts : none;
    std::vector<float> width = axis[0].width;
    for (const Edge edge : {Edge::left, Edge::right})
      if (const auto &cut = walls.at(edge))
        width[static_cast<std::size_t>(cut->last)] = width_at(*cut);
    const int nx = mesh.nodes[0];
    const auto nodes = static_cast<std::size_t>(nx);
    const auto drawn = static_cast<std::size_t>(2 * pairs(axis[0].drawn));
    const double dx = mesh.spacing[0], dy = mesh.spacing[1];
    const double current = std::sqrt(2. * options.diffusivity * options.strength / (dx * dy * h));
    const Real along_x = Real(h / dx * current / sum_deviation);
    const Real along_y = Real(h / dy * current / sum_deviation);
    std::vector<float> x(drawn), y(drawn), unused(drawn), through(nodes + 1), below(nodes),
        above(nodes);
    // Currents through the faces between rows `face` - 1 and `face`, given the numbers of their
    // line.
    const auto spread_up = [&](int face, std::vector<float> &target)
    {
      const float sign = axis[1].sign(face);
      axis[0].spread_to_nodes(y.data(), target.data());
      for (std::size_t i = 0; i < nodes; ++i)
        target[i] *= sign * width[i];
    };
    draw(axis[1].face(first), step, unused.data(), y.data());
    spread_up(first, below);
    for (int j = first; j < end; ++j)
    {
      draw(axis[1].node(j), step, x.data(), y.data());
      axis[0].spread_to_faces(x.data(), through.data());
      if (axis[1].face(j + 1) != axis[1].node(j))
        draw(axis[1].face(j + 1), step, unused.data(), y.data());
      spread_up(j + 1, above);
      // A wall lets no current pass: a cell of size m takes that of its inner face, divided by m.
      Real from_above = along_y, from_below = along_y;
      float wide_row = axis[1].width[static_cast<std::size_t>(j)];
      if (const auto &low = walls.at(Edge::bottom); low && low->last == j)
        from_above = along_y / Real(low->size()), from_below = 0, wide_row = width_at(*low);
      if (const auto &high = walls.at(Edge::top); high && high->last == j)
        from_below = along_y / Real(high->size()), from_above = 0, wide_row = width_at(*high);
      const Real wide = along_x * Real(wide_row);
      Real *row = theta.row(j);
      const float *across = through.data(), *up = above.data(), *down = below.data();
#pragma omp simd
      for (int i = 0; i < nx; ++i) // the difference of whole numbers is exact
        row[i] -= wide * Real(across[i + 1] - across[i]) +
                  (from_above * Real(up[i]) - from_below * Real(down[i]));
      stop_at_columns(row, walls, wide, across);
      std::swap(below, above);
    }
  }

  template void Noise::add_rows(Field<double> &, int, int, long, double,
                                const medium::Cuts *) const;
  template void Noise::add_rows(Field<float> &, int, int, long, double, const medium::Cuts *) const;
} // namespace melt
