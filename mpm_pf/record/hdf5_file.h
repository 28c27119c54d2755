// A thin RAII layer over the HDF5 C API: handles that close themselves, errors that are exceptions.
//
// Private to this room: no other room includes hdf5.h. The parallel (openmpi) flavour is taken
// because deal.II links it and two flavours in one process do not mix; files are nevertheless
// opened by one process with the serial driver. Handles live only while something is read or
// written, so that between two flushes the file on disk is whole and may be looked at. HDF5 keeps
// back what is written until a dataset or the file is closed: what was written is closed by
// close() and write_file(), which tell of a full disk, and not by a destructor, which cannot.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <hdf5.h>

namespace record::hdf5
{
  /// Owner of one HDF5 identifier of any kind.
  class Handle
  {
  public:
    /// Throws std::runtime_error("<doing>: <HDF5's own reason>") if `id` is negative.
    Handle(hid_t id, const std::string &doing);
    Handle(Handle &&) noexcept;
    Handle(const Handle &) = delete;
    Handle &operator=(const Handle &) = delete;
    Handle &operator=(Handle &&) = delete;
    ~Handle(); // closes
    /// Close now. Throws std::runtime_error("<doing>: <HDF5's own reason>") if something is lost.
    void close(const std::string &doing);
    operator hid_t() const { return id; }

  private:
    hid_t id;
  };

  /// Throws std::runtime_error("<doing>: <HDF5's own reason>") if `status` is negative.
  void check(herr_t status, const std::string &doing);

  enum class Mode
  {
    read,
    modify,
    create // replaces what is there
  };
  /// Open a file. Throws std::runtime_error naming the path and HDF5's reason.
  Handle open_file(const std::string &path, Mode);
  /// The same of what an interrupted run left: the error says how to begin anew.
  Handle open_to_resume(const std::string &path, Mode);
  /// Let `write` write into the file opened from `path`, and close it. Throws CannotWrite naming
  /// the path if not all of it got there; the file on disk is then broken.
  void write_file(Handle, const std::string &path, const std::function<void(hid_t file)> &write);
  std::string cannot_write(const std::string &path, const std::string &why); // what it throws

  /// The group `path` under `parent`; made, with its parents, if `create` says so.
  Handle open_group(hid_t parent, const std::string &path, bool create = false);
  bool exists(hid_t parent, const std::string &path); // every part of the path is looked up
  std::vector<std::string> members(hid_t parent, const std::string &group); // [] if there is none
  /// Full paths group/0, group/1 ... as far as they go.
  std::vector<std::string> numbered(hid_t parent, const std::string &group);
  void remove(hid_t parent, const std::string &path);

  using Shape = std::vector<hsize_t>;

  /// Write a whole dataset of `shape`, row-major; T is double, float, int, unsigned char. Large
  /// ones are shuffled and deflated at the fastest level.
  template <class T>
  void write(hid_t parent, const std::string &name, const std::vector<T> &values,
             const Shape &shape);
  template <class T>
  void write(hid_t parent, const std::string &name, const std::vector<T> &values)
  {
    write(parent, name, values, Shape{values.size()});
  }
  /// Read a whole dataset, and its shape if asked.
  template <class T>
  std::vector<T> read(hid_t parent, const std::string &name, Shape *shape = nullptr);

  /// Datasets of doubles whose first extent grows: one row has the extents `row`.
  void create_rows(hid_t parent, const std::string &name, const Shape &row);
  void append_rows(hid_t parent, const std::string &name, const std::vector<double> &values);
  void truncate_rows(hid_t parent, const std::string &name, hsize_t count); // forget all after them

  void write_text(hid_t parent, const std::string &name, const std::string &);
  void write_texts(hid_t parent, const std::string &name, const std::vector<std::string> &);
  std::string read_text(hid_t parent, const std::string &name);
  std::vector<std::string> read_texts(hid_t parent, const std::string &name);

  void set_attribute(hid_t object, const std::string &name, const std::string &);
  void set_attribute(hid_t object, const std::string &name, const std::vector<std::string> &);
  void set_attribute(hid_t object, const std::string &name, const std::vector<double> &);
  void set_attribute(hid_t object, const std::string &name, double);
  bool has_attribute(hid_t object, const std::string &name);
  bool attribute_is_text(hid_t object, const std::string &name);
  std::vector<std::string> attributes(hid_t object);
  std::string text_attribute(hid_t object, const std::string &name);
  std::vector<std::string> texts_attribute(hid_t object, const std::string &name);
  std::vector<double> numbers_attribute(hid_t object, const std::string &name);
  double number_attribute(hid_t object, const std::string &name);
} // namespace record::hdf5
