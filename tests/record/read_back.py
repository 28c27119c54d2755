#!/usr/bin/python3
"""Read what record::Writer wrote with programs that others wrote: h5py, meshio, an XML parser."""

import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

try:
    import h5py
    import meshio
    import numpy
except ImportError as missing:
    print(f"SKIPPED: {missing}; install python3-h5py and python3-meshio, run with /usr/bin/python3")
    sys.exit(77)

WRITE_SAMPLES = sys.argv.pop(1) if len(sys.argv) > 1 else "write_samples"


class Written(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        subprocess.run([WRITE_SAMPLES, str(cls.folder)], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_every_dataset_named_in_the_xml_exists_with_its_extents(self):
        root = ElementTree.parse(self.folder / "all.xdmf").getroot()
        items = root.findall(".//DataItem")
        # 12 times: (x, y, phi) + (connectivity, vertex, field) twice
        self.assertEqual(len(items), 12 * 9)
        for item in items:
            name, path = item.text.split(":")
            with h5py.File(self.folder / name) as file:
                extents = tuple(int(word) for word in item.get("Dimensions").split())
                self.assertEqual(file[path].shape, extents, path)
                self.assertEqual(file[path].dtype.itemsize, int(item.get("Precision")), path)

    def test_each_probe_is_a_collection_with_its_true_times(self):
        root = ElementTree.parse(self.folder / "all.xdmf").getroot()
        collections = root.findall("./Domain/Grid")
        self.assertEqual([c.get("Name") for c in collections], ["cloud", "fields & more", "mesh"])
        for collection in collections:
            times = [float(grid.find("Time").get("Value")) for grid in collection]
            self.assertEqual(times, [0.1 * k for k in range(12)])

    def test_grid_axes_and_fields_agree(self):
        root = ElementTree.parse(self.folder / "all.xdmf").getroot()
        grid = root.findall("./Domain/Grid[@Name='fields & more']/Grid")[3]
        self.assertEqual(grid.find("Topology").get("Dimensions"), "3 4")
        with h5py.File(self.folder / "all.h5") as file:
            x, y = (file[i.text.split(":")[1]][:] for i in grid.findall("Geometry/DataItem"))
            phi = file[grid.find("Attribute/DataItem").text.split(":")[1]][:]
        expected = 0.1 * 3 + x[None, :] + 10.0 * y[:, None]
        numpy.testing.assert_allclose(phi, expected, rtol=1e-14)

    def test_meshio_reads_quadrilaterals(self):
        with meshio.xdmf.TimeSeriesReader(self.folder / "cells.xdmf") as reader:
            points, cells = reader.read_points_cells()
            self.assertEqual(reader.num_steps, 12)
            time, _, data = reader.read_data(11)
        self.assertEqual(points.shape, (6, 2))
        self.assertEqual(cells[0].type, "quad")
        self.assertEqual(cells[0].data.tolist(), [[0, 1, 2, 3], [1, 4, 5, 2]])
        self.assertEqual(time, 0.1 * 11)
        self.assertEqual(data["von_mises"][0][0], 7.0 + 0.1 * 11)
        self.assertTrue(numpy.isnan(data["von_mises"][0][1]))

    def test_meshio_reads_point_clouds(self):
        with meshio.xdmf.TimeSeriesReader(self.folder / "points.xdmf") as reader:
            points, cells = reader.read_points_cells()
            _, data, _ = reader.read_data(2)
        self.assertEqual(points.tolist(), [[0.0, 0.0], [1.0, 1.0], [2.0, 4.0]])
        self.assertEqual(cells[0].type, "vertex")
        self.assertEqual(data["plastic_strain"].tolist(), [0.0, 0.1, 0.2])

    def test_h5py_sees_the_documented_layout(self):
        with h5py.File(self.folder / "all.h5") as file:
            self.assertEqual(file.attrs["format"], "mpm_pf record 1")
            self.assertEqual(file.attrs["status"], "complete")
            self.assertEqual(file["provenance/scene"].asstr()[()], 'title = "Samples"\n')
            self.assertEqual(list(file["tables/energy"].attrs["columns"]), ["kinetic"])
            self.assertEqual(file["tables/energy/values"].shape, (12, 1))
            self.assertEqual(file["lines/line/position"].shape, (12, 2, 2))
            self.assertEqual(file["lines/line/values"].shape, (12, 2, 1))
            self.assertEqual(file["outlines/contour/11/offset"][:].tolist(), [0, 3, 6])
            self.assertEqual(file["profile"].attrs["steps"], 12)
            self.assertEqual(file["profile/part"].asstr()[0], "solve")


if __name__ == "__main__":
    unittest.main()
