#include "record/hdf5_file.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

namespace record::hdf5
{
  namespace
  {
    template <class T>
    hid_t memory_type();
    template <>
    hid_t memory_type<double>()
    {
      return H5T_NATIVE_DOUBLE;
    }
    template <>
    hid_t memory_type<float>()
    {
      return H5T_NATIVE_FLOAT;
    }
    template <>
    hid_t memory_type<int>()
    {
      return H5T_NATIVE_INT;
    }
    template <>
    hid_t memory_type<unsigned char>()
    {
      return H5T_NATIVE_UCHAR;
    }

    hsize_t count(const Shape &shape)
    {
      hsize_t product = 1;
      for (const hsize_t extent : shape)
        product *= extent;
      return product;
    }

    /// Creation properties without time stamps, so that equal content makes equal bytes.
    Handle creation_properties()
    {
      Handle properties(H5Pcreate(H5P_DATASET_CREATE), "HDF5 dataset properties");
      check(H5Pset_obj_track_times(properties, false), "HDF5 dataset properties");
      return properties;
    }

    /// Chunk for values of `shape`: whole rows of the first extent, about 256 KiB.
    Shape chunk_of(const Shape &shape, const std::size_t value_bytes)
    {
      Shape chunk = shape;
      hsize_t row_bytes = value_bytes;
      for (std::size_t k = 1; k < shape.size(); ++k)
        row_bytes *= std::max<hsize_t>(shape[k], 1);
      for (hsize_t &extent : chunk)
        extent = std::max<hsize_t>(extent, 1);
      chunk[0] =
          std::clamp<hsize_t>((hsize_t(1) << 18) / row_bytes, 1, std::max<hsize_t>(shape[0], 1));
      return chunk;
    }

    Shape shape_of(const hid_t dataset, const std::string &name)
    {
      const Handle space(H5Dget_space(dataset), "shape of " + name);
      Shape shape(H5Sget_simple_extent_ndims(space));
      if (!shape.empty())
        H5Sget_simple_extent_dims(space, shape.data(), nullptr);
      return shape;
    }
  } // namespace

  Handle open_group(const hid_t parent, const std::string &path, const bool create)
  {
    if (create && !exists(parent, path))
    {
      const Handle links(H5Pcreate(H5P_LINK_CREATE), path);
      check(H5Pset_create_intermediate_group(links, 1), path);
      const Handle properties(H5Pcreate(H5P_GROUP_CREATE), path);
      check(H5Pset_obj_track_times(properties, false), path);
      return Handle(H5Gcreate2(parent, path.c_str(), links, properties, H5P_DEFAULT),
                    "cannot make group " + path);
    }
    return Handle(H5Gopen2(parent, path.c_str(), H5P_DEFAULT), "no group " + path);
  }

