#include "section.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include <fmt/format.h>
#include <toml.hpp>

#include "scene/nearest_name.h"

namespace verify
{
  namespace
  {
    const std::set<std::string> suites{"smoke", "quick", "full"};

    bool is_by_suite(const toml::value &value)
    {
      if (!value.is_table() || value.as_table().empty())
        return false;
      const auto &table = value.as_table();
      return std::all_of(table.begin(), table.end(),
                         [](const auto &entry) { return suites.count(entry.first) > 0; });
    }

    std::string number_text(const toml::value &value)
    {
      if (value.is_integer())
        return std::to_string(value.as_integer());
      const std::string text = fmt::format("{}", value.as_floating());
      return text.find_first_of(".eni") == std::string::npos ? text + ".0" : text; // stays a float
    }

    /// One line of TOML for a value; numbers as short as they can be read back.
    std::string literal(const toml::value &value)
    {
      if (value.is_integer() || value.is_floating())
        return number_text(value);
      if (!value.is_array())
        return toml::format(value, 1000000);
      std::string list;
      for (const auto &entry : value.as_array())
        list += (list.empty() ? "" : ", ") + literal(entry);
      return "[" + list + "]";
    }

    void flatten(const toml::value &value, std::vector<std::string> &texts, bool &good)
    {
      if (value.is_array())
        for (const auto &entry : value.as_array())
          flatten(entry, texts, good);
      else if (value.is_string())
        texts.push_back(value.as_string().str);
      else if (value.is_integer() || value.is_floating())
        texts.push_back(number_text(value));
      else
        good = false;
    }
  } // namespace

  struct Section::Node
  {
    toml::value value;
    std::string suite;
    std::shared_ptr<std::vector<std::string>> errors;
    std::set<std::string> asked;

    const toml::value *find(const std::string &key)
    {
      asked.insert(key);
      const auto &table = value.as_table();
      const auto found = table.find(key);
      if (found == table.end())
        return nullptr;
      if (!is_by_suite(found->second))
        return &found->second;
      const auto &by_suite = found->second.as_table();
      const auto entry = by_suite.find(suite);
      return entry == by_suite.end() ? nullptr : &entry->second;
    }
    void add_error(const toml::value &where, const std::string &message, const std::string &remedy)
    {
      errors->push_back(toml::format_error(message, where, remedy));
    }
  };

  Section::Section(std::shared_ptr<Node> n) : node(std::move(n)) {}

  Section::Section(const std::string &path, const std::string &suite)
      : node(std::make_shared<Node>())
  {
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
      throw BadInput(fmt::format("{}: cannot be read", path));
    try
    {
      node->value = toml::parse(stream, path);
    }
    catch (const std::exception &error)
    {
      throw BadInput(error.what());
    }
    node->suite = suite;
    node->errors = std::make_shared<std::vector<std::string>>();
  }

  bool Section::has(const std::string &key)
  {
    return node->find(key) != nullptr;
  }
  bool Section::is_text(const std::string &key)
  {
    const auto *value = node->find(key);
    return value && value->is_string();
  }
  bool Section::is_list(const std::string &key)
  {
    const auto *value = node->find(key);
    return value && value->is_array();
  }
  bool Section::is_section(const std::string &key)
  {
    const auto *value = node->find(key);
    return value && value->is_table();
  }

  std::string Section::required_text(const std::string &key)
  {
    if (!node->find(key))
      add_error("", fmt::format("the key `{}` is missing", key), "add " + key + " = \"...\"");
    return text(key);
  }

  std::string Section::text(const std::string &key, const std::string &otherwise)
  {
    const auto *value = node->find(key);
    if (!value)
      return otherwise;
    if (value->is_string())
      return value->as_string().str;
    node->add_error(*value, fmt::format("`{}` must be a string", key), "");
    return otherwise;
  }

  std::vector<std::string> Section::texts(const std::string &key)
  {
    const auto *value = node->find(key);
    if (!value)
      return {};
    if (value->is_string())
      return {value->as_string().str};
    std::vector<std::string> result;
    bool good = value->is_array();
    for (const auto &entry : good ? value->as_array() : toml::array())
    {
      good = good && entry.is_string();
      if (entry.is_string())
        result.push_back(entry.as_string().str);
    }
    if (!good)
      node->add_error(*value, fmt::format("`{}` must be a list of strings", key), "");
    return result;
  }

