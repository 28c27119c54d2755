// Full state as named vectors of doubles; 32-bit numbers fit in them exactly.
#include "solid/area_budget.h"

namespace solid
{
  namespace
  {
    std::vector<double> pack(const Supports &supports)
    {
      std::vector<double> packed{supports.work, supports.work_done, supports.speed};
      for (const Support &support : supports.all)
        packed.insert(packed.end(),
                      {support.impulse[0], support.impulse[1], support.call_impulse[0],
                       support.call_impulse[1], support.displacement[0], support.displacement[1]});
      for (const HeldLine &line : supports.lines)
        packed.insert(packed.end(), line.stuck.begin(), line.stuck.end());
      return packed;
    }

    void unpack(const std::vector<double> &packed, Supports &supports)
    {
      std::size_t size = 3 + 6 * supports.all.size();
      for (const HeldLine &line : supports.lines)
        size += line.stuck.size();
      if (packed.size() != size)
        throw std::runtime_error("the checkpoint has other supports than the scene");
      supports.work = packed[0], supports.work_done = packed[1], supports.speed = packed[2];
      const double *next = &packed[3];
      for (Support &support : supports.all)
        for (Point *value : {&support.impulse, &support.call_impulse, &support.displacement})
          (*value)[0] = *next++, (*value)[1] = *next++;
      for (HeldLine &line : supports.lines)
        for (std::uint8_t &one : line.stuck)
          one = static_cast<std::uint8_t>(*next++);
    }

    std::vector<double> pack(const Grid &grid)
    {
      std::vector<double> packed{static_cast<double>(grid.row_begin),
                                 static_cast<double>(grid.row_end), grid.drift};
      for (const int column : grid.column_begin)
        packed.push_back(column);
      for (const int column : grid.column_end)
        packed.push_back(column);
      for (const Block &block : grid.blocks)
        packed.insert(packed.end(),
                      {static_cast<double>(block.row), static_cast<double>(block.begin),
                       static_cast<double>(block.end)});
      return packed;
    }

    void unpack(const std::vector<double> &packed, Grid &grid, const bool with_change)
    {
      grid.row_begin = static_cast<int>(packed.at(0)),
      grid.row_end = static_cast<int>(packed.at(1));
      grid.drift = packed.at(2);
      const auto rows = static_cast<std::size_t>(grid.row_end - grid.row_begin);
      const double *next = packed.data() + 3;
      grid.column_begin.assign(next, next + rows), next += rows;
      grid.column_end.assign(next, next + rows), next += rows;
      grid.blocks.clear();
      for (; next < packed.data() + packed.size(); next += 3)
        grid.blocks.push_back({static_cast<int>(next[0]), static_cast<std::size_t>(next[1]),
                               static_cast<std::size_t>(next[2])});
      allocate(grid, with_change);
    }

    constexpr std::size_t per_tracer = 7;

    std::vector<double> pack(const std::vector<Tracer> &outline)
    {
      std::vector<double> packed;
      for (const Tracer &t : outline)
        packed.insert(packed.end(), {t.X[0], t.X[1], t.x[0], t.x[1], static_cast<double>(t.lines),
                                     static_cast<double>(t.grip), static_cast<double>(t.loads)});
      return packed;
    }

    std::vector<Tracer> unpack(const std::vector<double> &packed)
    {
      std::vector<Tracer> outline;
      for (std::size_t k = 0; k + per_tracer <= packed.size(); k += per_tracer)
        outline.push_back({{packed[k], packed[k + 1]},
                           {packed[k + 2], packed[k + 3]},
                           static_cast<std::uint32_t>(packed[k + 4]),
                           static_cast<int>(packed[k + 5]),
                           static_cast<std::uint32_t>(packed[k + 6])});
      return outline;
    }

    const std::vector<double> &find(const Checkpoint &state, const std::string &name)
    {
      const auto found = state.find(name);
      if (found == state.end())
        throw std::runtime_error("the checkpoint lacks \"" + name + "\"; it is of another scene");
      return found->second;
    }
  } // namespace

  namespace
  {
    // The numbers of a checkpoint, in its order; `outlines` and `density` only to be compared.
    template <typename SolidOrConst, typename F>
    void for_each_number(SolidOrConst &solid, std::size_t &outlines, double &density, F &&f)
    {
      auto &energy = solid.energy;
      f(solid.time), f(solid.steps), f(solid.speed), f(solid.call_duration);
      f(energy.start), f(energy.kinetic), f(energy.dissipated);
      f(solid.loads.work), f(solid.loads.work_done), f(solid.points.active);
      f(outlines), f(density), f(energy.largest), f(energy.strained), f(energy.elastic_start);
      f(energy.kinetic_time), f(energy.internal_time), f(solid.last_step);
      for (int axis = 0; axis < 2; ++axis)
        f(solid.wall_balance.change[axis]), f(solid.wall_balance.impulse[axis]);
    }
    constexpr std::size_t number_count = 22;
  } // namespace

  void checkpoint(const Solid &solid,
                  const std::function<void(const std::string &, std::vector<double>)> &put)
  {
    for_each_array(solid.points, [&](const char *name, const auto &array)
                   { put(name, std::vector<double>(array.begin(), array.end())); });
    std::vector<double> numbers;
    std::size_t outlines = solid.tracers.outlines.size();
    double density = solid.material.density;
    for_each_number(solid, outlines, density,
                    [&](const auto &number) { numbers.push_back(static_cast<double>(number)); });
    put("numbers", numbers);
    put("supports", pack(solid.supports));
    put("grid", pack(solid.grid));
    if (solid.growing)
      put("growth", pack_growth(solid));
    for (std::size_t k = 0; k < solid.tracers.outlines.size(); ++k)
      put("outline " + std::to_string(k), pack(solid.tracers.outlines[k]));
  }

  Checkpoint checkpoint(const Solid &solid)
  {
    Checkpoint state;
    checkpoint(solid, [&](const std::string &name, std::vector<double> values)
               { state[name] = std::move(values); });
    return state;
  }

  void restore(Solid &solid, const Checkpoint &state)
  {
    const std::vector<double> &numbers = find(state, "numbers");
    if (numbers.size() != number_count)
      throw std::runtime_error("the checkpoint was written by another version of the program");
    std::size_t outlines = 0, k = 0;
    double density = 0.;
    for_each_number(solid, outlines, density,
                    [&](auto &number)
                    { number = static_cast<std::decay_t<decltype(number)>>(numbers[k++]); });
    if (density != solid.material.density)
      throw std::runtime_error("the checkpoint is of another scene: it has another density");
    unpack(find(state, "supports"), solid.supports);
    for_each_array(solid.points,
                   [&](const char *name, auto &array)
                   {
                     using Value = typename std::decay_t<decltype(array)>::value_type;
                     const std::vector<double> &saved = find(state, name);
                     array.resize(saved.size());
                     for (std::size_t p = 0; p < saved.size(); ++p)
                       array[p] = static_cast<Value>(saved[p]);
                   });
    solid.tracers.outlines.clear();
    for (std::size_t o = 0; o < outlines; ++o)
      solid.tracers.outlines.push_back(unpack(find(state, "outline " + std::to_string(o))));
    unpack(find(state, "grid"), solid.grid, solid.scheme.incremental());
    if (state.count("growth"))
      unpack_growth(solid, find(state, "growth"));
    solid.supports.marked.clear();
    resize_with_grid(solid);
  }
} // namespace solid
