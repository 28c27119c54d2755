#include "record/xdmf.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace record
{
  namespace
  {
    std::string escaped(const std::string &text)
    {
      std::string xml;
      for (const char letter : text)
        switch (letter)
        {
        case '&':
          xml += "&amp;";
          break;
        case '<':
          xml += "&lt;";
          break;
        case '"':
          xml += "&quot;";
          break;
        default:
          xml += letter;
        }
      return xml;
    }

    /// Extents of a dataset as XDMF writes them, slowest first.
    std::string dimensions(const hid_t file, const std::string &dataset)
    {
      const hdf5::Handle handle(H5Dopen2(file, dataset.c_str(), H5P_DEFAULT), dataset);
      const hdf5::Handle space(H5Dget_space(handle), dataset);
      hdf5::Shape shape(H5Sget_simple_extent_ndims(space));
      H5Sget_simple_extent_dims(space, shape.data(), nullptr);
      std::string text;
      for (const hsize_t extent : shape)
        text += (text.empty() ? "" : " ") + std::to_string(extent);
      return text;
    }

    struct Document
    {
      hid_t file;
      std::string h5_name;
      std::ostringstream xml;

      void item(const std::string &dataset, const bool integer = false)
      {
        xml << "          <DataItem Dimensions=\"" << dimensions(file, dataset)
            << "\" NumberType=\"" << (integer ? "Int\" Precision=\"4" : "Float\" Precision=\"8")
            << "\" Format=\"HDF\">" << escaped(h5_name + ":/" + dataset) << "</DataItem>\n";
      }

      void rectangular_mesh(const std::string &path)
      {
        xml << "        <Topology TopologyType=\"2DRectMesh\" Dimensions=\""
            << dimensions(file, path + "/y") << ' ' << dimensions(file, path + "/x") << "\"/>\n"
            << "        <Geometry GeometryType=\"VXVY\">\n";
        item(path + "/x");
        item(path + "/y");
        xml << "        </Geometry>\n";
      }

      void free_mesh(const std::string &path, const bool points)
      {
        const std::string size = dimensions(file, path + "/connectivity");
        xml << "        <Topology TopologyType=\""
            << (points ? "Polyvertex\" NodesPerElement=\"1" : "Quadrilateral")
            << "\" NumberOfElements=\"" << size.substr(0, size.find(' ')) << "\">\n";
        item(path + "/connectivity", true);
        xml << "        </Topology>\n        <Geometry GeometryType=\"XY\">\n";
        item(path + "/vertex");
        xml << "        </Geometry>\n";
      }

      void snapshot(const std::string &name, const std::string &path)
      {
        const hdf5::Handle group = hdf5::open_group(file, path);
        const std::string kind = hdf5::text_attribute(group, "kind");
        xml << "      <Grid Name=\"" << escaped(name) << "\" GridType=\"Uniform\">\n"
            << "        <Time Value=\"" << hdf5::number_attribute(group, "time") << "\"/>\n";
        if (kind == "grid")
          rectangular_mesh(path);
        else
          free_mesh(path, kind == "points");
        const bool nodal = kind != "cells";
        for (const std::string &field : hdf5::members(file, path + "/fields"))
        {
          xml << "        <Attribute Name=\"" << escaped(field)
              << "\" AttributeType=\"Scalar\" Center=\"" << (nodal ? "Node" : "Cell") << "\">\n";
          item(path + "/fields/" + field);
          xml << "        </Attribute>\n";
        }
        xml << "      </Grid>\n";
      }
    };
  } // namespace

  void write_xdmf(const hid_t file, const std::string &h5_name, const std::string &path)
  {
    Document document{file, h5_name, {}};
    document.xml.precision(17);
    document.xml << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n";
    for (const std::string &name : hdf5::members(file, "snapshots"))
    {
      document.xml << "    <Grid Name=\"" << escaped(name)
                   << "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
      for (const std::string &snapshot : hdf5::numbered(file, "snapshots/" + name))
        document.snapshot(name, snapshot);
      document.xml << "    </Grid>\n";
    }
    document.xml << "  </Domain>\n</Xdmf>\n";
    std::ofstream out(path, std::ios::binary);
    out << document.xml.str();
    if (!out.flush())
      throw std::runtime_error("cannot write " + path);
  }
} // namespace record
