// The XDMF file beside a record: lets ParaView and meshio open its snapshots with their true times.
//
// One temporal collection per snapshot probe. Grids are written as 2DRectMesh with explicit x and
// y coordinates, not as 2DCoRectMesh, because programs disagree about the order (x, y or y, x) in
// which a 2D origin and spacing are given. A record of one snapshot probe is also read by meshio.
#pragma once

#include <string>

#include "record/hdf5_file.h"

namespace record
{
  /// Describe the snapshots of the open record `file`, which will be called `h5_name`, in the XML
  /// file `path`. Throws std::runtime_error if it cannot be written.
  void write_xdmf(hid_t file, const std::string &h5_name, const std::string &path);
} // namespace record
