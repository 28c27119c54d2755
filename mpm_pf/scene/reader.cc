#include "scene/reader.h"

#include <cstdio>

#include "scene/build.h"
#include "scene/document.h"
#include "scene/presets.h"
#include "scene/rules.h"

namespace scene
{
  namespace
  {
    // FNV-1a, 64 bits, from two starting values: 128 bits together.
    std::string hash_of(const std::string &text)
    {
      std::uint64_t a = 0xcbf29ce484222325ull, b = 0x84222325cbf29ce4ull;
      for (const char c : text)
      {
        a = (a ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
        b = (b ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
      }
      char hex[33];
      std::snprintf(hex, sizeof hex, "%016llx%016llx", static_cast<unsigned long long>(a),
                    static_cast<unsigned long long>(b));
      return hex;
    }
  } // namespace

  Scene read_scene(const std::string &path, const std::vector<std::string> &overrides)
  {
    ErrorList errors;
    Value root = load_document(path, overrides, errors);
    // Without a readable file every section would be missing too: one error tells it all.
    if (root.entries.empty())
      errors.throw_if_any();
    apply_preset(root, errors);
    Draft draft{{}, root, {}, {}, {}, {}, {}, {}};
    build(draft, errors);
    check_rules(draft, errors);
    errors.throw_if_any();
    draft.scene.file = path;
    draft.scene.text = canonical_text(root);
    draft.scene.hash = hash_of(draft.scene.text + draft.file_texts);
    return draft.scene;
  }
} // namespace scene
