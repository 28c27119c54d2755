#include "scene/error_list.h"

#include <algorithm>
#include <map>

#include "scene/document.h"
#include "scene/nearest_name.h"
#include "scene/reader.h"

namespace scene
{
  void ErrorList::add(const Value &at, const std::string &cause, const std::string &allowed,
                      const std::string &remedy)
  {
    const std::string where = at.place.file + ":" + std::to_string(at.place.line) + ": " +
                              (at.place.key.empty() ? "" : at.place.key + ": ");
    std::string text = underlined(at, where + cause);
    if (!allowed.empty())
      text += "\n  allowed: " + allowed;
    if (!remedy.empty())
      text += "\n  remedy: " + remedy;
    list.push_back({at.place, text});
  }

  void ErrorList::add(const SourceLocation &place, const std::string &text)
  {
    list.push_back({place, text});
  }

  bool ErrorList::about(const Value &value) const
  {
    const std::string &path = value.place.key;
    return std::any_of(list.begin(), list.end(),
                       [&](const Error &c) {
                         return c.place.key == path ||
                                c.place.key.compare(0, path.size() + 1, path + ".") == 0;
                       });
  }

  std::string ErrorList::text() const
  {
    std::map<std::string, std::size_t> order; // files as they first appear
    for (const Error &c : list)
      order.emplace(c.place.file, order.size());
    std::vector<Error> sorted = list;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const Error &a, const Error &b)
                     {
                       return std::make_pair(order.at(a.place.file), a.place.line) <
                              std::make_pair(order.at(b.place.file), b.place.line);
                     });
    std::string result = list.size() == 1
                             ? "the scene has 1 error\n"
                             : "the scene has " + std::to_string(list.size()) + " errors\n";
    for (const Error &c : sorted)
      result += "\n" + c.text + "\n";
    return result;
  }

  void ErrorList::throw_if_any() const
  {
    if (!list.empty())
      throw BadScene(text());
  }

  std::string did_you_mean(const std::string &written, const std::vector<std::string> &known)
  {
    const std::string nearest = nearest_name(written, known);
    return nearest.empty() ? "" : "did you mean \"" + nearest + "\"?";
  }

  std::string comma_separated(const std::vector<std::string> &words)
  {
    std::string text;
    for (const std::string &word : words)
      text += (text.empty() ? "" : ", ") + word;
    return text;
  }
} // namespace scene
