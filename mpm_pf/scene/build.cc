#include "scene/build.h"

#include <algorithm>

#include "scene/keys.h"
#include "scene/quantities.h"

namespace scene
{
  namespace
  {
    // The tables of a [[list]], none if it is absent or not written as one.
    std::vector<const Value *> tables(const Value &root, const std::string &name, ErrorList &errors)
    {
      std::vector<const Value *> result;
      const Value *list = root.find(name);
      if (!list)
        return result;
      if (!list->is_list_of_tables())
      {
        errors.add(*list, "read a single value or table", "[[" + name + "]]",
                   "write its header with double brackets: [[" + name + "]]");
        return result;
      }
      for (const Value &item : list->items)
        result.push_back(&item);
      return result;
    }

    const Value *table(const Value &root, const std::string &name, ErrorList &errors)
    {
      const Value *value = root.find(name);
      if (value && value->kind != Value::Kind::table)
      {
        errors.add(*value, "read " + inline_text(*value).substr(0, 60), "[" + name + "]",
                   "write it as one section with the header [" + name + "]");
        return nullptr;
      }
      return value;
    }

    template <class T>
    const Value *read_one(const std::string &name, T &field, const Value &root, ErrorList &errors)
    {
      const Value *at = table(root, name, errors);
      if (at)
        read_section(*find_section(name), *at, &field, errors);
      return at;
    }

    template <class T>
    void read_module(const std::string &name, std::optional<T> &field, const Value &root,
                     ErrorList &errors)
    {
      T module;
      if (const Value *at = read_one(name, module, root, errors))
      {
        module.place = at->place;
        field = module;
      }
    }

    void read_modules(Draft &draft, ErrorList &errors)
    {
      Scene &s = draft.scene;
      const Value &root = draft.root;
      read_module("body_force", s.body_force, root, errors);
      read_module("solid", s.solid, root, errors);
      read_module("mpm", s.mpm, root, errors);
      read_module("fe", s.fe, root, errors);
      read_module("phase_field", s.phase_field, root, errors);
      read_module("growth", s.growth, root, errors);
      read_module("heat", s.heat, root, errors);
      read_module("orientation", s.orientation, root, errors);
      read_module("noise", s.noise, root, errors);
      read_module("imposed", s.imposed, root, errors);
      read_module("advection", s.advection, root, errors);
      read_module("extension", s.extension, root, errors);
    }

    // False if what was written does not say where.
    bool place_load(const WhereInput &input, const Value &at, const std::string &section,
                    const std::size_t index, Where &where, std::string &name)
    {
      if (input.on)
        where = *input.on;
      else if (input.segment)
        where = *input.segment;
      else if (input.region)
        where = *input.region;
      name = label(at, section, index);
      return input.on || input.segment || input.region;
    }

    void read_supports(Draft &draft, ErrorList &errors)
    {
      std::size_t index = 0;
      for (const Value *at : tables(draft.root, "support", errors))
      {
        SupportInput input;
        read_section(*find_section("support"), *at, &input, errors);
        Support support{"", {}, input.displacement, at->place};
        if (place_load(input, *at, "support", index++, support.where, support.name))
        {
          draft.scene.supports.push_back(support);
          draft.supports.push_back(at);
        }
      }
    }

    void read_tractions(Draft &draft, ErrorList &errors)
    {
      std::size_t index = 0;
      for (const Value *at : tables(draft.root, "traction", errors))
      {
        TractionInput input;
        read_section(*find_section("traction"), *at, &input, errors);
        Traction traction{"", {}, input.traction, input.pressure, at->place};
        if (place_load(input, *at, "traction", index++, traction.where, traction.name))
        {
          draft.scene.tractions.push_back(traction);
          draft.tractions.push_back(at);
        }
      }
    }

    void read_walls(Draft &draft, ErrorList &errors)
    {
      for (const Value *at : tables(draft.root, "wall", errors))
      {
        Wall wall;
        read_section(*find_section("wall"), *at, &wall, errors);
        wall.place = at->place;
        draft.scene.walls.push_back(wall);
        draft.walls.push_back(at);
      }
    }

