// A TOML document as a plain tree that remembers where each value was written, free of toml11's
// types (whose headers take 15 s to compile and stay in document.cc).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "scene/domain.h"

namespace scene
{
  struct Entry;
  struct Origin; // the source line, for underlining; known to document.cc only

  struct Value
  {
    enum class Kind
    {
      boolean,
      integer,
      number,
      text,
      array,
      table
    } kind = Kind::table;
    bool boolean = false;
    std::int64_t integer = 0;
    double number = 0.; // of integers too
    std::string text;
    std::vector<Value> items;   // of an array
    std::vector<Entry> entries; // of a table, sorted by key
    SourceLocation place;       // key: the whole path, "support.top.displacement"
    std::shared_ptr<const Origin> origin;

    bool is_number() const { return kind == Kind::integer || kind == Kind::number; }
    /// An array of tables, as [[support]] makes it.
    bool is_list_of_tables() const;
    /// The entry of that key, or null if this is no table or has none.
    const Value *find(std::string_view key) const;
    Value *find(std::string_view key);
    /// Sets or replaces an entry.
    void set(const std::string &key, Value value);
    void erase(std::string_view key);
  };

  struct Entry
  {
    std::string key;
    Value value;
  };

  /// By which an entry of a list of tables is addressed: its name, else `on`, else `side`, else
  /// "<section> <number from 1>".
  std::string label(const Value &item, const std::string &section, std::size_t index);

  /// As TOML: top-level keys, then sections, then lists of tables, each sorted by key; numbers so
  /// that they are read back to the same bits.
  std::string canonical_text(const Value &root);

  /// A value on one line, as in a message.
  std::string inline_text(const Value &);

  /// The shortest decimal form that is read back to the same bits.
  std::string number_text(double);
} // namespace scene