  std::optional<double> Section::number(const std::string &key)
  {
    const auto *value = node->find(key);
    if (!value)
      return {};
    if (value->is_integer())
      return static_cast<double>(value->as_integer());
    if (value->is_floating() && !std::isnan(value->as_floating()))
      return value->as_floating();
    node->add_error(*value, fmt::format("`{}` must be a number", key), "");
    return {};
  }

  std::optional<std::string> Section::expression(const std::string &key)
  {
    const auto texts = expressions(key);
    if (texts.size() > 1)
      add_error(key, fmt::format("`{}` must be one number or expression", key));
    return texts.empty() ? std::nullopt : std::optional<std::string>(texts.front());
  }

  std::vector<std::string> Section::expressions(const std::string &key)
  {
    const auto *value = node->find(key);
    std::vector<std::string> result;
    bool good = true;
    if (value)
      flatten(*value, result, good);
    if (!good)
      node->add_error(*value, fmt::format("`{}` must hold numbers or expressions", key), "");
    if (std::count(result.begin(), result.end(), "") > 0)
      node->add_error(*value, fmt::format("`{}` holds an empty expression", key),
                      "write a number or an expression, or leave the key out");
    return result;
  }

  std::vector<std::string> Section::literals(const std::string &key)
  {
    const auto *value = node->find(key);
    std::vector<std::string> result;
    if (!value)
      return result;
    if (!value->is_array())
    {
      node->add_error(*value, fmt::format("`{}` must be a list", key), "");
      return result;
    }
    for (const auto &entry : value->as_array())
      result.push_back(literal(entry));
    return result;
  }

  std::optional<Section> Section::section(const std::string &key)
  {
    const auto *value = node->find(key);
    if (!value)
      return {};
    if (!value->is_table())
    {
      node->add_error(*value, fmt::format("`{}` must be a table", key), "");
      return {};
    }
    return Section(std::make_shared<Node>(Node{*value, node->suite, node->errors, {}}));
  }

  std::vector<Section> Section::sections(const std::string &key)
  {
    const auto *value = node->find(key);
    std::vector<Section> result;
    if (!value)
      return result;
    bool good = value->is_array();
    for (const auto &entry : good ? value->as_array() : toml::array())
    {
      good = good && entry.is_table();
      if (entry.is_table())
        result.push_back(
            Section(std::make_shared<Node>(Node{entry, node->suite, node->errors, {}})));
    }
    if (!good)
      node->add_error(*value, fmt::format("write `{}` as [[{}]] sections", key, key), "");
    return result;
  }

  std::vector<std::string> Section::keys() const
  {
    // toml11 keeps tables unordered; their places put them back as they were written
    std::multimap<std::pair<std::size_t, std::size_t>, std::string> by_place;
    for (const auto &[key, value] : node->value.as_table())
      by_place.emplace(std::make_pair(value.location().line(), value.location().column()), key);
    std::vector<std::string> result;
    for (const auto &[place, key] : by_place)
      result.push_back(key);
    return result;
  }

  void Section::add_error(const std::string &key, const std::string &message,
                          const std::string &remedy)
  {
    const auto *value = key.empty() ? nullptr : node->find(key);
    node->add_error(value ? *value : node->value, message, remedy);
  }

  void Section::refuse_unused()
  {
    for (const auto &[key, value] : node->value.as_table())
      if (node->asked.count(key) == 0)
      {
        const std::string nearest =
            scene::nearest_name(key, {node->asked.begin(), node->asked.end()});
        node->add_error(value, fmt::format("the key `{}` is not known here", key),
                        nearest.empty() ? "" : "did you mean `" + nearest + "`?");
      }
  }

  void Section::throw_errors() const
  {
    if (node->errors->empty())
      return;
    std::string all;
    for (const auto &error : *node->errors)
      all += error + "\n";
    throw BadInput(all);
  }
} // namespace verify