    template <class Input, class Build>
    void read_list(const std::string &name, Draft &draft, ErrorList &errors, const Build &build_one)
    {
      for (const Value *at : tables(draft.root, name, errors))
      {
        Input input;
        read_section(*find_section(name), *at, &input, errors);
        build_one(input, *at, draft, errors);
      }
    }

    // What a line, point or region records if it does not say: all that the modules know.
    void complete_quantities(Scene &s)
    {
      std::vector<std::string> of_solid, of_melt;
      if (s.solid)
        for (const std::string_view name : solid_quantities)
          if (!s.growth || !needs_initial_position(name))
            of_solid.emplace_back(name);
      if (s.phase_field)
        of_melt.emplace_back("phi");
      if (s.heat)
        of_melt.emplace_back("theta");
      if (s.orientation)
        of_melt.emplace_back("crystal_angle");
      if (s.imposed)
        of_melt.insert(of_melt.end(), {"velocity_x", "velocity_y"});
      for (Probe &probe : s.probes)
      {
        const bool region = std::holds_alternative<RegionProbe>(probe.kind);
        if (probe.of.empty() && s.growth && std::holds_alternative<SnapshotProbe>(probe.kind))
          probe.of = of_solid; // the melt's fields are always in it
        if (!probe.of.empty() || !(region || std::holds_alternative<LineProbe>(probe.kind) ||
                                   std::holds_alternative<PointProbe>(probe.kind)))
          continue;
        probe.of = of_solid;
        if (!region)
          probe.of.insert(probe.of.end(), of_melt.begin(), of_melt.end());
      }
    }

    void refuse_unknown_sections(const Value &root, ErrorList &errors)
    {
      std::vector<std::string> known = find_section("")->key_names();
      for (const Section &section : sections())
        if (!section.name.empty())
          known.push_back(section.name);
      for (const auto &[name, value] : root.entries)
        if (!find_section("")->find(name) && !(find_section(name) && !name.empty()))
          errors.add(value, "there is no such section or key", comma_separated(known),
                     did_you_mean(name, known));
      for (const Section &section : sections())
        if (section.required && !root.find(section.name))
          errors.add(root, "section [" + section.name + "] is missing", "",
                     "add [" + section.name + "]: " + section.sentence);
    }
  } // namespace

  bool fits(const Form &form, const std::vector<Form> &all, const Value &at, ErrorList &errors)
  {
    const auto has = [](const std::vector<std::string> &list, const std::string &key)
    { return std::find(list.begin(), list.end(), key) != list.end(); };
    bool good = true;
    for (const std::string &key : form.needed)
      if (!at.find(key))
      {
        good = false;
        errors.add(at, form.name + " needs \"" + key + "\"", comma_separated(form.needed),
                   "add " + key + " = ...");
      }
    for (const auto &[key, value] : at.entries)
      for (const Form &other : all)
        if ((has(other.needed, key) || has(other.possible, key)) && !has(form.needed, key) &&
            !has(form.possible, key))
        {
          good = false;
          errors.add(value, "\"" + key + "\" belongs to " + other.name + ", not to " + form.name,
                     comma_separated(form.needed) +
                         (form.possible.empty() ? "" : ", " + comma_separated(form.possible)),
                     "remove it");
          break;
        }
    return good;
  }

  void build(Draft &draft, ErrorList &errors)
  {
    Scene &s = draft.scene;
    const Value &root = draft.root;
    refuse_unknown_sections(root, errors);
    Header header;
    read_section(*find_section(""), root, &header, errors);
    s.title = header.title;
    s.accuracy = header.accuracy ? word(*header.accuracy) : "";
    UnitsInput units;
    read_one("units", units, root, errors);
    s.units = units.system;
    if (const Value *at = read_one("domain", s.domain, root, errors))
      s.domain.place = at->place;
    if (const Value *at = read_one("clock", s.clock, root, errors))
      s.clock.place = at->place;
    read_list<BodyInput>("body", draft, errors, build_body);
    read_supports(draft, errors);
    read_tractions(draft, errors);
    read_list<ProbeInput>("probe", draft, errors, build_probe);
    read_walls(draft, errors);
    read_modules(draft, errors);
    for (Wall &wall : s.walls)
      if (!wall.start_time && !wall.start_distance && s.phase_field)
        wall.start_distance = 8. * s.phase_field->width;
    complete_quantities(s);
  }
} // namespace scene