  bool exists(const hid_t parent, const std::string &path)
  {
    for (std::size_t end = path.find('/', 1); true; end = path.find('/', end + 1))
    {
      if (H5Lexists(parent, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
        return false;
      if (end == std::string::npos)
        return true;
    }
  }

  std::vector<std::string> members(const hid_t parent, const std::string &group)
  {
    std::vector<std::string> names;
    if (!exists(parent, group))
      return names;
    const Handle handle = open_group(parent, group);
    check(H5Literate(
              handle, H5_INDEX_NAME, H5_ITER_INC, nullptr,
              [](hid_t, const char *name, const H5L_info_t *, void *list) -> herr_t
              {
                static_cast<std::vector<std::string> *>(list)->emplace_back(name);
                return 0;
              },
              &names),
          "members of " + group);
    return names;
  }

  std::vector<std::string> numbered(const hid_t parent, const std::string &group)
  {
    std::vector<std::string> paths;
    for (std::size_t k = 0; exists(parent, group + "/" + std::to_string(k)); ++k)
      paths.push_back(group + "/" + std::to_string(k));
    return paths;
  }

  void remove(const hid_t parent, const std::string &path)
  {
    check(H5Ldelete(parent, path.c_str(), H5P_DEFAULT), "cannot remove " + path);
  }

  template <class T>
  void write(const hid_t parent, const std::string &name, const std::vector<T> &values,
             const Shape &shape)
  {
    if (count(shape) != values.size())
      throw std::invalid_argument("dataset " + name + ": " + std::to_string(values.size()) +
                                  " values do not fill its shape");
    const Handle space(H5Screate_simple(int(shape.size()), shape.data(), nullptr), name);
    const Handle properties = creation_properties();
    if (values.size() > 4096)
    {
      const Shape chunk = chunk_of(shape, sizeof(T));
      check(H5Pset_chunk(properties, int(chunk.size()), chunk.data()), name);
      check(H5Pset_shuffle(properties), name);
      if (H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0)
        check(H5Pset_deflate(properties, 1), name);
    }
    Handle dataset(H5Dcreate2(parent, name.c_str(), memory_type<T>(), space, H5P_DEFAULT,
                              properties, H5P_DEFAULT),
                   "cannot make dataset " + name);
    if (!values.empty())
      check(H5Dwrite(dataset, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "cannot write dataset " + name);
    dataset.close("cannot write dataset " + name);
  }

  template <class T>
  std::vector<T> read(const hid_t parent, const std::string &name, Shape *const shape)
  {
    const Handle dataset(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), "no dataset " + name);
    const Shape extents = shape_of(dataset, name);
    std::vector<T> values(count(extents));
    if (!values.empty())
      check(H5Dread(dataset, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "cannot read dataset " + name);
    if (shape != nullptr)
      *shape = extents;
    return values;
  }

  template void write(hid_t, const std::string &, const std::vector<double> &, const Shape &);
  template void write(hid_t, const std::string &, const std::vector<float> &, const Shape &);
  template void write(hid_t, const std::string &, const std::vector<int> &, const Shape &);
  template void write(hid_t, const std::string &, const std::vector<unsigned char> &,
                      const Shape &);
  template std::vector<double> read(hid_t, const std::string &, Shape *);
  template std::vector<float> read(hid_t, const std::string &, Shape *);
  template std::vector<int> read(hid_t, const std::string &, Shape *);
  template std::vector<unsigned char> read(hid_t, const std::string &, Shape *);

  void create_rows(const hid_t parent, const std::string &name, const Shape &row)
  {
    Shape extents{0}, limits{H5S_UNLIMITED}, planned{8192};
    for (const hsize_t extent : row)
    {
      extents.push_back(extent);
      limits.push_back(extent);
      planned.push_back(extent);
    }
    const Shape chunk = chunk_of(planned, sizeof(double));
    const Handle space(H5Screate_simple(int(extents.size()), extents.data(), limits.data()), name);
    const Handle properties = creation_properties();
    check(H5Pset_chunk(properties, int(chunk.size()), chunk.data()), name);
    const Handle dataset(H5Dcreate2(parent, name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT,
                                    properties, H5P_DEFAULT),
                         "cannot make dataset " + name);
  }

  void append_rows(const hid_t parent, const std::string &name, const std::vector<double> &values)
  {
    if (values.empty())
      return;
    Handle dataset(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), "no dataset " + name);
    Shape extents = shape_of(dataset, name), start(extents.size(), 0), added = extents;
    added[0] = 1;
    added[0] = values.size() / count(added);
    start[0] = extents[0];
    extents[0] += added[0];
    check(H5Dset_extent(dataset, extents.data()), "cannot extend dataset " + name);
    const Handle in_file(H5Dget_space(dataset), name);
    check(
        H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), nullptr, added.data(), nullptr),
        name);
    const Handle in_memory(H5Screate_simple(int(added.size()), added.data(), nullptr), name);
    check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, in_memory, in_file, H5P_DEFAULT, values.data()),
          "cannot append to dataset " + name);
    dataset.close("cannot append to dataset " + name);
  }

  void truncate_rows(const hid_t parent, const std::string &name, const hsize_t rows)
  {
    Handle dataset(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), "no dataset " + name);
    Shape extents = shape_of(dataset, name);
    extents[0] = std::min(extents[0], rows);
    check(H5Dset_extent(dataset, extents.data()), "cannot shorten dataset " + name);
    dataset.close("cannot shorten dataset " + name);
  }
} // namespace record::hdf5
