#include "record/checkpoint.h"

#include <filesystem>
#include <stdexcept>

#include "record/cannot_write.h"
#include "record/hdf5_file.h"

namespace record
{
  namespace
  {
    constexpr auto format = "mpm_pf checkpoint 2";

    Checkpoint::Array read_array(const hid_t group, const std::string &name)
    {
      const hdf5::Handle dataset(H5Dopen2(group, name.c_str(), H5P_DEFAULT), name);
      const hdf5::Handle type(H5Dget_type(dataset), name);
      const std::size_t bytes = H5Tget_size(type);
      if (H5Tget_class(type) == H5T_FLOAT)
        return bytes == sizeof(double) ? Checkpoint::Array(hdf5::read<double>(group, name))
                                       : Checkpoint::Array(hdf5::read<float>(group, name));
      return bytes == sizeof(int) ? Checkpoint::Array(hdf5::read<int>(group, name))
                                  : Checkpoint::Array(hdf5::read<unsigned char>(group, name));
    }
  } // namespace

  std::string checkpoint_path(const std::string &record_path)
  {
    return std::filesystem::path(record_path).replace_extension(".checkpoint.h5").string();
  }

  template <class T>
  const std::vector<T> &Checkpoint::get(const std::string &name) const
  {
    const auto found = arrays.find(name);
    if (found == arrays.end())
      throw std::runtime_error("the checkpoint holds no array \"" + name + "\"");
    if (const auto *values = std::get_if<std::vector<T>>(&found->second))
      return *values;
    throw std::runtime_error("the checkpoint holds \"" + name + "\" as numbers of another type");
  }
  template const std::vector<double> &Checkpoint::get(const std::string &) const;
  template const std::vector<float> &Checkpoint::get(const std::string &) const;
  template const std::vector<int> &Checkpoint::get(const std::string &) const;
  template const std::vector<unsigned char> &Checkpoint::get(const std::string &) const;

  double Checkpoint::number(const std::string &name) const
  {
    const auto found = numbers.find(name);
    if (found == numbers.end())
      throw std::runtime_error("the checkpoint holds no number \"" + name + "\"");
    return found->second;
  }

  std::vector<std::string> Checkpoint::names_below(const std::string &prefix) const
  {
    std::vector<std::string> names;
    const auto look = [&](const auto &all)
    {
      for (auto one = all.lower_bound(prefix); one != all.end() && one->first.rfind(prefix, 0) == 0;
           ++one)
        names.push_back(one->first.substr(prefix.size()));
    };
    look(arrays);
    look(numbers);
    return names;
  }

  struct CheckpointFile::File
  {
    hdf5::Handle file, numbers;
  };

  namespace
  {
    /// Work on the checkpoint's file whose failure is one of writing.
    template <class Work>
    void writing(const std::string &part, const Work &work)
    {
      try
      {
        work();
      }
      catch (const std::runtime_error &error)
      {
        throw CannotWrite(hdf5::cannot_write(part, error.what()));
      }
    }
  } // namespace

  CheckpointFile::CheckpointFile(const std::string &path, const scene::Scene &scene) : path(path)
  {
    writing(path + ".part",
            [&]
            {
              hdf5::Handle part = hdf5::open_file(path + ".part", hdf5::Mode::create);
              hdf5::set_attribute(part, "format", std::string(format));
              hdf5::set_attribute(part, "scene_hash", scene.hash);
              hdf5::open_group(part, "arrays", true);
              hdf5::Handle numbers = hdf5::open_group(part, "numbers", true);
              file = std::make_unique<File>(File{std::move(part), std::move(numbers)});
            });
  }

  CheckpointFile::~CheckpointFile()
  {
    if (!file)
      return;
    file.reset();
    std::error_code none;
    std::filesystem::remove(path + ".part", none); // it is no use and takes the room of what is
  }

  void CheckpointFile::put(const std::string &name, const Array values)
  {
    const std::string dataset = "arrays/" + name;
    writing(path + ".part",
            [&]
            {
              hdf5::open_group(file->file, dataset.substr(0, dataset.rfind('/')), true);
              std::visit([&](const auto &of_type) { hdf5::write(file->file, dataset, of_type); },
                         values);
            });
  }

  void CheckpointFile::put(const std::string &name, const double number)
  {
    writing(path + ".part", [&] { hdf5::set_attribute(file->numbers, name, number); });
  }

  void CheckpointFile::finish()
  {
    writing(path + ".part", [&] { file->numbers.close("numbers"); });
    hdf5::write_file(std::move(file->file), path + ".part", [](hid_t) {});
    file.reset();
    std::filesystem::rename(path + ".part", path);
  }

  namespace
  {
    /// Paths of all datasets below `group`, which may hold groups in turn.
    std::vector<std::string> datasets_below(const hid_t file, const std::string &group)
    {
      std::vector<std::string> all;
      for (const std::string &name : hdf5::members(file, group))
      {
        const std::string path = group + "/" + name;
        const hdf5::Handle object(H5Oopen(file, path.c_str(), H5P_DEFAULT), path);
        if (H5Iget_type(object) == H5I_GROUP)
          for (const std::string &below : datasets_below(file, path))
            all.push_back(below);
        else
          all.push_back(path);
      }
      return all;
    }
  } // namespace

  Checkpoint Checkpoint::load(const std::string &path, const scene::Scene &scene)
  {
    if (!std::filesystem::exists(path))
      throw std::runtime_error("no checkpoint " + path + ": start without --resume");
    const hdf5::Handle file = hdf5::open_to_resume(path, hdf5::Mode::read);
    if (hdf5::text_attribute(file, "format") != format)
      throw std::runtime_error(path + " is not a checkpoint of this program and this version of "
                                      "it: start without --resume");
    if (hdf5::text_attribute(file, "scene_hash") != scene.hash)
      throw std::runtime_error(path + " was made from another scene than " + scene.file +
                               " as it is now: start without --resume");
    Checkpoint checkpoint;
    const hdf5::Handle all_numbers = hdf5::open_group(file, "numbers");
    for (const std::string &name : hdf5::attributes(all_numbers))
      checkpoint.numbers[name] = hdf5::number_attribute(all_numbers, name);
    for (const std::string &dataset : datasets_below(file, "arrays"))
      checkpoint.arrays[dataset.substr(std::string("arrays/").size())] = read_array(file, dataset);
    return checkpoint;
  }
} // namespace record
