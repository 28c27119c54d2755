#include "scene/merge.h"

#include <algorithm>

#include "scene/keys.h"

namespace scene
{
  namespace
  {
    // A later `every` replaces an earlier `times`: they exclude each other.
    void drop_excluded(Value &base, const Value &over, const std::string &section)
    {
      const Section *known = find_section(section);
      if (!known)
        return;
      for (const Alternatives &choice : known->alternatives)
        for (const std::string &key : choice.keys)
          if (over.find(key))
            for (const std::string &other : choice.keys)
              if (!over.find(other))
                base.erase(other);
    }

    void merge_tables(Value &base, const Value &over, const std::string &section);

    void merge_lists(Value &base, const Value &over, const std::string &section)
    {
      for (const Value &item : over.items)
      {
        Value *same = nullptr;
        for (std::size_t i = 0; i < base.items.size(); ++i)
          if ((item.find("name") || item.find("on") || item.find("side")) &&
              label(base.items[i], section, i) == label(item, section, 0))
            same = &base.items[i];
        if (same)
          merge_tables(*same, item, section);
        else
          base.items.push_back(item);
      }
    }

    void merge_tables(Value &base, const Value &over, const std::string &section)
    {
      drop_excluded(base, over, section);
      for (const auto &[key, value] : over.entries)
      {
        Value *present = base.find(key);
        const std::string below = section.empty() ? key : section + "." + key;
        if (present && present->kind == Value::Kind::table && value.kind == Value::Kind::table)
          merge_tables(*present, value, below);
        else if (present && present->is_list_of_tables() && value.is_list_of_tables())
          merge_lists(*present, value, below);
        else
          base.set(key, value);
      }
    }

    void override_list(Value &list, const Value &over, const std::string &section,
                       ErrorList &errors)
    {
      std::vector<std::string> labels;
      for (std::size_t i = 0; i < list.items.size(); ++i)
        labels.push_back(label(list.items[i], section, i));
      for (const auto &[name, value] : over.entries)
      {
        auto at = std::find(labels.begin(), labels.end(), name);
        for (std::size_t i = 0; i < labels.size() && at == labels.end(); ++i)
          if (name == std::to_string(i + 1))
            at = labels.begin() + static_cast<std::ptrdiff_t>(i);
        if (at == labels.end() || value.kind != Value::Kind::table)
          errors.add(value, "there is no [[" + section + "]] \"" + name + "\" to override",
                     comma_separated(labels), did_you_mean(name, labels));
        else
          merge_tables(list.items[static_cast<std::size_t>(at - labels.begin())], value, section);
      }
    }
  } // namespace

  void merge(Value &base, const Value &over)
  {
    merge_tables(base, over, "");
  }

  void override_with(Value &base, const Value &over, ErrorList &errors)
  {
    Value rest = over;
    if (const Value *include = over.find("include"))
    {
      errors.add(*include, "an override cannot include a file: files are merged before it",
                 "include at the top of a scene file", "write a scene that includes both");
      rest.erase("include");
    }
    for (const auto &[key, value] : over.entries)
      if (value.kind == Value::Kind::table)
      {
        Value *present = base.find(key);
        const Section *section = find_section(key);
        if (present && present->is_list_of_tables())
          override_list(*present, value, key, errors);
        else if (section && section->repeated)
          errors.add(value, "there is no [[" + key + "]] to override");
        else
          continue;
        rest.erase(key);
      }
    merge(base, rest);
  }

  void remove_key(Value &base, const std::string &path, ErrorList &errors)
  {
    const std::size_t dot = path.find('.');
    const std::string section = dot == std::string::npos ? "" : path.substr(0, dot);
    const std::string key = dot == std::string::npos ? path : path.substr(dot + 1);
    const Section *known = find_section(section);
    const SourceLocation place{"--set", 1, path};
    if (!known || known->repeated || !known->find(key))
    {
      errors.add(place, "[error] --set:1: " + path + "= takes a key away, and there is no key " +
                            path + " in any section\n  allowed: section.key=");
      return;
    }
    if (Value *table = section.empty() ? &base : base.find(section))
      table->erase(key);
  }
} // namespace scene
