#include "scene/value.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace scene
{
  namespace
  {
    auto position(const std::vector<Entry> &entries, const std::string_view key)
    {
      return std::lower_bound(entries.begin(), entries.end(), key,
                              [](const Entry &e, const std::string_view k) { return e.key < k; });
    }

    std::string quoted(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : text)
      {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
          result += {'\\', c};
        else if (c == '\n')
          result += "\\n";
        else if (code < 0x20 || code == 0x7f)
        {
          char escape[8];
          std::snprintf(escape, sizeof escape, "\\u%04X", code);
          result += escape;
        }
        else
          result += c;
      }
      return result + "\"";
    }

    std::string key_text(const std::string &key)
    {
      const bool bare = !key.empty() && key.find_first_not_of("abcdefghijklmnopqrstuvwxyz"
                                                              "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                              "0123456789_-") == std::string::npos;
      return bare ? key : quoted(key);
    }

    template <class List, class Text>
    std::string joined(const List &list, const char *open, const char *close, const Text &text)
    {
      std::string result = open;
      for (const auto &item : list)
        result += (&item == &list.front() ? "" : ", ") + text(item);
      return result + close;
    }

    std::string lines(const Value &table)
    {
      std::string result;
      for (const auto &[key, value] : table.entries)
        result += key_text(key) + " = " + inline_text(value) + "\n";
      return result;
    }
  } // namespace

  std::string number_text(const double number)
  {
    if (std::isnan(number))
      return "nan";
    if (std::isinf(number))
      return number > 0. ? "inf" : "-inf";
    char digits[40];
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    return {digits, end};
  }

  bool Value::is_list_of_tables() const
  {
    return kind == Kind::array && !items.empty() &&
           std::all_of(items.begin(), items.end(),
                       [](const Value &v) { return v.kind == Kind::table; });
  }

  const Value *Value::find(const std::string_view key) const
  {
    if (kind != Kind::table)
      return nullptr;
    const auto at = position(entries, key);
    return at != entries.end() && at->key == key ? &at->value : nullptr;
  }

  Value *Value::find(const std::string_view key)
  {
    return const_cast<Value *>(static_cast<const Value *>(this)->find(key));
  }

  void Value::set(const std::string &key, Value value)
  {
    if (Value *present = find(key))
      *present = std::move(value);
    else
      entries.insert(position(entries, key), Entry{key, std::move(value)});
  }

  void Value::erase(const std::string_view key)
  {
    const auto at = position(entries, key);
    if (at != entries.end() && at->key == key)
      entries.erase(at);
  }

  std::string label(const Value &item, const std::string &section, const std::size_t index)
  {
    for (const char *key : {"name", "on", "side"})
      if (const Value *value = item.find(key); value && value->kind == Value::Kind::text)
        return value->text;
    return section + " " + std::to_string(index + 1);
  }

  std::string inline_text(const Value &value)
  {
    switch (value.kind)
    {
    case Value::Kind::boolean:
      return value.boolean ? "true" : "false";
    case Value::Kind::integer:
      return std::to_string(value.integer);
    case Value::Kind::number:
    {
      const std::string text = number_text(value.number);
      // TOML tells floats from integers by a point, an exponent, inf or nan.
      return text.find_first_of(".einf") == std::string::npos ? text + ".0" : text;
    }
    case Value::Kind::text:
      return quoted(value.text);
    case Value::Kind::array:
      return joined(value.items, "[", "]", [](const Value &v) { return inline_text(v); });
    case Value::Kind::table:
      break;
    }
    return joined(value.entries, "{", "}",
                  [](const Entry &e) { return key_text(e.key) + " = " + inline_text(e.value); });
  }

  std::string canonical_text(const Value &root)
  {
    std::string top, tables, lists;
    for (const auto &[key, value] : root.entries)
      if (value.kind == Value::Kind::table)
        tables += "\n[" + key_text(key) + "]\n" + lines(value);
      else if (value.is_list_of_tables())
        for (const Value &item : value.items)
          lists += "\n[[" + key_text(key) + "]]\n" + lines(item);
      else
        top += key_text(key) + " = " + inline_text(value) + "\n";
    return top + tables + lists;
  }
} // namespace scene
