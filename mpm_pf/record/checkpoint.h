// A checkpoint: named arrays and numbers from which a run goes on to the same bits.
//
// Each module puts its own arrays ("solid/x") and takes them back; the checkpoint knows nothing of
// what they mean. Doubles are stored as they are, so nothing is rounded. The file is written as
// <path>.part and renamed: a kill while saving leaves the checkpoint before.
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "scene/scene.h"

namespace record
{
  class Checkpoint
  {
  public:
    using Array = std::variant<std::vector<double>, std::vector<float>, std::vector<int>,
                               std::vector<unsigned char>>;

    /// Keep `values` under `name`; the same name again replaces them.
    void put(const std::string &name, Array values) { arrays[name] = std::move(values); }
    void put(const std::string &name, double number) { numbers[name] = number; }

    bool has(const std::string &name) const { return arrays.count(name) + numbers.count(name) > 0; }
    /// The array `name`. Throws std::runtime_error if there is none or it holds another type.
    template <class T>
    const std::vector<T> &get(const std::string &name) const;
    /// The number `name`. Throws std::runtime_error if there is none.
    double number(const std::string &name) const;

    /// Write everything to `path`, in place of an earlier checkpoint there, with the hash of the
    /// scene. Throws std::runtime_error if it cannot be written.
    void save(const std::string &path, const scene::Scene &) const;
    /// Read what save() wrote. Throws std::runtime_error if there is no such file, it is no
    /// checkpoint, or it was made from another scene.
    static Checkpoint load(const std::string &path, const scene::Scene &);

  private:
    std::map<std::string, Array> arrays;
    std::map<std::string, double> numbers;
  };
} // namespace record
