// From the merged tree to the plain data of scene.h.
#pragma once

#include <vector>

#include "scene/error_list.h"
#include "scene/inputs.h"
#include "scene/scene.h"
#include "scene/value.h"

namespace scene
{
  /// A scene that is being read, and where each entry of its lists was written.
  struct Draft
  {
    Scene scene;
    const Value &root;
    std::vector<const Value *> bodies, supports, tractions, probes, walls;
    std::string file_texts; // of the outline files, for the hash
  };

  /// Fills `draft.scene` from `draft.root`; what cannot be filled becomes an error and is left
  /// out.
  void build(Draft &draft, ErrorList &);

  /// The shape of a body; errors for missing and foreign keys, unreadable files.
  void build_body(const BodyInput &, const Value &at, Draft &, ErrorList &);

  /// The kind of a probe, likewise.
  void build_probe(const ProbeInput &, const Value &at, Draft &, ErrorList &);

  /// What a shape or kind is made of: the keys it needs and those it may have beside.
  struct Form
  {
    std::string name;
    std::vector<std::string> needed, possible;
  };

  /// Complains of keys that this form needs and `at` lacks, and of keys that belong to other forms
  /// only. True if nothing was wrong.
  bool fits(const Form &form, const std::vector<Form> &all, const Value &at, ErrorList &);

  /// Outlines of a CSV file of x,y lines, separated by blank lines; lines that start with # are
  /// skipped. Throws std::runtime_error naming file and line.
  std::vector<Polyline> read_outlines(const std::string &text, const std::string &file);
} // namespace scene
