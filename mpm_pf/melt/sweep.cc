#include "melt/sweep.h"

#include <sstream>

#include "medium/numerical_error.h"
#include "melt/band_scheduler.h"
#include "melt/noise.h"

namespace melt
{
  using medium::Activity;
  using medium::Boundary;
  using medium::Edge;
  using medium::Tiles;

  namespace
  {
    template <class Real>
    Rows<Real> rows_round(const Field<Real> &f, int j, int i)
    {
      return {f.row(j - 1) + i, f.row(j) + i, f.row(j + 1) + i};
    }

    template <class Real>
    Angles<Real> angles_at(const AngleFields<Real> &angle, int j, int i)
    {
      if (!angle.cosine)
        return {};
      return {angle.cosine->row(j) + i, angle.cosine->row(j + 1) + i, angle.sine->row(j) + i,
              angle.sine->row(j + 1) + i};
    }

    template <class Real>
    std::string first_bad_node(const Field<Real> &phi, const Mesh &mesh)
    {
      for (int j = 0; j < mesh.nodes[1]; ++j)
        for (int i = 0; i < mesh.nodes[0]; ++i)
          if (!(phi(i, j) * phi(i, j) < Real(4)))
          {
            const medium::Point at = mesh.position(i, j);
            std::ostringstream text;
            text << "phi = " << phi(i, j) << " at (" << at[0] << ", " << at[1] << "), node (" << i
                 << ", " << j << ")";
            return text.str();
          }
      return "phi";
    }
  } // namespace

  template <class Real>
  Sweep<Real>::Sweep(const Mesh &m, bool tiles)
      : mesh(m), skipping(tiles), map(m), states(map.activity.size()),
        runs(static_cast<std::size_t>(map.rows))
  {
  }

  template <class Real>
  std::size_t Sweep<Real>::bytes() const
  {
    return spare_phi.bytes() + spare_theta.bytes();
  }

  template <class Real>
  void Sweep<Real>::run(const Fields &fields, const Coefficients<Real> &k, long first_step,
                        long steps)
  {
    const medium::Cuts none, &cuts = fields.cuts ? *fields.cuts : none;
    if (fields.phi)
    {
      medium::fill_behind(*fields.phi, cuts, mesh);
      spare_phi = *fields.phi;
    }
    if (fields.theta)
    {
      medium::fill_behind(*fields.theta, cuts, mesh);
      spare_theta = *fields.theta;
    }
    const Pair pair{{fields.phi, &spare_phi}, {fields.theta, &spare_theta}};
    bool finite = true;
    long done = 0;
    BandScheduler scheduler(map.rows, mesh.side(Edge::bottom) == Boundary::periodic);
#pragma omp parallel
    for (long step = 0; step < steps;
         step += steps_between_updates) // all threads leave at the break
    {
      const int old = static_cast<int>(step & 1);
#pragma omp for schedule(dynamic, 1) reduction(&& : finite)
      for (int band = 0; band < map.rows; ++band)
        finite = classify_band(fields, pair, old, band) && finite;
#pragma omp single
      {
        update_tiles(pair, old);
        done = step;
        scheduler.start();
      }
      if (!finite)
        break;
      const long count = std::min<long>(steps_between_updates, steps - step);
      scheduler.run(count,
                    [&](const int band, const long ahead)
                    {
                      step_band(fields, pair, static_cast<int>((step + ahead) & 1), k, band,
                                first_step + step + ahead);
                    });
#pragma omp barrier
    }
    const bool swapped = (finite ? steps : done) % 2 != 0;
    if (swapped && fields.phi)
      fields.phi->swap(spare_phi);
    if (swapped && fields.theta)
      fields.theta->swap(spare_theta);
    if (!finite)
      throw medium::NumericalError("growth step " + std::to_string(first_step + done) + ": " +
                                   first_bad_node(*fields.phi, mesh) +
                                   " has left its bounds: shorten the step (growth.step_fraction)");
    if (fields.phi)
      medium::fill_behind(*fields.phi, cuts, mesh);
    if (fields.theta)
      medium::fill_behind(*fields.theta, cuts, mesh);
  }

