// A checkpoint: named arrays and numbers from which a run goes on to the same bits.
//
// Each module puts its own arrays ("solid/x") and takes them back; the checkpoint knows nothing of
// what they mean. Doubles are stored as they are, so nothing is rounded. The file is written as
// <path>.part and renamed: a kill while saving leaves the checkpoint before.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "scene/scene.h"

namespace record
{
  /// Where the run that writes the record at `record_path` keeps its checkpoint: beside it.
  std::string checkpoint_path(const std::string &record_path);

  /// Takes arrays and numbers, each under a name of its own.
  class CheckpointTarget
  {
  public:
    using Array = std::variant<std::vector<double>, std::vector<float>, std::vector<int>,
                               std::vector<unsigned char>>;
    virtual ~CheckpointTarget() = default;
    virtual void put(const std::string &name, Array values) = 0;
    virtual void put(const std::string &name, double number) = 0;
  };

  /// Writes what it is given at once, so that no copy of a whole state stands in memory.
  class CheckpointFile : public CheckpointTarget
  {
  public:
    /// Opens <path>.part. Throws CannotWrite if it cannot be written, as do all that follow.
    CheckpointFile(const std::string &path, const scene::Scene &);
    ~CheckpointFile() override;
    void put(const std::string &name, Array values) override;
    void put(const std::string &name, double number) override;
    /// All is there: take the place of an earlier checkpoint at `path`.
    void finish();

  private:
    struct File;
    std::string path;
    std::unique_ptr<File> file;
  };

  /// In memory.
  class Checkpoint : public CheckpointTarget
  {
  public:
    /// The same name again replaces what it held.
    void put(const std::string &name, Array values) override { arrays[name] = std::move(values); }
    void put(const std::string &name, double number) override { numbers[name] = number; }

    bool has(const std::string &name) const { return arrays.count(name) + numbers.count(name) > 0; }
    /// What follows `prefix` in the names of arrays and numbers that begin with it.
    std::vector<std::string> names_below(const std::string &prefix) const;
    /// The array `name`. Throws std::runtime_error if there is none or it holds another type.
    template <class T>
    const std::vector<T> &get(const std::string &name) const;
    /// The number `name`. Throws std::runtime_error if there is none.
    double number(const std::string &name) const;

    /// Read what a CheckpointFile wrote. Throws std::runtime_error if there is no such file, it is
    /// no checkpoint, or it was made from another scene.
    static Checkpoint load(const std::string &path, const scene::Scene &);

  private:
    std::map<std::string, Array> arrays;
    std::map<std::string, double> numbers;
  };
} // namespace record
