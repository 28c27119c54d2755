// One section of a TOML file, read key by key, remembering what was asked for: whatever was written
// but never asked for is an error, and every error of a file is collected with file, line and the
// underlined text before any is thrown.
//
// toml11 takes long to compile, so it appears in section.cc only.
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace verify
{
  /// Bad input: expect.toml, tradeoff.toml, stability.toml or the command line. Exit code 2.
  struct BadInput : std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };

  class Section
  {
  public:
    /// Parses `path`. A value that is a table with only the keys smoke, quick, full stands for its
    /// entry of `suite` (absent there: as if not written). Throws BadInput if the file cannot be
    /// read or parsed.
    Section(const std::string &path, const std::string &suite);

    bool has(const std::string &key);
    bool is_text(const std::string &key);
    bool is_list(const std::string &key);
    bool is_section(const std::string &key);

    std::string required_text(const std::string &key);
    std::string text(const std::string &key, const std::string &otherwise = "");
    /// A string, or a list of strings.
    std::vector<std::string> texts(const std::string &key);
    std::optional<double> number(const std::string &key);
    /// A number or a string, as the text of an expression.
    std::optional<std::string> expression(const std::string &key);
    /// A list of numbers or strings (nested lists are flattened), or one of them alone.
    std::vector<std::string> expressions(const std::string &key);
    /// The values of a list as TOML text, ready for `--set key=value`.
    std::vector<std::string> literals(const std::string &key);
    std::optional<Section> section(const std::string &key);
    std::vector<Section> sections(const std::string &key);
    /// Keys in the order of the file.
    std::vector<std::string> keys() const;

    /// Notes an error at `key` (or at the section if it has none).
    void add_error(const std::string &key, const std::string &message,
                   const std::string &remedy = "");
    /// Notes every key that was never asked for, with the nearest known one.
    void refuse_unused();
    /// Throws BadInput with all errors noted so far in the whole file, if any.
    void throw_errors() const;

  private:
    struct Node;
    explicit Section(std::shared_ptr<Node>);
    std::shared_ptr<Node> node;
  };
} // namespace verify
