#include "scene/document.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include <toml.hpp>

#include "scene/merge.h"

namespace scene
{
  struct Origin
  {
    toml::source_location location;
  };

  namespace
  {
    using Toml = toml::basic_value<toml::discard_comments, std::map, std::vector>;
    // toml11 parses by recursion: deeper nesting than any scene needs would overflow the stack.
    constexpr int deepest_nesting = 32;

    Value value_of(const Toml &toml, const std::string &path, ErrorList &errors);

    /// toml11 reads what has no room in a number as the largest one there is.
    template <class Number>
    void refuse_overflow(const Value &value, const Number number, ErrorList &errors)
    {
      if (number == std::numeric_limits<Number>::max())
        errors.add(value, "read a number that is too large for a computer's", "a finite number",
                   "correct its exponent or its digits");
    }

    void fill(Value &value, const Toml &toml, ErrorList &errors)
    {
      const std::string &path = value.place.key;
      if (toml.is_boolean())
      {
        value.kind = Value::Kind::boolean;
        value.boolean = toml.as_boolean();
      }
      else if (toml.is_integer())
      {
        value.kind = Value::Kind::integer;
        value.integer = toml.as_integer();
        value.number = static_cast<double>(value.integer);
        refuse_overflow(value, toml.as_integer(), errors);
      }
      else if (toml.is_floating())
      {
        value.kind = Value::Kind::number;
        value.number = toml.as_floating();
        refuse_overflow(value, value.number, errors);
      }
      else if (toml.is_string())
      {
        value.kind = Value::Kind::text;
        value.text = toml.as_string().str;
      }
      else if (toml.is_array())
      {
        value.kind = Value::Kind::array;
        for (const Toml &item : toml.as_array())
          value.items.push_back(value_of(item, path, errors));
      }
      else if (toml.is_table())
        for (const auto &[key, entry] : toml.as_table())
          value.set(key, value_of(entry, path.empty() ? key : path + "." + key, errors));
      else
        errors.add(value, "read a date or time", "numbers, texts, true or false, arrays, tables",
                   "write a number");
    }

    Value value_of(const Toml &toml, const std::string &path, ErrorList &errors)
    {
      Value value;
      const toml::source_location location = toml.location();
      value.place = {location.file_name(), static_cast<int>(location.line()), path};
      value.origin = std::make_shared<Origin>(Origin{location});
      fill(value, toml, errors);
      return value;
    }

    // Past the comment or text that starts at `i`, else `i`: what stands there nests nothing.
    std::size_t past_text(const std::string &text, const std::size_t i)
    {
      const char quote = text[i];
      if (quote == '#')
        return std::min(text.find('\n', i), text.size());
      if (quote != '"' && quote != '\'')
        return i;
      const std::string triple(3, quote);
      if (text.compare(i, 3, triple) == 0)
        return std::min(text.find(triple, i + 3), text.size() - 3) + 3;
      std::size_t k = i + 1;
      while (k < text.size() && text[k] != quote && text[k] != '\n')
        k += quote == '"' && text[k] == '\\' ? 2 : 1;
      return std::min(k + 1, text.size());
    }

    bool nested_too_deeply(const std::string &text)
    {
      int depth = 0, dots = 0;
      for (std::size_t i = 0; i < text.size(); ++i)
      {
        const std::size_t next = past_text(text, i);
        if (next > i)
        {
          i = next - 1;
          continue;
        }
        const char c = text[i];
        depth += (c == '[' || c == '{') - (c == ']' || c == '}');
        dots = c == '\n' || c == ',' || c == '=' ? 0 : dots + (c == '.');
        if (depth > deepest_nesting || dots > deepest_nesting)
          return true;
      }
      return false;
    }

    // An empty table when the text is no TOML, after an error.
    Value parsed(const std::string &text, const std::string &name, ErrorList &errors)
    {
      Value empty;
      empty.place = {name, 1, ""};
      if (nested_too_deeply(text))
      {
        errors.add(empty.place, "[error] " + name + ": brackets or dotted keys nest deeper than " +
                                    std::to_string(deepest_nesting) + " levels, as no scene does");
        return empty;
      }
      try
      {
        std::istringstream stream(text);
        return value_of(toml::parse<toml::discard_comments, std::map, std::vector>(stream, name),
                        "", errors);
      }
      catch (const toml::exception &error)
      {
        const int line = static_cast<int>(error.location().line());
        std::string what = error.what();
        if (what.compare(0, 8, "[error] ") == 0)
          what.erase(0, 8);
        errors.add(SourceLocation{name, line, ""},
                   "[error] " + name + ":" + std::to_string(line) + ": no valid TOML: " + what);
      }
      catch (const std::exception &error)
      {
        errors.add(empty.place, "[error] " + name + ": no valid TOML: " + error.what());
      }
      return empty;
    }

