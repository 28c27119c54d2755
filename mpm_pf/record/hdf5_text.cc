// Text datasets and attributes of hdf5_file.h: variable-length UTF-8 strings, which h5py and
// h5dump show as plain text.
#include "record/hdf5_file.h"

#include <limits>
#include <stdexcept>

namespace record::hdf5
{
  namespace
  {
    Handle text_type()
    {
      Handle type(H5Tcopy(H5T_C_S1), "HDF5 text type");
      check(H5Tset_size(type, H5T_VARIABLE), "HDF5 text type");
      check(H5Tset_cset(type, H5T_CSET_UTF8), "HDF5 text type");
      return type;
    }

    Handle space_of(const std::size_t count, const bool scalar)
    {
      const hsize_t extent = count;
      return Handle(scalar ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &extent, nullptr),
                    "HDF5 data space");
    }

    std::vector<const char *> pointers(const std::vector<std::string> &texts)
    {
      std::vector<const char *> list;
      for (const std::string &text : texts)
        list.push_back(text.c_str());
      return list;
    }

    /// Takes over what HDF5 allocated for variable-length strings of one read.
    std::vector<std::string> collect(std::vector<char *> &raw, const hid_t type, const hid_t space)
    {
      std::vector<std::string> texts;
      for (const char *text : raw)
        texts.emplace_back(text == nullptr ? "" : text);
      H5Dvlen_reclaim(type, space, H5P_DEFAULT, raw.data());
      return texts;
    }

    /// Replaces an attribute of the same name.
    Handle new_attribute(const hid_t object, const std::string &name, const hid_t type,
                         const hid_t space)
    {
      if (has_attribute(object, name))
        check(H5Adelete(object, name.c_str()), "attribute " + name);
      return Handle(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                    "cannot make attribute " + name);
    }

    void set_texts(const hid_t object, const std::string &name,
                   const std::vector<std::string> &texts, const bool scalar)
    {
      const Handle type = text_type(), space = space_of(texts.size(), scalar);
      const Handle attribute = new_attribute(object, name, type, space);
      if (!texts.empty())
        check(H5Awrite(attribute, type, pointers(texts).data()), "attribute " + name);
    }

    void set_numbers(const hid_t object, const std::string &name, const std::vector<double> &values,
                     const bool scalar)
    {
      const Handle space = space_of(values.size(), scalar);
      const Handle attribute = new_attribute(object, name, H5T_NATIVE_DOUBLE, space);
      if (!values.empty())
        check(H5Awrite(attribute, H5T_NATIVE_DOUBLE, values.data()), "attribute " + name);
    }

    void put_texts(const hid_t parent, const std::string &name,
                   const std::vector<std::string> &texts, const bool scalar)
    {
      const Handle type = text_type(), space = space_of(texts.size(), scalar);
      const Handle properties(H5Pcreate(H5P_DATASET_CREATE), name);
      check(H5Pset_obj_track_times(properties, false), name);
      Handle dataset(
          H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
          "cannot make dataset " + name);
      if (!texts.empty())
        check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers(texts).data()),
              "dataset " + name);
      dataset.close("dataset " + name);
    }
  } // namespace

  void write_text(const hid_t parent, const std::string &name, const std::string &text)
  {
    put_texts(parent, name, {text}, true);
  }

  void write_texts(const hid_t parent, const std::string &name,
                   const std::vector<std::string> &texts)
  {
    put_texts(parent, name, texts, false);
  }

  std::vector<std::string> read_texts(const hid_t parent, const std::string &name)
  {
    const Handle dataset(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), "no dataset " + name);
    const Handle space(H5Dget_space(dataset), name), type = text_type();
    std::vector<char *> raw(H5Sget_simple_extent_npoints(space), nullptr);
    if (!raw.empty())
      check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, raw.data()), "dataset " + name);
    return collect(raw, type, space);
  }

  std::string read_text(const hid_t parent, const std::string &name)
  {
    return read_texts(parent, name).at(0);
  }

  void set_attribute(const hid_t object, const std::string &name, const std::string &text)
  {
    set_texts(object, name, {text}, true);
  }
  void set_attribute(const hid_t object, const std::string &name,
                     const std::vector<std::string> &texts)
  {
    set_texts(object, name, texts, false);
  }
  void set_attribute(const hid_t object, const std::string &name, const std::vector<double> &values)
  {
    set_numbers(object, name, values, false);
  }
  void set_attribute(const hid_t object, const std::string &name, const double value)
  {
    set_numbers(object, name, {value}, true);
  }

  bool has_attribute(const hid_t object, const std::string &name)
  {
    return H5Aexists(object, name.c_str()) > 0;
  }

  bool attribute_is_text(const hid_t object, const std::string &name)
  {
    const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), "no attribute " + name);
    const Handle type(H5Aget_type(attribute), name);
    return H5Tget_class(type) == H5T_STRING;
  }

  std::vector<std::string> attributes(const hid_t object)
  {
    std::vector<std::string> names;
    hsize_t start = 0;
    check(H5Aiterate2(
              object, H5_INDEX_NAME, H5_ITER_INC, &start,
              [](hid_t, const char *name, const H5A_info_t *, void *list) -> herr_t
              {
                static_cast<std::vector<std::string> *>(list)->emplace_back(name);
                return 0;
              },
              &names),
          "list of attributes");
    return names;
  }

  std::vector<std::string> texts_attribute(const hid_t object, const std::string &name)
  {
    const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), "no attribute " + name);
    const Handle space(H5Aget_space(attribute), name), type = text_type();
    std::vector<char *> raw(H5Sget_simple_extent_npoints(space), nullptr);
    if (!raw.empty())
      check(H5Aread(attribute, type, raw.data()), "attribute " + name);
    return collect(raw, type, space);
  }

  std::string text_attribute(const hid_t object, const std::string &name)
  {
    return has_attribute(object, name) && attribute_is_text(object, name)
               ? texts_attribute(object, name).at(0)
               : "";
  }

  std::vector<double> numbers_attribute(const hid_t object, const std::string &name)
  {
    const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), "no attribute " + name);
    const Handle space(H5Aget_space(attribute), name);
    std::vector<double> values(H5Sget_simple_extent_npoints(space));
    if (!values.empty())
      check(H5Aread(attribute, H5T_NATIVE_DOUBLE, values.data()), "attribute " + name);
    return values;
  }

  double number_attribute(const hid_t object, const std::string &name)
  {
    return has_attribute(object, name) && !attribute_is_text(object, name)
               ? numbers_attribute(object, name).at(0)
               : std::numeric_limits<double>::quiet_NaN();
  }
} // namespace record::hdf5
