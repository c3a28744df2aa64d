# Prints what ParaView reads from a file: one line per array component, "point|cell NAME COMPONENT MIN MAX", and "count points N",
# "count cells N", "count times N". With a second file name, also writes a picture of the deformed body.
#     pvpython read_in_paraview.py FILE [PICTURE.png]
import sys
from paraview import servermanager, simple

reader = simple.OpenDataFile(sys.argv[1])
reader.UpdatePipeline()
times = list(getattr(reader, "TimestepValues", None) or [])
if times:
    reader.UpdatePipeline(times[-1])
data = servermanager.Fetch(reader)
print("count points", data.GetNumberOfPoints())
print("count cells", data.GetNumberOfCells())
print("count times", len(times))
for place, attributes in (("point", data.GetPointData()), ("cell", data.GetCellData())):
    for i in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(i)
        for component in range(array.GetNumberOfComponents()):
            least, largest = array.GetRange(component)
            print(place, array.GetName(), component, repr(least), repr(largest))
if len(sys.argv) > 2:
    view = simple.CreateView("RenderView")
    view.ViewSize = [320, 240]
    if times:
        view.ViewTime = times[-1]
    warped = simple.WarpByVector(Input=reader)
    warped.Vectors = ["POINTS", "displacement_m"]
    display = simple.Show(warped, view)
    simple.ColorBy(display, ("POINTS", "principal_stretches", "0"))
    simple.ResetCamera(view)
    simple.SaveScreenshot(sys.argv[2], view)
