#include "record/hdf5_file.h"

#include <stdexcept>
#include <utility>

#include "record/cannot_write.h"

namespace record::hdf5
{
  namespace
  {
    /// After a write that failed, as on a full disk, the library's own tidying up at the program's
    /// end crashes on what it could not close. All is closed by handles, so it is not needed. Asked
    /// before anything else, and opened before MPI is, whose end would tidy up as well.
    [[maybe_unused]] const herr_t no_tidying_up = H5dont_atexit() < 0 ? -1 : H5open();

    /// HDF5's own words about its last failure: the innermost entry of its error stack, or what the
    /// system said, if that is in it ("No space left on device").
    std::string last_reason()
    {
      std::string reason = "HDF5 gives no reason";
      H5Ewalk2(
          H5E_DEFAULT, H5E_WALK_DOWNWARD,
          [](unsigned, const H5E_error2_t *entry, void *text) -> herr_t
          {
            if (entry->desc != nullptr && *entry->desc != '\0')
              *static_cast<std::string *>(text) = entry->desc;
            return 0;
          },
          &reason);
      const std::string before = "error message = '";
      const auto begin = reason.find(before);
      const auto end = begin == std::string::npos ? begin : reason.find("'", begin + before.size());
      return end == std::string::npos
                 ? reason
                 : reason.substr(begin + before.size(), end - begin - before.size());
    }
  } // namespace

  void check(const herr_t status, const std::string &doing)
  {
    if (status < 0)
      throw std::runtime_error(doing + ": " + last_reason());
  }

  Handle::Handle(const hid_t id, const std::string &doing) : id(id)
  {
    if (id < 0)
      throw std::runtime_error(doing + ": " + last_reason());
  }

  Handle::Handle(Handle &&other) noexcept : id(std::exchange(other.id, H5I_INVALID_HID)) {}

  Handle::~Handle()
  {
    if (id >= 0)
      H5Idec_ref(id); // every kind of identifier is counted; the last one closes the object
  }

  void Handle::close(const std::string &doing)
  {
    check(H5Idec_ref(std::exchange(id, H5I_INVALID_HID)), doing);
  }

  Handle open_file(const std::string &path, const Mode mode)
  {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // reasons go into exceptions, not onto stderr
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), path);
    // Weak closing would keep the file open behind a forgotten handle; locking would let somebody
    // who looks at a running record stop the run.
    check(H5Pset_fclose_degree(access, H5F_CLOSE_STRONG), path);
    check(H5Pset_file_locking(access, false, true), path);
    if (mode == Mode::create)
      return Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access),
                    "cannot write " + path);
    const unsigned flags = mode == Mode::read ? H5F_ACC_RDONLY : H5F_ACC_RDWR;
    return Handle(H5Fopen(path.c_str(), flags, access), "cannot open " + path);
  }

  Handle open_to_resume(const std::string &path, const Mode mode)
  {
    try
    {
      return open_file(path, mode);
    }
    catch (const std::runtime_error &error)
    {
      throw std::runtime_error(error.what() + std::string("; start without --resume"));
    }
  }

  std::string cannot_write(const std::string &path, const std::string &why)
  {
    return "cannot write all of " + path + " (is the disk full?): " + why;
  }

  void write_file(Handle file, const std::string &path,
                  const std::function<void(hid_t file)> &write)
  {
    try
    {
      write(file);
      check(H5Fflush(file, H5F_SCOPE_LOCAL), "flush");
      file.close("close");
    }
    catch (const std::runtime_error &error)
    {
      throw CannotWrite(cannot_write(path, error.what()));
    }
  }
} // namespace record::hdf5