    // Entries of a list are named by their label, which is known once the list is merged.
    void name_places(Value &value, const std::string &path)
    {
      value.place.key = path;
      const bool list = value.is_list_of_tables();
      for (std::size_t i = 0; i < value.items.size(); ++i)
        name_places(value.items[i], list ? path + "." + label(value.items[i], path, i) : path);
      for (auto &[key, entry] : value.entries)
        name_places(entry, path.empty() ? key : path + "." + key);
    }

    // The files that are being read, outermost first: for circles and for the place of an include.
    using Stack = std::vector<std::filesystem::path>;

    Value file_tree(const std::filesystem::path &path, const Value *included_at, Stack stack,
                    ErrorList &errors);

    Value with_includes(Value tree, const std::filesystem::path &path, const Stack &stack,
                        ErrorList &errors)
    {
      const Value *include = tree.find("include");
      if (!include)
        return tree;
      std::vector<Value> files =
          include->kind == Value::Kind::array ? include->items : std::vector<Value>{*include};
      Value base;
      base.place = tree.place;
      base.origin = tree.origin;
      for (const Value &file : files)
        if (file.kind == Value::Kind::text)
          merge(base, file_tree(path.parent_path() / file.text, &file, stack, errors));
        else
          errors.add(file, "read " + inline_text(file), "a file name or a list of them",
                     "include = \"scene.toml\"");
      tree.erase("include");
      merge(base, tree);
      return base;
    }

    Value file_tree(const std::filesystem::path &path, const Value *included_at, Stack stack,
                    ErrorList &errors)
    {
      const std::string name = path.lexically_normal().string();
      Value empty;
      empty.place = {name, 1, ""};
      const auto refuse = [&](const std::string &cause, const std::string &remedy)
      {
        if (included_at)
          errors.add(*included_at, cause, "", remedy);
        else
          errors.add(empty.place, "[error] " + cause + "\n  remedy: " + remedy);
        return empty;
      };
      std::error_code ignored;
      const auto identity = std::filesystem::weakly_canonical(path, ignored);
      if (std::find(stack.begin(), stack.end(), identity) != stack.end())
        return refuse(name + " includes itself", "break the circle of includes");
      stack.push_back(identity);
      std::ifstream stream(path, std::ios::binary);
      if (!std::filesystem::is_regular_file(path, ignored) || !stream)
        return refuse(
            name + ": there is no such file, or it cannot be read",
            "give the path of a scene file; an include is relative to the including file");
      std::ostringstream text;
      text << stream.rdbuf();
      return with_includes(parsed(text.str(), name, errors), path, stack, errors);
    }

    // On a command line `accuracy=draft` means the text: a bare word would be no TOML.
    std::string as_toml(const std::string &override_text)
    {
      const std::size_t equals = override_text.find('=');
      if (equals == std::string::npos)
        return override_text;
      const std::string word = override_text.substr(equals + 1);
      const bool bare =
          !word.empty() && word != "true" && word != "false" && word != "inf" && word != "nan" &&
          !std::isdigit(static_cast<unsigned char>(word[0])) &&
          std::all_of(word.begin(), word.end(),
                      [](const unsigned char c) { return std::isalnum(c) || c == '_'; });
      return bare ? override_text.substr(0, equals + 1) + '"' + word + '"' : override_text;
    }
  } // namespace

  Value load_document(const std::string &path, const std::vector<std::string> &overrides,
                      ErrorList &errors)
  {
    Value tree = file_tree(path, nullptr, {}, errors);
    for (const std::string &text : overrides)
      if (text.size() > 1 && text.back() == '=' && text.find('=') == text.size() - 1)
        remove_key(tree, text.substr(0, text.size() - 1), errors);
      else
        override_with(tree, parsed(as_toml(text), "--set", errors), errors);
    name_places(tree, "");
    return tree;
  }

  std::string underlined(const Value &at, const std::string &message)
  {
    if (!at.origin)
      return "[error] " + message;
    return toml::detail::format_underline(message, {{at.origin->location, "here"}}, {}, false);
  }
} // namespace scene