  /// Rows of a band between the walls; none (first >= end) where the whole band lies behind one.
  template <class Real>
  typename Sweep<Real>::RowRange Sweep<Real>::rows_of(int band, const medium::Cuts *cuts) const
  {
    const int first = map.first_row(band), end = map.end_row(band);
    if (!cuts)
      return {first, end};
    return {std::max(first, cuts->first(1)), std::min(end, cuts->end(1, mesh.nodes[1]))};
  }

  /// The row behind a wall as the last row before it will read it. Only the band that holds this
  /// last row reads or writes it, so threads do not meet there.
  template <class Real>
  void Sweep<Real>::fill_behind_walls(const Fields &fields, const Pair &pair, int old,
                                      RowRange rows) const
  {
    for (const Edge edge : {Edge::bottom, Edge::top})
    {
      const auto &cut = fields.cuts->at(edge);
      if (!cut || cut->last < rows.first || cut->last >= rows.end)
        continue;
      if (fields.phi)
        medium::fill_next_row(*pair.phi[old], *cut, edge, mesh.nodes[0]);
      if (fields.theta)
        medium::fill_next_row(*pair.theta[old], *cut, edge, mesh.nodes[0]);
    }
  }

  template <class Real>
  void Sweep<Real>::step_band(const Fields &fields, const Pair &pair, int old,
                              const Coefficients<Real> &k, int band, long step) const
  {
    const RowRange rows = rows_of(band, fields.cuts);
    if (rows.first >= rows.end)
      return;
    if (fields.cuts)
      fill_behind_walls(fields, pair, old, rows);
    for (const Run &run : runs[static_cast<std::size_t>(band)])
      if (run.activity == Activity::active && fields.phi)
        step_active(fields, pair, old, k, run, rows);
      else if (run.activity != Activity::frozen && fields.theta)
        step_heat(pair, old, k, run, rows);
    if (fields.noise && fields.theta)
      fields.noise->add_rows(*pair.theta[1 - old], rows.first, rows.end, step, fields.step,
                             fields.cuts);
    for (int j = rows.first; j < rows.end; ++j)
    {
      if (fields.phi)
        finish_row(*pair.phi[1 - old], *pair.phi[old], j, fields.cuts);
      if (fields.theta)
        finish_row(*pair.theta[1 - old], *pair.theta[old], j, fields.cuts);
    }
  }

  template <class Real>
  void Sweep<Real>::step_active(const Fields &fields, const Pair &pair, int old,
                                const Coefficients<Real> &k, Run run, RowRange rows) const
  {
    const bool varying = fields.angle.cosine != nullptr, heat = fields.theta != nullptr;
    const Field<Real> &phi = *pair.phi[old];
    const int count = run.end - run.begin;
    Staged<Real> staged;
    const auto faces_up = varying ? flux_up<true, Real> : flux_up<false, Real>;
    const auto faces_left = varying ? flux_right<true, Real> : flux_right<false, Real>;
    const auto update =
        varying ? (heat ? update_row<true, true, Real> : update_row<true, false, Real>)
                : (heat ? update_row<false, true, Real> : update_row<false, false, Real>);
    const int before = rows.first - 1;
    slopes_along(phi.row(before) + run.begin, count, staged.along);
    faces_up(rows_round(phi, before, run.begin), angles_at(fields.angle, before, run.begin), count,
             k, staged);
    for (int j = rows.first; j < rows.end; ++j)
    {
      staged.advance();
      const Rows<Real> here = rows_round(phi, j, run.begin);
      const Angles<Real> angle = angles_at(fields.angle, j, run.begin);
      faces_up(here, angle, count, k, staged);
      faces_left(here.here, angle, count, k, staged);
      update(here, heat ? rows_round(*pair.theta[old], j, run.begin) : here, angle, staged, count,
             k, pair.phi[1 - old]->row(j) + run.begin,
             heat ? pair.theta[1 - old]->row(j) + run.begin : nullptr);
    }
  }

