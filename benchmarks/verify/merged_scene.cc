#include "merged_scene.h"

#include "scene/document.h"
#include "scene/keys.h"
#include "scene/presets.h"
#include "stability_file.h"

namespace verify
{
  namespace
  {
    const scene::Value *entry_of(const scene::Value &list, const std::string &section,
                                 const std::string &name)
    {
      for (std::size_t i = 0; i < list.items.size(); ++i)
        if (label(list.items[i], section, i) == name || name == std::to_string(i + 1))
          return &list.items[i];
      return nullptr;
    }

    /// Null if nothing is written there.
    const scene::Value *written(const scene::Value &root, const std::string &key)
    {
      const scene::Value *at = &root;
      std::string section;
      for (std::size_t begin = 0; at && begin <= key.size();)
      {
        const std::size_t end = std::min(key.find('.', begin), key.size());
        const std::string part = key.substr(begin, end - begin);
        at = at->is_list_of_tables() ? entry_of(*at, section, part) : at->find(part);
        section = section.empty() ? part : section;
        begin = end + 1;
      }
      return at;
    }
  } // namespace

  std::string MergedScene::value(const std::string &key) const
  {
    if (const scene::Value *found = written(root, key))
      return inline_text(*found);
    const std::size_t first = key.find('.'), last = key.rfind('.');
    const bool top = first == std::string::npos;
    const scene::Section *section = scene::find_section(top ? "" : key.substr(0, first));
    const scene::Key *known = section ? section->find(top ? key : key.substr(last + 1)) : nullptr;
    return known && !known->default_text.empty() ? known->default_text : absent_value;
  }

  MergedScene merged_scene(const Case &c, const Run &run)
  {
    scene::ErrorList complaints;
    MergedScene merged{scene::load_document(c.folder + "/" + run.scene, run.set, complaints)};
    scene::apply_preset(merged.root, complaints);
    return merged;
  }
} // namespace verify
