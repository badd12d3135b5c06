"""Opens the sample run of field_samples.hpp with each XDMF reader of ParaView and checks what it
sees: times, cells, arrays and the moving membrane. Usage: pvpython THIS /absolute/path/run.xmf"""
import sys

from paraview import servermanager, simple

readers = {"XDMFReader": "FileNames", "Xdmf3ReaderS": "FileName", "Xdmf3ReaderT": "FileName"}
times = [0.0, 0.001, 0.002]
nx, ny, dx, origin = 5, 3, 0.5, (-1.0, 0.25)


def leaves(data):
    """The grids of a collection, however deep the reader nests them."""
    if not data.IsA("vtkCompositeDataSet"):
        return [data]
    iterator = data.NewIterator()
    iterator.UnRegister(None)
    found = []
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        found.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return found


def same(found, expected, what):
    tolerance = 1e-12 * max(1.0, *(abs(e) for e in expected)) if expected else 0
    if len(found) != len(expected) or any(abs(f - e) > tolerance for f, e in zip(found, expected)):
        raise SystemExit(f"{what}: {found} where {expected} was written")


def values(array):
    return [x for k in range(array.GetNumberOfTuples()) for x in array.GetTuple(k)]


def check_fluid(fluid, dump):
    b = fluid.GetBounds()
    same(b[:4], [origin[0], origin[0] + nx * dx, origin[1], origin[1] + ny * dx], "extent")
    cells = fluid.GetCellData()
    ij = [(i, j) for j in range(ny) for i in range(nx)]
    same(values(cells.GetArray("pressure")), [100 * dump + 10 * j + i for i, j in ij], "pressure")
    u = [c for i, j in ij for c in (i, -2 * j, 0)]
    same(values(cells.GetArray("velocity")), u, "velocity")
    same(values(cells.GetArray("density")), [998.25] * len(ij), "density")
    same(values(cells.GetArray("label")), [i - 2 for i, j in ij], "label")


def check_line(line, nodes):
    found = [c for k in range(line.GetNumberOfPoints()) for c in line.GetPoint(k)]
    same(found, [c for node in nodes for c in (*node, 0)], "nodes")
    cell = line.GetCell(0)
    if line.GetNumberOfCells() != 1 or cell.GetNumberOfPoints() != len(nodes):
        raise SystemExit("the membrane is not one line through its nodes")


def check(name, path):
    reader = getattr(simple, name)(**{readers[name]: [path]})
    reader.UpdatePipelineInformation()
    same(list(reader.TimestepValues), times, "times")
    for dump, time in enumerate(times):
        reader.UpdatePipeline(time)
        found = leaves(servermanager.Fetch(reader))
        # The readers put the grids of a collection in different orders.
        face, membrane, fluid = sorted(found, key=lambda grid: grid.GetNumberOfPoints())
        check_fluid(fluid, dump)
        x = 0.5 * dump
        check_line(membrane, [(x, 0.25), (x, 0.75), (x + 0.1, 1.25), (x, 1.75)])
        same(values(membrane.GetPointData().GetArray("thickness")), [1e-4, 2e-4, 3e-4, 4e-4],
             "thickness")
        check_line(face, [(x + 0.2, 0.25), (x + 0.2, 1.75)])
    simple.Delete(reader)


present = [name for name in readers if hasattr(simple, name)]
if not present:
    raise SystemExit("this ParaView has no XDMF reader")
for name in present:
    check(name, sys.argv[1])
    print(f"{name}: {len(times)} times, fluid and membrane as written", flush=True)