  template <class Real>
  void Sweep<Real>::step_heat(const Pair &pair, int old, const Coefficients<Real> &k, Run run,
                              RowRange rows) const
  {
    for (int j = rows.first; j < rows.end; ++j)
      diffuse_row(rows_round(*pair.theta[old], j, run.begin), run.end - run.begin, k,
                  pair.theta[1 - old]->row(j) + run.begin);
  }

  /// Border values that stay fixed, and the one ghost layer that the next step reads.
  template <class Real>
  void Sweep<Real>::finish_row(Field<Real> &next, const Field<Real> &last, int j,
                               const medium::Cuts *cuts) const
  {
    const int nx = mesh.nodes[0], ny = mesh.nodes[1];
    const Boundary left = mesh.side(Edge::left), right = mesh.side(Edge::right);
    const Boundary bottom = mesh.side(Edge::bottom), top = mesh.side(Edge::top);
    Real *row = next.row(j);
    if ((j == 0 && bottom == Boundary::fixed) || (j == ny - 1 && top == Boundary::fixed))
      std::copy(last.row(j), last.row(j) + nx, row);
    if (left == Boundary::fixed)
      row[0] = last.row(j)[0];
    if (right == Boundary::fixed)
      row[nx - 1] = last.row(j)[nx - 1];
    if (cuts)
      medium::fill_next_columns(row, *cuts);
    row[-1] = row[medium::source_index(-1, nx, left, right)];
    row[nx] = row[medium::source_index(nx, nx, left, right)];
    for (const int ghost : {-1, ny})
      if (medium::source_index(ghost, ny, bottom, top) == j)
        std::copy(row - 1, row + nx + 1, next.row(ghost) - 1);
  }

  template <class Real>
  bool Sweep<Real>::classify_band(const Fields &fields, const Pair &pair, int now, int band)
  {
    bool finite = true;
    for (int column = 0; column < map.columns; ++column)
    {
      medium::TileState<Real> &state = states[map.index(column, band)];
      state = medium::classify_tile(map, column, band, fields.phi ? pair.phi[now] : nullptr,
                                    fields.theta ? pair.theta[now] : nullptr, flatness, finite);
      if (!skipping)
        state.well = 0;
      if (fields.noise)
        state.constant = false;
    }
    return finite;
  }

  template <class Real>
  void Sweep<Real>::update_tiles(const Pair &pair, int now)
  {
    const std::vector<Activity> before = map.activity;
    medium::update_activity(map, mesh, states);
    for (int row = 0; row < map.rows; ++row)
    {
      std::vector<Run> &list = runs[static_cast<std::size_t>(row)];
      list.clear();
      for (int column = 0; column < map.columns; ++column)
      {
        const Activity activity = map.at(column, row);
        if (activity < before[map.index(column, row)])
          rest_in_both(pair, now, column, row, activity);
        if (!list.empty() && list.back().activity == activity &&
            map.end_node(column) - list.back().begin <= run_length)
          list.back().end = map.end_node(column);
        else
          list.push_back({map.first_node(column), map.end_node(column), activity});
      }
    }
  }

  /// A tile that stops being written must read the same from either copy.
  template <class Real>
  void Sweep<Real>::rest_in_both(const Pair &pair, int now, int column, int row,
                                 Activity activity) const
  {
    const int begin = map.first_node(column), end = map.end_node(column);
    for (int j = map.first_row(row); j < map.end_row(row); ++j)
    {
      if (pair.phi[0])
        std::copy(pair.phi[now]->row(j) + begin, pair.phi[now]->row(j) + end,
                  pair.phi[1 - now]->row(j) + begin);
      if (activity == Activity::frozen && pair.theta[0])
        std::copy(pair.theta[now]->row(j) + begin, pair.theta[now]->row(j) + end,
                  pair.theta[1 - now]->row(j) + begin);
    }
  }

  template class Sweep<double>;
  template class Sweep<float>;
} // namespace melt
