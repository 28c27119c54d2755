#include "scene/reader.h"

#include "scene/build.h"
#include "scene/document.h"
#include "scene/hash.h"
#include "scene/presets.h"
#include "scene/rules.h"

namespace scene
{
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
